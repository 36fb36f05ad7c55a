#pragma once
// Vectors as wide as the lanes that are in use: where few are, narrow ones take down to half the time of the widest.
// The bits are the same.

#include <coif/instruction_set.h>

#include <cstdint>

namespace coif {

inline constexpr std::uint32_t kWidths = 3;  ///< Up to 4, 8 and 16 lanes.
[[nodiscard]] constexpr std::uint32_t width_for(std::uint32_t lanes) { return lanes <= 4 ? 0 : lanes <= 8 ? 1 : 2; }
[[nodiscard]] constexpr std::uint32_t lanes_of(std::uint32_t width) { return 4u << width; }

/// The narrowest instruction set for each width that holds it in one vector, or else `widest`: of those that this build
/// and this processor have.
struct WidthSets {
  explicit WidthSets(InstructionSet widest) {
    using enum InstructionSet;
    set[2] = widest;
    set[1] = widest == kAvx512 ? narrowed(widest, kAvx2) : widest;
    set[0] = widest == kAvx512 || widest == kAvx2 ? narrowed(set[1], kSse4) : widest;
  }

  InstructionSet set[kWidths];

 private:
  static InstructionSet narrowed(InstructionSet set, InstructionSet narrower) {
    return can_run(narrower) ? narrower : set;
  }
};

}  // namespace coif
