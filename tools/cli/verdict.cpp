#include "cli/verdict.h"

#include "cli/json_text.h"

#include <fmt/format.h>

namespace coif {
namespace {

using nlohmann::ordered_json;

ordered_json issue_list(const std::vector<Issue>& issues) {
  auto list = ordered_json::array();
  for (const Issue& issue : issues) {
    list.push_back(
        {{"code", issue.code}, {"severity", name(issue.severity)}, {"message", issue.message}, {"where", issue.where}});
  }
  return list;
}

ordered_json folded_list(const std::vector<FoldedIssues>& folded) {
  auto list = ordered_json::array();
  for (const FoldedIssues& more : folded) {
    list.push_back({{"code", more.code}, {"severity", name(more.severity)}, {"count", more.count}});
  }
  return list;
}

}  // namespace

const char* verdict_word(const Verdict& verdict) {
  if (!verdict.readable) return "unreadable";
  return verdict.issues.valid() ? "valid" : "invalid";
}

std::string verdicts_json(const std::vector<Verdict>& verdicts) {
  auto files = ordered_json::array();
  for (const Verdict& verdict : verdicts) {
    const JudgedIssues& issues = verdict.issues;
    files.push_back({{"path", verdict.path},
                     {"valid", issues.valid()},
                     {"errors", issues.errors},
                     {"warnings", issues.warnings},
                     {"infos", issues.infos},
                     {"issues", issue_list(issues.shown)},
                     {"folded", folded_list(issues.folded)}});
  }
  return json_text({{"files", std::move(files)}});
}

std::string verdicts_text(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const Verdict& verdict : verdicts) {
    text += fmt::format("{}: {}\n", verdict.path, verdict_word(verdict));
  }
  return text;
}

}  // namespace coif
