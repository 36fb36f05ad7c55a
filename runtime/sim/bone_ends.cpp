// The ends of bones. A file of its own, since games that draw by matrices never ask for them.

#include <coif/hair.h>

#include "float_environment.h"
#include "vector_math.h"
#include "world_heads.h"

namespace coif {

Status HairWorld::bone_ends(WorldHead head, std::span<Vec3> ends) const {
  const WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  const Asset& asset = world_->worn_by(*worn).asset;
  const auto bones = asset.bones();
  if (ends.size() != bones.size()) return Status::kSizeMismatch;
  for (std::size_t i = 0; i < bones.size(); ++i) ends[i] = to_vec3(bones[i].joint);
  const FloatEnvironment plain;
  const Quat rotation = lane(worn->block->heads.rotation, worn->lane);
  const std::span<const Mat34> palette = world_->palette(*worn);
  for_each_chain(*world_, head.index, [&](const Solver& solver, std::uint32_t c, const ChainLane& lane) {
    const ChainRecord& chain = asset.chains()[c];
    solver.tails(lane, rotation, palette.subspan(chain.first_bone, chain.bone_count),
                 ends.subspan(chain.first_bone, chain.bone_count));
  });
  return Status::kOk;
}

}  // namespace coif
