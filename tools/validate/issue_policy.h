#pragma once

#include "validate/issue.h"

#include <cstddef>

namespace coif {

/// Which issues count and which are shown.
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
  std::vector<Issue> shown;
  std::vector<FoldedIssues> folded;
  std::size_t errors = 0;  ///< Shown, folded or below the lowest severity; never ignored ones.
  std::size_t warnings = 0;
  std::size_t infos = 0;

  [[nodiscard]] bool valid() const { return errors == 0; }
};

/// False for an error, which no build should let pass, and for what is no code.
[[nodiscard]] bool may_ignore(std::string_view code);

[[nodiscard]] JudgedIssues judge(std::vector<Issue> issues, const IssuePolicy& policy);

}  // namespace coif
