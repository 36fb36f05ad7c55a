#pragma once
// A bone of a linked chain on one head: plain numbers, and the lanes' code for them.

#include "row.h"

#include <coif/math.h>

#include <cstdint>

namespace coif {

/// World axes; the hair's metres from the head's position, and velocities relative to the head's.
struct HeldBone {
  Vec3 free_end, free_velocity;  ///< The particle as the row's step left it.
  Vec3 free_swing;               ///< Angular velocity across the direction, rad/s, as the row's step left it.
  Vec3 start, start_velocity;
  Vec3 direction, velocity;  ///< Unit; velocity of the particle relative to the start.
  Vec3 end, end_velocity;
  Vec3 frame[3];        ///< Columns: from rest, head space. Valid only where the chain was moved.
  Vec3 turning;         ///< Angular velocity, rad/s. Valid only where the chain was moved.
  Vec3 turning_change;  ///< What links have added to `turning`.
  float length = 0;
  float mobility = 0;  ///< LinkedBone::mobility; 0 for a bone that is rigid in this step.
  bool is_turned = false;
  bool is_forced = false;  ///< A collider or limit stood between it and its neighbour.
};

/// One lane of a row.
struct LinkedLane {
  const RowStep* row = nullptr;
  std::uint32_t lane = 0;
  bool is_cascade = false;  ///< The state is CoifState, else PassiveState.
};

/// The lanes' code for one bone at a time. `parent` is null for a bone that hangs from the head.
struct LinkedBoneCode {
  LimitFunction* keep_in_limit = nullptr;  ///< For LinkedLane::row, with one lane.
  /// The joint of a first bone, and its velocity.
  void (*hang)(const LinkedLane& at, std::uint32_t i, HeldBone& bone) = nullptr;
  /// Whether the bone is rigid to its parent in this step.
  bool (*is_rigid)(const LinkedLane& at, std::uint32_t i) = nullptr;
  /// Moves a bone whose parent is not where the row's step had it. `start` and `start_velocity` must be set.
  void (*follow)(const LinkedLane& at, std::uint32_t i, const HeldBone& parent, HeldBone& bone) = nullptr;
  /// Turns the bone out of colliders and back into its limits, and removes the velocity that leads there.
  void (*clear)(const LinkedLane& at, std::uint32_t i, const HeldBone* parent, HeldBone& bone) = nullptr;
  /// Sets the frame, the part of the row's state that depends on it, and the matrix.
  void (*finish)(const LinkedLane& at, std::uint32_t i, const HeldBone* parent, HeldBone& bone) = nullptr;
};

extern const LinkedBoneCode kLinkedBones, kLinkedCharacterBones;

}  // namespace coif
