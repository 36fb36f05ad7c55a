#pragma once
// From an instruction set to the code that was compiled for it. For the end, under HWY_ONCE, of a file that
// foreach_target.h compiles several times.

#include <coif/instruction_set.h>

#include <hwy/highway.h>

#if HWY_TARGETS != HWY_STATIC_TARGET
#define COIF_SINGLY(function) &HWY_STATIC_DISPATCH(function##_singly)
#elif HWY_STATIC_TARGET == HWY_SCALAR
#define COIF_SINGLY(function) &HWY_STATIC_DISPATCH(function)
#else
#define COIF_SINGLY(function) nullptr
#endif

/// Defines name(set): a pointer to that instruction set's `function`, or null where this build has none. `function` takes
/// as many lanes as there are, `function`_singly one.
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
