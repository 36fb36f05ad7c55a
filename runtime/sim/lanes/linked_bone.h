#pragma once
// A bone of a chain that links hold, on one head: plain numbers, and what the lanes' code makes of them.

#include "row.h"

#include <coif/math.h>

#include <cstdint>

namespace coif {

/// World axes; metres of the hair from the head's position, and velocities against the head's.
struct HeldBone {
  Vec3 free_end, free_velocity;  ///< Of the particle, as the row's step left it.
  Vec3 free_swing;               ///< Angular velocity across the direction, rad/s, likewise.
  Vec3 start, start_velocity;
  Vec3 direction, velocity;  ///< Unit; of the particle against the start.
  Vec3 end, end_velocity;
  Vec3 frame[3];        ///< Columns: from rest, head space. Only where the chain was moved.
  Vec3 turning;         ///< Angular velocity, rad/s; likewise.
  Vec3 turning_change;  ///< What links have added to that.
  float length = 0;
  float mobility = 0;  ///< LinkedBone::mobility; 0 for a bone that is rigid just now.
  bool is_turned = false;
  bool is_forced = false;  ///< Something stood between it and its neighbour.
};

/// Of one lane of a row.
struct LinkedLane {
  const RowStep* row = nullptr;
  std::uint32_t lane = 0;
  bool is_cascade = false;  ///< CoifState, else PassiveState.
};

/// What the lanes' code does for one bone at a time; `parent` is null for one that hangs from the head.
struct LinkedBoneCode {
  LimitFunction* keep_in_limit = nullptr;  ///< For LinkedLane::row, of one lane.
  /// The joint of a first bone, and its velocity.
  void (*hang)(const LinkedLane& at, std::uint32_t i, HeldBone& bone) = nullptr;
  /// Whether it is rigid to its parent just now.
  bool (*is_rigid)(const LinkedLane& at, std::uint32_t i) = nullptr;
  /// What becomes of a bone when its parent is not where the row's step had it. `start` and `start_velocity` are known.
  void (*follow)(const LinkedLane& at, std::uint32_t i, const HeldBone& parent, HeldBone& bone) = nullptr;
  /// Turns it to where its angle limit and the colliders allow it, and takes what leads there from its velocity.
  void (*clear)(const LinkedLane& at, std::uint32_t i, const HeldBone* parent, HeldBone& bone) = nullptr;
  /// Frame, and what its row remembers of it; and its matrix.
  void (*finish)(const LinkedLane& at, std::uint32_t i, const HeldBone* parent, HeldBone& bone) = nullptr;
};

extern const LinkedBoneCode kLinkedBones, kLinkedCharacterBones;

}  // namespace coif
