#include "cli/verdict_page.h"

#include "counted.h"
#include "report/page/html_page.h"
#include "validate/issue_codes.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

CellLook look(Severity severity) {
  switch (severity) {
    case Severity::kInfo: return CellLook::kNeutral;
    case Severity::kWarning: return CellLook::kWarning;
    case Severity::kError: return CellLook::kBad;
  }
  return CellLook::kPlain;
}

std::string meaning(const std::string& code) {
  const IssueCode* row = find_issue_code(code);
  return row == nullptr ? "" : fmt::format("{} {}", row->meaning, row->cure);
}

Table issue_table(const JudgedIssues& issues) {
  using Kind = Column::Kind;
  Table table{{{"Code"}, {"Severity"}, {"Where"}, {"What", Kind::kProse}, {"Meaning and cure", Kind::kProse}}, {}};
  for (const Issue& issue : issues.shown) {
    table.rows.push_back({{issue.code},
                          {name(issue.severity), look(issue.severity)},
                          {issue.where},
                          {issue.message},
                          {meaning(issue.code)}});
  }
  for (const FoldedIssues& more : issues.folded) {
    const std::string what = fmt::format("{} more like this", more.count);
    table.rows.push_back({{more.code}, {name(more.severity), look(more.severity)}, {}, {what}, {}});
  }
  return table;
}

void add_file(const Verdict& verdict, HtmlPage& page) {
  const JudgedIssues& issues = verdict.issues;
  page.heading(verdict.path);
  page.paragraph(fmt::format("{}: {}, {}, {}.", verdict_word(verdict), counted(issues.errors, "error", "errors"),
                             counted(issues.warnings, "warning", "warnings"), counted(issues.infos, "note", "notes")));
  if (!issues.shown.empty()) page.table(issue_table(issues));
  for (const IssuePicture& picture : verdict.pictures.pictures) {
    page.picture(picture.png, fmt::format("Patch {}, in red, from its own side.", picture.patch));
  }
  if (!verdict.pictures.why_none.empty()) page.paragraph("Patches are not drawn: " + verdict.pictures.why_none);
}

}  // namespace

std::string verdict_page(std::span<const Verdict> verdicts) {
  HtmlPage page("coif validate");
  const auto valid = std::ranges::count_if(verdicts, [](const Verdict& v) { return v.issues.valid(); });
  page.summary(fmt::format("{} of {} files are valid.", valid, verdicts.size()));
  for (const Verdict& verdict : verdicts) add_file(verdict, page);
  return page.text();
}

}  // namespace coif
