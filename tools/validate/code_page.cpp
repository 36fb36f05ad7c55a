#include "validate/code_page.h"

#include "validate/issue_codes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coif {
namespace {

constexpr const char* kHead =
    "# Issues of `coif validate`\n\n"
    "Codes are stable. Errors fail a build (exit code 3), warnings do with `--warnings-as-errors`; `--ignore CODE` "
    "lets\n"
    "warnings and notes pass. This page is what `coif validate --list-codes` prints.\n";

}  // namespace

std::string code_page() {
  std::string page = kHead;
  const IssueCode* before = nullptr;
  for (const IssueCode& row : issue_codes()) {
    if (before == nullptr || before->group != row.group) page += fmt::format("\n## {}\n\n", name(row.group));
    page += fmt::format("- **{}** {}: {}. {} {}\n", row.code, name(row.severity), row.title, row.meaning, row.cure);
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
                     {"cure", row.cure}});
  }
  return nlohmann::ordered_json{{"codes", std::move(codes)}}.dump(2) + '\n';
}

}  // namespace coif
