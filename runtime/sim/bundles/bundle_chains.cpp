// The numbers of a head's chains in their lanes.

#include "../followed_pose.h"
#include "bundles.h"

namespace coif {
namespace {

/// The list of the head's chains, as its detail asks for it.
struct Lists {
  explicit Lists(const WorldState& world, std::uint32_t index)
      : head(world.heads[index]),
        worn(world.worn_by(head)),
        treatment(head.block->treatment != kIdle ? head.block->treatment : busy_treatment_of(world, index)),
        power(worn.crowd->lists[treatment].treatment.power) {}

  [[nodiscard]] BundleList& of(std::uint32_t chain) const { return worn.shapes[chain]->lists[treatment - 1]; }

  WornHead& head;
  WornAsset& worn;
  std::uint32_t treatment, power;
};

/// Writes the constants of a chain into its lane.
void write_constants(const WornAsset& worn, const ChainShape& shape, const ChainRecord& chain, const ChainPlace& to) {
  const Bundle& bundle = *to.part;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    RowBone unused;
    const std::uint32_t bone = chain.first_bone + i;
    add_bone(worn.asset, bone, to.lane, unused, bundle.constants[i]);
    bundle.constants[i].colliders[to.lane] <<= worn.first_collider;
    if (bundle.body_sets != nullptr) {
      bundle.body_sets[i * kLanes + to.lane] = worn.body_colliders == 0 ? 0 : worn.asset.body_sets()[bone];
    }
    if (bundle.limits == nullptr) continue;
    const bool has_limits = !worn.asset.limits().empty();
    set_limit(has_limits ? worn.asset.limits()[bone] : LimitRecord{}, to.lane, bundle.limits[i]);
  }
  if (shape.solver->complete_lane == nullptr) return;
  shape.solver->complete_lane(shape.bones.first(chain.bone_count), to.lane, bundle.constants);
}

void write_coefficients(const WornAsset& worn, const ChainShape& shape, const ChainRecord& chain,
                        const std::byte* table, const ChainPlace& to) {
  const std::size_t bytes = shape.solver->coefficient_bytes;
  for (std::size_t i = 0; i < chain.bone_count; ++i) {
    const std::uint32_t motion = worn.motion_of[chain.first_bone + i];
    const std::byte* const from = table + motion / kLanes * worn.coefficient_bytes;
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

std::uint32_t table_of(const WorldState& world, const WornHead& head, std::uint32_t power) {
  return head.set * world.rules.intervals + power;
}

/// Gives a lane to a chain of a head; its state must still be written.
void push_chain(WorldState& world, std::uint32_t index, const Lists& lists, std::uint32_t c) {
  const WornAsset& worn = lists.worn;
  ChainShape& shape = *worn.shapes[c];
  const ChainRecord& chain = worn.asset.chains()[c];
  const std::uint32_t version = worn.crowd->versions[lists.power];
  const ChainPlace place = push_lane(world, shape, lists.of(c), chain.bone_count, version);
  Bundle& bundle = *place.part;
  bundle.head[place.lane] = index;
  bundle.chain[place.lane] = c;
  world.places(lists.head)[c] = place;
  write_constants(worn, shape, chain, place);
  const std::uint32_t table = table_of(world, lists.head, lists.power);
  const bool is_known = worn.terms[table].dt != 0.0f;
  if (is_known) write_coefficients(worn, shape, chain, worn.table(table), place);
  if (!is_known) bundle.version = 0;
}

/// Calls visit(lanes, lane, floats, bytes of the lanes) for each array that a head's chains keep.
template <typename Floats, typename Visit>
void for_each_kept(const WorldState& world, const WornHead& head, Floats* kept, const Visit& visit) {
  const WornAsset& worn = world.worn_by(head);
  for (std::uint32_t c = 0; c < worn.shapes.size(); ++c) {
    const ChainPlace& place = world.places(head)[c];
    const std::size_t bones = worn.asset.chains()[c].bone_count;
    const auto pass = [&](void* lanes, std::size_t bytes) {
      visit(lanes, place.lane, kept, bones * bytes);
      kept += bones * bytes / sizeof(Lanes);
    };
    const ShapeKind& kind = worn.shapes[c]->kind;
    pass(place.part->state, worn.shapes[c]->solver->state_bytes);
    if (kind.twists) pass(place.part->twist, sizeof(TwistState));
    if (kind.has_poses) pass(place.part->poses, sizeof(PoseLanes));
  }
}

float* kept_of(const WorldState& world, const WornHead& head) {
  return reinterpret_cast<float*>(head.memory + world.worn_by(head).layout.kept);
}

}  // namespace

void gather_wants(const WorldState& world, const ChainShape& shape, Bundle& bundle) {
  bundle.longest = bones_in(world, bundle, 0);
  for (std::size_t i = 0; i < bundle.longest; ++i) {
    bundle.bones[i] = shape.bones[i];
    bundle.bones[i].fewest_levels = kMaxLods;
  }
  for (std::uint32_t lane = 0; lane < bundle.count; ++lane) {
    const Asset& asset = worn_in(world, bundle, lane).asset;
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

void enter_lanes(WorldState& world, std::uint32_t index) {
  const Lists lists(world, index);
  for (std::uint32_t c = 0; c < lists.worn.shapes.size(); ++c) push_chain(world, index, lists, c);
  for_each_kept(world, lists.head, kept_of(world, lists.head),
                [](void* lanes, std::uint32_t lane, const float* kept, std::size_t bytes) {
                  copy_lane_in(kept, lanes, lane, bytes);
                });
  lists.head.has_lanes = true;
}

void leave_lanes(WorldState& world, std::uint32_t index) {
  const Lists lists(world, index);
  for_each_kept(world, lists.head, kept_of(world, lists.head),
                [](const void* lanes, std::uint32_t lane, float* kept, std::size_t bytes) {
                  copy_lane_out(lanes, lane, kept, bytes);
                });
  for (std::uint32_t c = 0; c < lists.worn.shapes.size(); ++c) {
    const std::uint32_t bones = lists.worn.asset.chains()[c].bone_count;
    pop_lane(world, *lists.worn.shapes[c], lists.of(c), bones, world.places(lists.head)[c]);
  }
  lists.head.has_lanes = false;
}

void renew_coefficients(const WorldState& world, const ChainShape& shape, Bundle& bundle) {
  const std::uint32_t power = bundle.treatment.power, version = shape.crowd->versions[power];
  if (bundle.version == version) return;
  for (std::uint32_t lane = 0; lane < bundle.count; ++lane) {
    const WornHead& head = world.heads[bundle.head[lane]];
    const WornAsset& worn = world.worn_by(head);
    const std::byte* const table = worn.table(table_of(world, head, power));
    write_coefficients(worn, shape, worn.asset.chains()[bundle.chain[lane]], table, {&bundle, lane});
  }
  bundle.version = version;
}

}  // namespace coif
