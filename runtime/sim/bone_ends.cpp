// The ends of bones. A file of its own, since games that draw by matrices never ask for them.

#include <coif/hair.h>

#include "crowd.h"
#include "float_environment.h"
#include "vector_math.h"

namespace coif {

Status Hair::bone_ends(std::uint32_t instance, std::span<Vec3> ends) const {
  const Block* const block = block_of(crowd_, instance);
  if (block == nullptr) return missing(crowd_);
  const auto bones = crowd_->asset.bones();
  if (ends.size() != bones.size()) return Status::kSizeMismatch;
  for (std::size_t i = 0; i < bones.size(); ++i) ends[i] = to_vec3(bones[i].joint);
  const std::uint32_t slot = crowd_->slots[instance];
  const FloatEnvironment plain;
  const Quat rotation = lane(block->heads.rotation, slot % kLanes);
  const std::span<const Mat34> palette = crowd_->palette(instance);
  for_each_chain(*crowd_, slot, [&](const Solver& solver, const ChainRecord& chain, const ChainLane& lane) {
    solver.tails(lane, rotation, palette.subspan(chain.first_bone, chain.bone_count),
                 ends.subspan(chain.first_bone, chain.bone_count));
  });
  return Status::kOk;
}

}  // namespace coif
