#pragma once

#include "base/diagnostic.h"

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::validate {

/// With the severity of `code` in issue_codes(), which must have it.
[[nodiscard]] Diagnostic make_issue(std::string_view code, std::string message, std::string where = "");

/// Appends an issue with a message in the syntax of fmt::format().
template <typename... Args>
void add_issue(Diagnostics& issues, std::string_view code, std::string where, fmt::format_string<Args...> message,
               Args&&... args) {
  issues.push_back(make_issue(code, fmt::format(message, std::forward<Args>(args)...), std::move(where)));
}

// Every code that `coif validate` knows. ISSUES.md is written from this table.
//   F1xx files            R1xx origin of an asset: its source, recipe and tool
//   A1xx refused assets   A100 + the number of the reader's LoadCode
//   A2xx doubtful assets  S10x unusable sources, S11x those that break their format's rules, S2xx doubtful ones
//   C1xx other warnings of a cook

/// The subject of a code.
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
  const char* meaning;  ///< What one sees on screen, or why the file cannot be used.
  const char* cure;
  bool is_repaired = false;  ///< An error that a cook repairs and warns of.
};

[[nodiscard]] const char* name(IssueGroup group);

/// All codes, group by group, ascending within each.
[[nodiscard]] std::span<const IssueCode> issue_codes();

/// Each as {"code", "severity", "message", "where", "cure"}, and "patch" where it is about one.
[[nodiscard]] nlohmann::ordered_json issues_json(const Diagnostics& issues);

/// Null for text that is no code.
[[nodiscard]] const IssueCode* find_issue_code(std::string_view code);

// The parts of issue_codes(), by subject.

[[nodiscard]] std::span<const IssueCode> refusal_codes();  ///< Files and assets that cannot be opened.
[[nodiscard]] std::span<const IssueCode> asset_codes();    ///< Assets that open and yet do badly.
[[nodiscard]] std::span<const IssueCode> origin_codes();   ///< Sources, and whether assets still match theirs.
[[nodiscard]] std::span<const IssueCode> cook_codes();     ///< About a source and its cook.

/// All codes as a page in Markdown, which is readable on a terminal too: ISSUES.md.
[[nodiscard]] std::string code_page();

/// {"codes": [{code, group, severity, title, meaning, cure, repaired}]}
[[nodiscard]] std::string code_json();

/// The issues that count and those that are shown.
struct IssuePolicy {
  Severity lowest = Severity::kInfo;   ///< Less severe ones are not shown; they count all the same.
  std::vector<std::string> ignored{};  ///< Codes that neither count nor are shown. Not for errors: may_ignore().
  bool warnings_as_errors = false;
  std::size_t most_of_a_code = 5;  ///< Shown, > 0; the others of a code are only counted.
};

/// The issues of one code that are not shown because of their number.
struct FoldedIssues {
  std::string code;
  Severity severity = Severity::kInfo;
  std::size_t count = 0;  ///< > 0
};

struct JudgedIssues {
  Diagnostics shown;
  std::vector<FoldedIssues> folded;
  std::size_t errors = 0;  ///< Shown, folded or below the lowest severity; never ignored ones.
  std::size_t warnings = 0;
  std::size_t infos = 0;

  [[nodiscard]] bool valid() const { return errors == 0; }
};

/// False for an error that no cook repairs, which no build should let pass, and for an unknown code.
[[nodiscard]] bool may_ignore(std::string_view code);

/// Whether an error of this code means that this program cannot read the file, not that the file is wrong.
[[nodiscard]] bool is_unsupported(std::string_view code);

[[nodiscard]] JudgedIssues judge(Diagnostics issues, const IssuePolicy& policy);

}  // namespace coif::validate
