#pragma once
// The numbers of a saved state: one float per Lanes member of a lane, in their order.

#include "lanes/lane_layout.h"
#include "vector_math.h"
#include "world_heads.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace coif {

/// Allowed error of a length that the simulation keeps at one.
inline constexpr float kSavedUnitTolerance = 1e-3f;
/// The same for what follows from the frames of a chain: a bone that is nearly folded over its parent multiplies the
/// errors of the frames above it. A chain of nine was off by 1.5e-3.
inline constexpr float kSavedFrameTolerance = 0.02f;

/// Reads values by their byte offsets in the struct of Lanes that was saved; the bytes may lie anywhere.
class SavedLane {
 public:
  explicit SavedLane(const std::byte* from) : from_(from) {}

  [[nodiscard]] float number(std::size_t offset) const {
    float value = 0;
    std::memcpy(&value, from_ + offset / sizeof(Lanes) * sizeof(float), sizeof value);
    return value;
  }
  [[nodiscard]] Vec3 vector(std::size_t offset) const {
    return {number(offset), number(offset + sizeof(Lanes)), number(offset + 2 * sizeof(Lanes))};
  }
  [[nodiscard]] Quat quaternion(std::size_t offset) const {
    const Vec3 axis = vector(offset);
    return {axis.x, axis.y, axis.z, number(offset + sizeof(Lanes3))};
  }
  /// Checks `bytes` bytes of Lanes from `offset` on.
  [[nodiscard]] bool are_finite(std::size_t offset, std::size_t bytes) const {
    for (std::size_t end = offset + bytes; offset < end; offset += sizeof(Lanes)) {
      if (!std::isfinite(number(offset))) return false;
    }
    return true;
  }
  /// Whether they were never written.
  [[nodiscard]] bool are_zero(std::size_t offset, std::size_t bytes) const {
    for (std::size_t end = offset + bytes; offset < end; offset += sizeof(Lanes)) {
      const float value = number(offset), zero = 0;
      if (std::memcmp(&value, &zero, sizeof zero) != 0) return false;
    }
    return true;
  }

 private:
  const std::byte* from_;
};

/// Reads saved numbers one after the other.
class SavedBytes {
 public:
  explicit SavedBytes(std::span<const std::byte> content) : at_(content.data()) {}

  template <typename T>
  T take() {
    T value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  const std::byte* take(std::size_t bytes) {
    const std::byte* const from = at_;
    at_ += bytes;
    return from;
  }
  /// Takes one lane of `bytes` bytes of Lanes.
  SavedLane take_lane(std::size_t bytes) { return SavedLane(take(bytes / sizeof(Lanes) * sizeof(float))); }
  /// Returns false unless the byte is 0 or 1.
  bool take_flag(bool& flag) {
    const auto byte = take<std::uint8_t>();
    flag = byte != 0;
    return byte <= 1;
  }

 private:
  const std::byte* at_;
};

inline bool is_share(float value) { return value >= 0.0f && value <= 1.0f; }

inline bool same_bits(const void* a, const void* b, std::size_t bytes) { return std::memcmp(a, b, bytes) == 0; }

/// False for anything with a NaN or an infinity.
inline bool is_unit_direction(const Vec3& v, float tolerance = kSavedUnitTolerance) {
  return std::fabs(length(v) - 1.0f) <= tolerance;
}

/// Whether the world could have saved this: numbers are finite and in their ranges, rotations are rotations, and all
/// parts agree with each other. `content` must be as long as the world's own. Needs a plain FloatEnvironment.
[[nodiscard]] bool could_be_saved(WorldState& world, std::span<const std::byte> content);

// These three check the hair itself, matrices and chains: saved_chains.cpp.

/// Largest distance of a bone's start from its head's position, metres: all bones in one line. Particles with world
/// places have no such bound.
[[nodiscard]] float farthest_bone_start(const WorldRules& rules, const Asset& asset);

/// Whether these can be one head's matrices. No bone may begin farther away than `farthest`.
[[nodiscard]] bool is_saved_palette(const Asset& asset, float farthest, SavedBytes& bytes);

/// Whether these can be the numbers of its chains.
[[nodiscard]] bool are_saved_chains(WorldState& world, std::uint32_t head, bool is_posed, SavedBytes& bytes);

}  // namespace coif
