#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace coif {

/// What went wrong, for people, and of which class it is. Only tools/cli turns classes into exit codes.
struct ToolError {
  enum class Kind { kUsage, kFileAccess, kBadInput, kOverBudget, kUnsupported, kInternal };
  Kind kind = Kind::kInternal;
  std::string message;  ///< "FILE: what is wrong; cure", without a trailing period or newline.
};

/// Of what the caller asked for.
[[nodiscard]] inline tl::unexpected<ToolError> usage(std::string message) {
  return tl::unexpected(ToolError{ToolError::Kind::kUsage, std::move(message)});
}

}  // namespace coif
