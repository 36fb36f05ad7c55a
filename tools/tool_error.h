#pragma once

#include <string>

namespace coif {

/// What went wrong, for people, and of which class it is. Only tools/cli turns classes into exit codes.
struct ToolError {
  enum class Kind { kUsage, kFileAccess, kBadInput, kOverBudget, kUnsupported, kInternal };
  Kind kind = Kind::kInternal;
  std::string message;  ///< "FILE: what is wrong; cure", without a trailing period or newline.
};

}  // namespace coif
