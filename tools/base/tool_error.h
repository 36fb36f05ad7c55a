#pragma once

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <utility>

namespace coif {

/// What went wrong, for people, and of which class it is. Only tools/cli turns classes into exit codes.
struct ToolError {
  enum class Kind { kUsage, kFileAccess, kBadInput, kOverBudget, kUnsupported, kInternal };
  Kind kind = Kind::kInternal;
  std::string message;  ///< "FILE: what is wrong; cure", without a trailing period or newline.
};

// For functions that return tl::expected.

[[nodiscard]] inline tl::unexpected<ToolError> failure(ToolError::Kind kind, std::string message) {
  return tl::unexpected(ToolError{kind, std::move(message)});
}

/// Of what the caller asked for.
[[nodiscard]] inline tl::unexpected<ToolError> usage(std::string message) {
  return failure(ToolError::Kind::kUsage, std::move(message));
}

/// Of the file at `path`, with which the message begins.
template <class... Args>
[[nodiscard]] tl::unexpected<ToolError> file_failure(ToolError::Kind kind, const std::filesystem::path& path,
                                                     fmt::format_string<Args...> text, Args&&... args) {
  return failure(kind, path.string() + ": " + fmt::format(text, std::forward<Args>(args)...));
}

/// A sentence of what the artist may not have meant, with its code in the table of issues (tools/validate), by which
/// one kind of warning can be acknowledged. Whoever only tells it takes it for the sentence that it is.
struct Warning : std::string {
  Warning() = default;
  Warning(std::string of_code, std::string text) : std::string(std::move(text)), code(std::move(of_code)) {}
  std::string code;  ///< "C144"
};

}  // namespace coif
