#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace coif {

struct ProgramLimits {
  std::chrono::milliseconds patience = std::chrono::seconds(20);  ///< Wall-clock; then the program is killed.
  std::size_t output_bytes = 64 << 20;                            ///< For each of its outputs.
};

struct ProgramResult {
  enum class End {
    kFinished,  ///< Ended by itself; `code` is its exit status.
    kKilled,    ///< `code` is the signal that ended it.
    kTooSlow,
    kTooMuchOutput,
    kNotStarted,  ///< `code` is an errno; ENOENT: no such program.
  };
  End end = End::kNotStarted;
  int code = 0;
  std::string output;    ///< What it wrote to its standard output.
  std::string messages;  ///< And to its standard error.
};

/// Runs a program, found by PATH, without a shell. It reads `input`, can write no file, sees no descriptor and no
/// variable of this process but PATH, and dies with it. Blocks until the program is gone; leaves no zombie.
/// `arguments` begins with the program itself.
[[nodiscard]] ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input,
                                        const ProgramLimits& limits = {});

}  // namespace coif
