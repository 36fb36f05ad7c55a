// Checks that a world could have saved a state, in the order in which saved_state.cpp writes it.
#include "saved_lane.h"

#include "head_lanes.h"
#include "rules.h"
#include "saved_collider.h"
#include "step_settings.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace coif {
namespace {

/// Checks one head's detail. A bool must be 0 or 1.
bool is_detail(const WorldState& world, const Asset& asset, SavedBytes& bytes) {
  std::uint8_t raw[sizeof(HeadDetail)];
  std::memcpy(raw, bytes.take(sizeof raw), sizeof raw);
  return raw[offsetof(HeadDetail, level)] < levels_of(asset) &&
         raw[offsetof(HeadDetail, interval_power)] < world.rules.intervals &&
         raw[offsetof(HeadDetail, asked_power)] < world.rules.intervals && raw[offsetof(HeadDetail, simulated)] <= 1 &&
         raw[offsetof(HeadDetail, asleep)] <= 1;
}

bool are_details(WorldState& world, SavedBytes& bytes) {
  bool are_good = true;
  for_each_head(world, [&](std::uint32_t head) {
    are_good = is_detail(world, world.worn_by(world.heads[head]).asset, bytes) && are_good;
  });
  if (world.rules.sets == 1) return are_good;
  for_each_head(world, [&](std::uint32_t) { are_good = bytes.take<std::uint8_t>() < world.rules.sets && are_good; });
  return are_good;
}

/// Frames with dt = 0 are not among the last ones, and frames before the first step are 0.
bool is_time(SavedBytes& bytes) {
  if (check_settings(bytes.take<StepSettings>()) != Status::kOk) return false;
  bool is_before_first = false;
  for (std::uint32_t i = 0; i < kMaxInterval; ++i) {
    const float dt = bytes.take<float>(), none = 0;
    const bool was_step = dt >= kShortestStep && dt <= std::numeric_limits<float>::max();
    if (!was_step && !same_bits(&dt, &none, sizeof dt)) return false;
    if (was_step && is_before_first) return false;
    is_before_first = !was_step;
  }
  (void)bytes.take<std::uint32_t>();  // Any number of steps is good.
  return true;
}

/// The waves must follow from the gusts that the host set; before any were set they must be zero.
bool are_saved_gusts(SavedBytes& bytes) {
  const auto told = bytes.take<Gusts>();
  const auto way = bytes.take<double>();
  const auto waves = bytes.take<GustWaves>();
  if (!are_gusts(told) || !(way >= 0.0 && std::isfinite(way))) return false;
  const GustWaves own = waves_of(told), none{};
  const Gusts untold;
  const bool is_told = same_bits(&waves, &own, sizeof own);
  return is_told || (same_bits(&told, &untold, sizeof told) && same_bits(&waves, &none, sizeof none));
}

bool is_air(WorldState& world, SavedBytes& bytes) {
  bool is_good = true;
  for (std::uint32_t set = 0; world.rules.sets > 1 && set < world.rules.sets; ++set) {
    is_good = fits(bytes.take<DynamicsScale>()) && is_good;
  }
  if (!world.airs.empty()) {
    for_each_head(world, [&](std::uint32_t) {
      const auto air = bytes.take<HeadAir>();
      is_good = is_good && is_finite(air.wind) && is_share(air.exposure);
    });
  }
  return is_good && (world.gusts.empty() || are_saved_gusts(bytes));
}

/// A head's target, and the pose that the host set.
struct SavedHead {
  SavedLane lanes;
  double next_position[3];
  HeadPose told;
};

/// The head goes to the pose that was set last, or it stands and no pose was set.
bool goes_where_told(const SavedHead& head) {
  std::uint64_t first = 0;
  std::memcpy(&first, &head.told.position[0], sizeof first);
  const bool is_told = head.lanes.number(offsetof(HeadLanes, is_told)) == 1.0f;
  if (is_told && first != kToldVelocity) return false;
  HeadPose pose = head.told, unit;
  if (first == kToldVelocity) pose.position[0] = head.next_position[0];
  if (first == kToldNothing) pose = HeadPose{};
  if (make_unit(pose, unit) != Status::kOk) return false;
  const Quat next = head.lanes.quaternion(offsetof(HeadLanes, next_rotation));
  const float per_scale = 1.0f / unit.scale;
  return same_bits(unit.position, head.next_position, sizeof unit.position) &&
         same_bits(&unit.rotation, &next, sizeof next) &&
         head.lanes.number(offsetof(HeadLanes, per_scale)) == per_scale;
}

bool is_head(const SavedHead& head) {
  const SavedLane& lanes = head.lanes;
  if (!lanes.are_finite(0, offsetof(HeadLanes, next_position)) || !is_finite(head.next_position)) return false;
  const float is_told = lanes.number(offsetof(HeadLanes, is_told));
  if (!(is_told == 0.0f || is_told == 1.0f) || !(lanes.number(offsetof(HeadLanes, last_dt)) >= 0.0f)) return false;
  return is_unit(lanes.quaternion(offsetof(HeadLanes, rotation))) && goes_where_told(head);
}

/// A sleeping head has no motion ahead of it.
bool may_be_asleep(const SavedHead& head) {
  const SavedLane& lanes = head.lanes;
  return lanes.vector(offsetof(HeadLanes, way)) == Vec3{} && lanes.number(offsetof(HeadLanes, is_told)) == 0.0f &&
         lanes.quaternion(offsetof(HeadLanes, rotation)) == lanes.quaternion(offsetof(HeadLanes, next_rotation));
}

/// At a place of the body it must be the asset's collider; at an unused place there must be none.
bool is_told_collider(const WornAsset& worn, std::uint32_t place, const SavedCollider& saved) {
  const SavedCollider none{};
  if ((saved.flags & 1u) == 0) return same_bits(&saved, &none, sizeof none);
  const ToldCollider told = unpacked(saved);
  const SavedCollider again = packed(told);
  if (check(told.now) != Status::kOk || !same_bits(&saved, &again, sizeof again)) return false;
  if (told.has_way && !(is_finite(told.center_before) && is_unit(told.rotation_before))) return false;
  const bool is_of_body = place < worn.body_colliders;
  if (told.is_of_body != is_of_body) return false;
  if (!is_of_body) return !told.keeps_inside;
  const ColliderRecord& record = worn.asset.body_colliders()[place];
  const bool keeps_inside = (record.flags & kColliderKeepsInside) != 0;
  return told.now.shape == record.shape && told.keeps_inside == keeps_inside && !told.now.is_velocity_known;
}

/// The body's colliders are all there or none, and the game's have no gap.
bool are_told_colliders(const WornAsset& worn, SavedBytes& bytes) {
  bool was_there = true;
  for (std::uint32_t place = 0; place < worn.places; ++place) {
    const auto saved = bytes.take<SavedCollider>();
    if (!is_told_collider(worn, place, saved)) return false;
    const bool is_there = (saved.flags & 1u) != 0, begins = place == 0 || place == worn.body_colliders;
    if (!begins && is_there && !was_there) return false;
    if (!begins && place < worn.body_colliders && is_there != was_there) return false;
    was_there = is_there;
  }
  return true;
}

bool is_saved_head(WorldState& world, std::uint32_t index, bool is_asleep, SavedBytes& bytes) {
  const WornAsset& worn = world.worn_by(world.heads[index]);
  SavedHead head{bytes.take_lane(offsetof(HeadLanes, next_position)), {}, {}};
  for (double& metres : head.next_position) metres = bytes.take<double>();
  bool teleports = false, is_lost = false, may_sleep = false, is_posed = false;
  if (!bytes.take_flag(teleports) || !bytes.take_flag(is_lost) || !bytes.take_flag(may_sleep)) return false;
  head.told = bytes.take<HeadPose>();
  if (!is_head(head) || may_sleep) return false;  // Heads that may sleep fall asleep before a step ends.
  if (is_asleep && (teleports || is_lost || !may_be_asleep(head))) return false;
  if (!is_saved_palette(worn.asset, farthest_bone_start(world.rules, worn.asset), bytes)) return false;
  if (!are_told_colliders(worn, bytes)) return false;
  if (world.rules.follows_poses && !bytes.take_flag(is_posed)) return false;
  return are_saved_chains(world, index, is_posed, bytes);
}

}  // namespace

bool could_be_saved(WorldState& world, std::span<const std::byte> content) {
  SavedBytes details(content), bytes(content);
  if (!are_details(world, bytes) || !is_time(bytes) || !is_air(world, bytes)) return false;
  bool are_good = true;
  for_each_head(world, [&](std::uint32_t head) {
    const bool is_asleep = details.take(sizeof(HeadDetail))[offsetof(HeadDetail, asleep)] != std::byte{0};
    are_good = are_good && is_saved_head(world, head, is_asleep, bytes);
  });
  return are_good;
}

}  // namespace coif
