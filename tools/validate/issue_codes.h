#pragma once
// Every code that `coif validate` knows. ISSUES.md is written from this table.
//   F1xx files            R1xx origin of an asset: its source, recipe and tool
//   A1xx refused assets   A100 + the number of the reader's LoadCode
//   A2xx doubtful assets  S1xx unusable sources, S2xx doubtful ones

#include "validate/issue.h"

#include <span>

namespace coif {

/// What a code is about.
enum class IssueGroup {
  kContainer,
  kSkeleton,
  kDynamics,
  kGeometry,
  kPatches,
  kOrders,
  kSkin,
  kTextures,
  kQuality,
  kSource,
};

inline constexpr std::size_t kIssueGroups = 10;

struct IssueCode {
  const char* code;
  IssueGroup group;
  Severity severity;
  const char* title;    ///< A few words.
  const char* meaning;  ///< What is seen on screen, or why the file is no use.
  const char* cure;
};

[[nodiscard]] const char* name(IssueGroup group);

/// All codes, group by group, ascending within each.
[[nodiscard]] std::span<const IssueCode> issue_codes();

/// Null for text that is no code.
[[nodiscard]] const IssueCode* find_issue_code(std::string_view code);

}  // namespace coif
