#pragma once
// One lane of numbers as a saved state has them: a float for each Lanes, in their order.

#include "lanes/lane_layout.h"
#include "vector_math.h"

#include <cmath>
#include <cstddef>
#include <cstring>

namespace coif {

/// By how much the length of what the simulation keeps at one may be off.
inline constexpr float kSavedUnitTolerance = 1e-3f;

/// Reads by byte offsets into the struct of Lanes that was saved; the bytes may lie anywhere.
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
  /// Of the numbers of `bytes` bytes of Lanes from `offset` on.
  [[nodiscard]] bool are_finite(std::size_t offset, std::size_t bytes) const {
    for (std::size_t end = offset + bytes; offset < end; offset += sizeof(Lanes)) {
      if (!std::isfinite(number(offset))) return false;
    }
    return true;
  }
  /// Whether they are what was never written.
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

/// False for anything with a NaN or an infinity.
inline bool is_unit_direction(const Vec3& v) { return std::fabs(length(v) - 1.0f) <= kSavedUnitTolerance; }

}  // namespace coif
