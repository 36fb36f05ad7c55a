#pragma once
// The code that exists once per instruction set, behind plain functions. Each pointer is null where a build lacks the
// set.

#include "row.h"
#include "step_parts.h"

#include <coif/instruction_set.h>

namespace coif {

/// Steps all lanes of a row.
using RowFunction = void(const RowStep& row);
RowFunction* coif_row_code(InstructionSet set);
RowFunction* thesis_row_code(InstructionSet set);
RowFunction* passive_row_code(InstructionSet set);
RowFunction* character_cascade_code(InstructionSet set);
RowFunction* character_passive_code(InstructionSet set);
LimitFunction* limit_code(InstructionSet set);

/// When a head counts as at rest, and after how long it may sleep.
struct RestWatch {
  float dt = 0;           ///< The length of the step that ends, seconds.
  float still2 = 0;       ///< (m/s)^2. Head and hair are at rest up to this speed.
  float sleep_after = 0;  ///< Seconds.
};

/// Lanes of a block, a bit for each.
struct RestingHeads {
  std::uint32_t may_sleep = 0;
  std::uint32_t flies = 0;  ///< Its hair is faster than light, or a speed of hair or head is not a number.
};

/// Moves the heads of one block through a step, in this order: look_ahead, begin, move for each part, finish. Works on
/// as many vectors as hold the first `lanes` lanes; other lanes stay as they are.
struct HeadCode {
  /// Returns whether some head, perhaps of an unused lane, moves too far for a movement.
  bool (*look_ahead)(const HeadLanes& heads, std::uint32_t lanes, const StepParts& parts,
                     HeadStepLanes& step) = nullptr;
  void (*begin)(HeadLanes& heads, std::uint32_t lanes, const StepParts& parts, HeadStepLanes& step) = nullptr;
  /// `move` holds the last part's values on entry. Returns in `carried` the rotation of the hair before the part, where
  /// parts.inertia is below 1.
  void (*move)(const HeadLanes& heads, std::uint32_t lanes, const HeadStepLanes& step, const StepParts& parts,
               std::uint32_t part, MoveLanes& move, Lanes4& carried) = nullptr;
  /// `motion`: the squared speed of each head's tips, (m/s)^2.
  RestingHeads (*finish)(HeadLanes& heads, std::uint32_t lanes, const HeadStepLanes& step, const Lanes& motion,
                         const RestWatch& watch) = nullptr;
  /// Copies one head's lane to all sixteen, for a head whose chains fill rows alone.
  void (*spread)(const MoveLanes& from, std::uint32_t lane, MoveLanes& to) = nullptr;
};
HeadCode head_code(InstructionSet set);

}  // namespace coif

#ifdef HWY_TARGETS
// Chooses the code that was compiled for an instruction set. For the end, under HWY_ONCE, of a file that
// foreach_target.h compiles several times.
#if HWY_TARGETS != HWY_STATIC_TARGET
#define COIF_SINGLY(function) &HWY_STATIC_DISPATCH(function##_singly)
#elif HWY_STATIC_TARGET == HWY_SCALAR
#define COIF_SINGLY(function) &HWY_STATIC_DISPATCH(function)
#else
#define COIF_SINGLY(function) nullptr
#endif

/// Defines name(set): a pointer to that instruction set's `function`, or null where this build lacks it. `function`
/// takes as many lanes as there are, `function`_singly one.
#define COIF_CHOOSE(name, function)                                                                              \
  decltype(&HWY_STATIC_DISPATCH(function)) name(InstructionSet set) {                                            \
    switch (set) {                                                                                               \
      case InstructionSet::kScalar: return COIF_SINGLY(function);                                                \
      case InstructionSet::kPortable: return HWY_TARGETS & HWY_EMU128 ? HWY_CHOOSE_FALLBACK(function) : nullptr; \
      case InstructionSet::kSse4: return HWY_CHOOSE_SSE4(function);                                              \
      case InstructionSet::kAvx2: return HWY_CHOOSE_AVX2(function);                                              \
      case InstructionSet::kAvx512: return HWY_CHOOSE_AVX3(function);                                            \
      case InstructionSet::kNeon: return HWY_CHOOSE_NEON(function);                                              \
      case InstructionSet::kWasm: return HWY_CHOOSE_WASM(function);                                              \
      case InstructionSet::kBest: break;                                                                         \
    }                                                                                                            \
    return nullptr;                                                                                              \
  }
#endif
