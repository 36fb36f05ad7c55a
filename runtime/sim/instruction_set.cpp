#include <coif/instruction_set.h>

#include <hwy/highway.h>

namespace coif {
namespace {

struct Known {
  InstructionSet set;
  std::int64_t target;  ///< Highway's bit.
  const char* name;
};

/// The widest first.
constexpr Known kKnown[] = {
    {InstructionSet::kAvx512, HWY_AVX3, "AVX-512"}, {InstructionSet::kAvx2, HWY_AVX2, "AVX2"},
    {InstructionSet::kSse4, HWY_SSE4, "SSE4"},      {InstructionSet::kNeon, HWY_NEON, "NEON"},
    {InstructionSet::kWasm, HWY_WASM, "WASM"},      {InstructionSet::kPortable, HWY_EMU128, "portable"},
};

/// A build for one instruction set has no scalar path.
constexpr bool kHasScalar = HWY_TARGETS != HWY_STATIC_TARGET || HWY_STATIC_TARGET == HWY_SCALAR;

/// Bits of the sets that this build has and the processor supports.
std::int64_t available() {
#if HWY_TARGETS == HWY_STATIC_TARGET
  return HWY_TARGETS;  // The compiler was told that the processor has it.
#else
  return (hwy::SupportedTargets() | HWY_EMU128) & HWY_TARGETS;  // The portable code runs anywhere.
#endif
}

}  // namespace

InstructionSet best_instruction_set() {
  const std::int64_t targets = available();
  for (const Known& known : kKnown) {
    if ((known.target & targets) != 0) return known.set;
  }
  return InstructionSet::kScalar;
}

bool can_run(InstructionSet set) {
  if (set == InstructionSet::kBest) return true;
  if (set == InstructionSet::kScalar) return kHasScalar;
  const std::int64_t targets = available();
  for (const Known& known : kKnown) {
    if (known.set == set) return (known.target & targets) != 0;
  }
  return false;
}

const char* name_of(InstructionSet set) {
  for (const Known& known : kKnown) {
    if (known.set == set) return known.name;
  }
  return set == InstructionSet::kScalar ? "scalar" : "best";
}

}  // namespace coif
