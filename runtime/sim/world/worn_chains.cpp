#include "world.h"

namespace coif {
namespace {

const Asset& asset_in(const WorldState& world, const Bundle& bundle, std::uint32_t lane) {
  return world.assets[world.heads[bundle.head[lane]].asset].asset;
}

/// Writes the constants of a chain into its lane.
void write_constants(const WornAsset& worn, const ChainShape& shape, const ChainRecord& chain, const ChainPlace& to) {
  const Bundle& bundle = *to.part;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    RowBone unused;
    const std::uint32_t bone = chain.first_bone + i;
    add_bone(worn.asset, bone, to.lane, unused, bundle.constants[i]);
    bundle.constants[i].colliders[to.lane] <<= worn.first_collider;
    if (bundle.limits == nullptr) continue;
    const bool has_limits = !worn.asset.limits().empty();
    set_limit(has_limits ? worn.asset.limits()[bone] : LimitRecord{}, to.lane, bundle.limits[i]);
  }
  if (shape.solver->complete_lane == nullptr) return;
  shape.solver->complete_lane(shape.bones.first(chain.bone_count), to.lane, bundle.constants);
}

void write_coefficients(const WornAsset& worn, const ChainShape& shape, const ChainRecord& chain,
                        const ChainPlace& to) {
  const std::size_t bytes = shape.solver->coefficient_bytes;
  for (std::size_t i = 0; i < chain.bone_count; ++i) {
    const std::uint32_t motion = worn.motion_of[chain.first_bone + i];
    const std::byte* const from = worn.coefficients + motion / kLanes * worn.coefficient_bytes;
    copy_lane(from, motion % kLanes, to.part->coefficients + i * bytes, to.lane, bytes);
  }
}

/// Adds the features that a lane's own bones need.
void add_wants(const Asset& asset, const ChainRecord& chain, std::uint32_t lane, Bundle& bundle) {
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    RowBone& wanted = bundle.bones[i];
    const BoneLanes& constants = bundle.constants[i];
    const auto levels = std::uint8_t(constants.levels[lane]);
    const std::uint32_t bone = chain.first_bone + i;
    wanted.features |= features_of(asset.bones()[bone], asset.dynamics()[bone]);
    wanted.colliders |= constants.colliders[lane];
    if (levels < wanted.fewest_levels) wanted.fewest_levels = levels;
    if (levels > wanted.most_levels) wanted.most_levels = levels;
    wanted.lanes = std::uint8_t(lane + 1);
  }
}

}  // namespace

std::uint32_t bones_in(const WorldState& world, const Bundle& bundle, std::uint32_t lane) {
  return asset_in(world, bundle, lane).chains()[bundle.chain[lane]].bone_count;
}

void gather_wants(const WorldState& world, const ChainShape& shape, Bundle& bundle) {
  bundle.longest = bones_in(world, bundle, 0);
  for (std::size_t i = 0; i < bundle.longest; ++i) {
    bundle.bones[i] = shape.bones[i];
    bundle.bones[i].fewest_levels = kMaxLods;
  }
  for (std::uint32_t lane = 0; lane < bundle.count; ++lane) {
    const Asset& asset = asset_in(world, bundle, lane);
    add_wants(asset, asset.chains()[bundle.chain[lane]], lane, bundle);
  }
  RowBone& last = bundle.bones[bundle.longest - 1];
  last.features &= ~std::uint32_t(kRowHasChildren);
  last.children = 0;
  for (std::size_t i = 0; i < bundle.longest; ++i) {
    RowBone& bone = bundle.bones[i];
    if (bone.colliders == 0) bone.features &= ~std::uint32_t(kRowCollides);
    const bool have_ended = bone.lanes < bundle.count;
    if (have_ended || (i + 1 < bundle.longest && bundle.bones[i + 1].lanes < bone.lanes)) bone.features |= kRowEnds;
    if (have_ended) bone.fewest_levels = 0;
  }
  bundle.is_loose = bundle.has_all_bones = false;
}

void push_chain(WorldState& world, std::uint32_t head, std::uint32_t chain) {
  WornHead& worn_head = world.heads[head];
  const WornAsset& worn = world.assets[worn_head.asset];
  ChainShape& shape = *worn.shapes[chain];
  const ChainRecord& record = worn.asset.chains()[chain];
  const ChainPlace place = push_lane(world, shape, record.bone_count);
  Bundle& bundle = *place.part;
  bundle.head[place.lane] = head;
  bundle.chain[place.lane] = chain;
  worn_head.places[chain] = place;
  write_constants(worn, shape, record, place);
  const bool is_known = worn.version == shape.pace->version && shape.pace->version != 0;
  if (is_known) write_coefficients(worn, shape, record, place);
  if (!is_known) bundle.version = 0;
  shape.solver->put_to_rest(chain_lane(shape, place, record.bone_count), Quat{});
}

void pop_chain(WorldState& world, std::uint32_t head, std::uint32_t chain) {
  WornHead& worn_head = world.heads[head];
  const WornAsset& worn = world.assets[worn_head.asset];
  pop_lane(world, *worn.shapes[chain], worn.asset.chains()[chain].bone_count, worn_head.places[chain]);
}

void renew_coefficients(const WorldState& world, const ChainShape& shape, Bundle& bundle) {
  if (bundle.version == shape.pace->version) return;
  for (std::uint32_t lane = 0; lane < bundle.count; ++lane) {
    const WornAsset& worn = world.assets[world.heads[bundle.head[lane]].asset];
    write_coefficients(worn, shape, worn.asset.chains()[bundle.chain[lane]], {&bundle, lane});
  }
  bundle.version = shape.pace->version;
}

}  // namespace coif
