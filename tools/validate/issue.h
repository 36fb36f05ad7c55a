#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

enum class Severity { kInfo, kWarning, kError };

/// One finding about a source or an asset. Codes are stable: a build may let some pass by number. issue_codes.h holds all.
struct Issue {
  std::string code;
  Severity severity = Severity::kError;
  std::string message;
  std::string where;                     ///< Chunk, record, bone or patch; empty: the whole file.
  std::optional<std::uint32_t> patch{};  ///< Of all of the asset's, where the issue is one of a patch.
};

[[nodiscard]] const char* name(Severity severity);

/// With the severity that issue_codes() gives `code`, which must be one of them.
[[nodiscard]] Issue make_issue(std::string_view code, std::string message, std::string where = "");

}  // namespace coif
