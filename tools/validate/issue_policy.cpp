#include "validate/issue_policy.h"

#include "validate/issue_codes.h"

#include <algorithm>
#include <map>

namespace coif {
namespace {

std::size_t& counter(JudgedIssues& judged, Severity severity) {
  switch (severity) {
    case Severity::kInfo: return judged.infos;
    case Severity::kWarning: return judged.warnings;
    case Severity::kError: break;
  }
  return judged.errors;
}

void fold(const Issue& issue, JudgedIssues& judged) {
  const auto found = std::ranges::find(judged.folded, issue.code, &FoldedIssues::code);
  if (found != judged.folded.end()) {
    ++found->count;
  } else {
    judged.folded.push_back({issue.code, issue.severity, 1});
  }
}

}  // namespace

bool may_ignore(std::string_view code) {
  const IssueCode* row = find_issue_code(code);
  return row != nullptr && row->severity != Severity::kError;
}

JudgedIssues judge(std::vector<Issue> issues, const IssuePolicy& policy) {
  JudgedIssues judged;
  std::map<std::string, std::size_t> shown_of;
  for (Issue& issue : issues) {
    if (std::ranges::find(policy.ignored, issue.code) != policy.ignored.end()) continue;
    if (policy.warnings_as_errors && issue.severity == Severity::kWarning) issue.severity = Severity::kError;
    ++counter(judged, issue.severity);
    if (issue.severity < policy.lowest) continue;
    if (shown_of[issue.code]++ < policy.most_of_a_code) {
      judged.shown.push_back(std::move(issue));
    } else {
      fold(issue, judged);
    }
  }
  return judged;
}

}  // namespace coif
