#include "bundles.h"

namespace coif {
namespace {

bool join(WorldState& world, WornAsset& worn) {
  number_motions(world.rules, worn);
  return join_shapes(world, worn);
}

/// Removes the first `chains` of a head's chains from their shapes' members.
void remove_some(WorldState& world, WornAsset& worn, std::size_t chains) {
  for (std::size_t c = 0; c < chains; ++c) remove_member(world, *worn.shapes[c]);
}

void remove_members(WorldState& world, WornAsset& worn) { remove_some(world, worn, worn.shapes.size()); }

bool add_members(WorldState& world, WornAsset& worn) {
  for (std::size_t c = 0; c < worn.shapes.size(); ++c) {
    if (add_member(world, *worn.shapes[c])) continue;
    remove_some(world, worn, c);
    return false;
  }
  return true;
}

/// Whoever visits may write, so what lanes lack beside its bones is filled anew before the next step.
void visit_lanes(WorldState& world, std::uint32_t index, const ChainVisit& visit) {
  const WornHead& head = world.heads[index];
  const WornAsset& worn = world.worn_by(head);
  const bool has_lanes = head.has_lanes;
  if (!has_lanes) enter_lanes(world, index);
  for (std::uint32_t c = 0; c < worn.shapes.size(); ++c) {
    const ChainPlace& place = world.places(head)[c];
    place.part->has_all_bones = false;
    visit(*worn.shapes[c]->solver, c, chain_lane(*worn.shapes[c], place, worn.asset.chains()[c].bone_count));
  }
  if (!has_lanes) leave_lanes(world, index);
}

float motion(const WorldState& world, const WornHead& head) {
  const std::size_t chains = world.worn_by(head).shapes.size();
  const ChainPlace* const places = world.places(head);
  float sum = 0;
  for (std::size_t c = 0; c < chains; ++c) sum += places[c].part->motion.v[places[c].lane];
  return sum;
}

}  // namespace

const SharedCode kSharedCode{.bytes_of_chains = &bytes_of_chains,
                             .kept_floats = &kept_floats,
                             .carve = &carve_motions,
                             .join = &join,
                             .leave = &leave_shapes,
                             .add_members = &add_members,
                             .remove_members = &remove_members,
                             .enter = &enter_lanes,
                             .leave_lanes = &leave_lanes,
                             .visit = &visit_lanes,
                             .set_coefficients = &set_motions,
                             .share_out = &share_out,
                             .run = &run_bundles,
                             .motion = &motion};

}  // namespace coif
