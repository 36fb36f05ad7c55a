#include "validate/issue_codes.h"

#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <tuple>

namespace coif::validate {
namespace {

std::vector<IssueCode> all_codes() {
  std::vector<IssueCode> codes;
  for (const auto part : {refusal_codes(), asset_codes(), origin_codes(), cook_codes()}) {
    codes.insert(codes.end(), part.begin(), part.end());
  }
  std::ranges::sort(codes, {}, [](const IssueCode& row) { return std::tuple(row.group, std::string_view(row.code)); });
  return codes;
}

}  // namespace

const char* name(IssueGroup group) {
  constexpr const char* kNames[kIssueGroups] = {"container", "skeleton", "dynamics", "geometry", "patches",
                                                "orders",    "skin",     "textures", "quality",  "source"};
  return kNames[std::size_t(group)];
}

std::span<const IssueCode> issue_codes() {
  static const std::vector<IssueCode> codes = all_codes();
  return codes;
}

const IssueCode* find_issue_code(std::string_view code) {
  const auto found = std::ranges::find(issue_codes(), code, &IssueCode::code);
  return found == issue_codes().end() ? nullptr : &*found;
}

nlohmann::ordered_json issues_json(const Diagnostics& issues) {
  auto list = nlohmann::ordered_json::array();
  for (const Diagnostic& issue : issues) {
    const IssueCode* row = find_issue_code(issue.code);
    list.push_back(issue);
    list.back()["cure"] = row != nullptr ? row->cure : "";
  }
  return list;
}

Diagnostic make_issue(std::string_view code, std::string message, std::string where) {
  const IssueCode* row = find_issue_code(code);
  assert(row != nullptr && "an issue without a row in its table");
  return {std::string(code), std::move(message), row != nullptr ? row->severity : Severity::kError, std::move(where)};
}

namespace {

constexpr const char* kHead =
    "# Issues of `coif validate`, warnings of `coif cook`\n\n"
    "Codes are stable. Errors fail a build (exit code 3), warnings do with `--warnings-as-errors`; `--ignore CODE` and "
    "the recipe's\n"
    "`\"warnings\": {\"acknowledged\": [...]}` let warnings and notes pass. What a cook repairs is an error of the "
    "file, and a warning of the\n"
    "cook. This page is what `coif validate --list-codes` prints.\n";

}  // namespace

std::string code_page() {
  std::string page = kHead;
  const IssueCode* before = nullptr;
  for (const IssueCode& row : issue_codes()) {
    if (before == nullptr || before->group != row.group) page += fmt::format("\n## {}\n\n", name(row.group));
    page += fmt::format("- **{}** {}{}: {}. {} {}\n", row.code, name(row.severity), row.is_repaired ? ", repaired" : "",
                        row.title, row.meaning, row.cure);
    before = &row;
  }
  return page;
}

std::string code_json() {
  auto codes = nlohmann::ordered_json::array();
  for (const IssueCode& row : issue_codes()) {
    codes.push_back({{"code", row.code},
                     {"group", name(row.group)},
                     {"severity", name(row.severity)},
                     {"title", row.title},
                     {"meaning", row.meaning},
                     {"cure", row.cure},
                     {"repaired", row.is_repaired}});
  }
  return nlohmann::ordered_json{{"codes", std::move(codes)}}.dump(2) + '\n';
}

namespace {

std::size_t& counter(JudgedIssues& judged, Severity severity) {
  switch (severity) {
    case Severity::kInfo: return judged.infos;
    case Severity::kWarning: return judged.warnings;
    case Severity::kError: break;
  }
  return judged.errors;
}

void fold(const Diagnostic& issue, JudgedIssues& judged) {
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
  return row != nullptr && (row->severity != Severity::kError || row->is_repaired);
}

bool is_unsupported(std::string_view code) {
  constexpr std::string_view kCodes[] = {"A104", "A110", "S102"};  // another version, an unknown chunk, another format
  return std::ranges::find(kCodes, code) != std::end(kCodes);
}

JudgedIssues judge(Diagnostics issues, const IssuePolicy& policy) {
  JudgedIssues judged;
  std::map<std::string, std::size_t> shown_of;
  for (Diagnostic& issue : issues) {
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

}  // namespace coif::validate
