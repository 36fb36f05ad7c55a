#include "cli/verdict.h"

#include "cli/json_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {

const char* name(Severity severity) {
  switch (severity) {
    case Severity::kInfo: return "info";
    case Severity::kWarning: return "warning";
    case Severity::kError: return "error";
  }
  return "error";
}

bool Verdict::valid() const {
  return std::none_of(issues.begin(), issues.end(), [](const Issue& i) { return i.severity == Severity::kError; });
}

std::string verdicts_json(const std::vector<Verdict>& verdicts) {
  auto files = nlohmann::ordered_json::array();
  for (const Verdict& verdict : verdicts) {
    auto issues = nlohmann::ordered_json::array();
    for (const Issue& issue : verdict.issues) {
      issues.push_back({{"code", issue.code},
                        {"severity", name(issue.severity)},
                        {"message", issue.message},
                        {"where", issue.where}});
    }
    files.push_back({{"path", verdict.path}, {"valid", verdict.valid()}, {"issues", std::move(issues)}});
  }
  return json_text({{"files", std::move(files)}});
}

std::string verdicts_text(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const Verdict& verdict : verdicts) {
    const char* word = !verdict.readable ? "unreadable" : verdict.valid() ? "valid" : "invalid";
    text += fmt::format("{}: {}\n", verdict.path, word);
  }
  return text;
}

}  // namespace coif
