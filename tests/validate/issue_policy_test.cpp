#include "validate/issue_policy.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

/// One error, two warnings of one code, three notes of two codes.
std::vector<Issue> some_issues() {
  return {make_issue("R101", "error"),     make_issue("A203", "warning", "1"), make_issue("A203", "warning", "2"),
          make_issue("A207", "note", "1"), make_issue("A207", "note", "2"),    make_issue("A204", "note")};
}

TEST(IssuePolicy, ShowsAndCountsEverythingUnasked) {
  const JudgedIssues judged = judge(some_issues(), {});
  EXPECT_EQ(judged.shown.size(), 6u);
  EXPECT_TRUE(judged.folded.empty());
  EXPECT_EQ(judged.errors, 1u);
  EXPECT_EQ(judged.warnings, 2u);
  EXPECT_EQ(judged.infos, 3u);
  EXPECT_FALSE(judged.valid());
}

TEST(IssuePolicy, HiddenIssuesCount) {
  const JudgedIssues judged = judge(some_issues(), {.lowest = Severity::kError});
  EXPECT_EQ(judged.shown.size(), 1u);
  EXPECT_TRUE(judged.folded.empty()) << "what is not shown is not folded";
  EXPECT_EQ(judged.warnings, 2u);
  EXPECT_FALSE(judge({make_issue("A203", "")}, {.lowest = Severity::kError, .warnings_as_errors = true}).valid());
}

TEST(IssuePolicy, IgnoredIssuesDoNotCount) {
  const JudgedIssues judged = judge(some_issues(), {.ignored = {"A203", "A204"}});
  EXPECT_EQ(judged.warnings, 0u);
  EXPECT_EQ(judged.infos, 2u);
  EXPECT_EQ(judged.shown.size(), 3u);
}

TEST(IssuePolicy, WarningsBecomeErrorsAndNotesDoNot) {
  const JudgedIssues judged = judge({make_issue("A203", ""), make_issue("A207", "")}, {.warnings_as_errors = true});
  EXPECT_EQ(judged.shown[0].severity, Severity::kError);
  EXPECT_EQ(judged.shown[1].severity, Severity::kInfo);
  EXPECT_FALSE(judged.valid());
  EXPECT_TRUE(judge({make_issue("A203", "")}, {.ignored = {"A203"}, .warnings_as_errors = true}).valid());
}

TEST(IssuePolicy, FoldsEqualCodesAboveTheLimit) {
  std::vector<Issue> issues(36, make_issue("A203", "dark"));
  issues.push_back(make_issue("A204", "card"));
  const JudgedIssues judged = judge(issues, {.most_of_a_code = 2});
  EXPECT_EQ(judged.shown.size(), 3u);
  ASSERT_EQ(judged.folded.size(), 1u);
  EXPECT_EQ(judged.folded[0].code, "A203");
  EXPECT_EQ(judged.folded[0].severity, Severity::kWarning);
  EXPECT_EQ(judged.folded[0].count, 34u);
  EXPECT_EQ(judged.warnings, 36u);
}

TEST(IssuePolicy, ErrorsAndUnknownCodesCannotBeIgnored) {
  EXPECT_TRUE(may_ignore("A203"));
  EXPECT_TRUE(may_ignore("A204"));
  EXPECT_FALSE(may_ignore("A107"));
  EXPECT_FALSE(may_ignore("F101"));
  EXPECT_FALSE(may_ignore("A299"));
}

}  // namespace
}  // namespace coif
