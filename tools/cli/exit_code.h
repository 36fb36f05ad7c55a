#pragma once

#include "tool_error.h"

#include <span>
#include <string>

namespace coif {

/// What the program tells the shell. An interface: build scripts depend on the numbers.
enum class Exit : int {
  kOk = 0,
  kUsage = 1,        ///< The command line is wrong.
  kFileAccess = 2,   ///< A file cannot be opened, read or written.
  kBadInput = 3,     ///< A source, recipe or asset is not usable.
  kOverBudget = 4,   ///< The result exceeds a budget that was asked for.
  kUnsupported = 5,  ///< A file format or version, or this machine, cannot do it.
  kInternal = 70,    ///< A bug in this program, or no memory left.
};

[[nodiscard]] Exit exit_code(ToolError::Kind kind);

struct ExitMeaning {
  Exit code;
  const char* name;     ///< A word or two.
  const char* meaning;  ///< A sentence.
};

/// Every exit code, ascending.
[[nodiscard]] std::span<const ExitMeaning> exit_meanings();

/// Codes and names, for --help.
[[nodiscard]] std::string exit_code_help();

}  // namespace coif
