#pragma once

#include <coif/export.h>

#include <cstdint>

namespace coif {

/// The instructions that the simulation runs on. Every set gives the same bits.
enum class InstructionSet : std::uint8_t {
  kBest = 0,      ///< The widest that this build has and this processor supports.
  kScalar = 1,    ///< One chain at a time; for comparison.
  kPortable = 2,  ///< Four lanes in plain C++, for processors without any of the following.
  kSse4 = 3,
  kAvx2 = 4,
  kAvx512 = 5,
  kNeon = 6,
  kWasm = 7,
};

/// The widest that this build has and this processor supports; never kBest.
[[nodiscard]] COIF_API InstructionSet best_instruction_set();

/// False for a set that is not in this build or that this processor lacks.
[[nodiscard]] COIF_API bool can_run(InstructionSet set);

/// For logs and reports: "AVX2". Static storage, never null.
[[nodiscard]] COIF_API const char* name_of(InstructionSet set);

}  // namespace coif
