#pragma once

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <utility>

namespace coif {

/// An error for people, and its class. Only tools/cli turns classes into exit codes.
struct ToolError {
  enum class Kind { kUsage, kFileAccess, kBadInput, kOverBudget, kUnsupported, kInternal };
  Kind kind = Kind::kInternal;
  std::string message;  ///< "FILE: what is wrong; cure", without a trailing period or newline.
};

// Helpers for functions that return tl::expected.

[[nodiscard]] inline tl::unexpected<ToolError> failure(ToolError::Kind kind, std::string message) {
  return tl::unexpected(ToolError{kind, std::move(message)});
}

/// An error in the caller's request.
[[nodiscard]] inline tl::unexpected<ToolError> usage(std::string message) {
  return failure(ToolError::Kind::kUsage, std::move(message));
}

/// An error in the file at `path`; the message begins with the path.
template <class... Args>
[[nodiscard]] tl::unexpected<ToolError> file_failure(ToolError::Kind kind, const std::filesystem::path& path,
                                                     fmt::format_string<Args...> text, Args&&... args) {
  return failure(kind, path.string() + ": " + fmt::format(text, std::forward<Args>(args)...));
}

}  // namespace coif
