#include "validate/issue_codes.h"
#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace coif::validate::issue_codes_test {

TEST(IssueCodes, AreUniqueAndGrouped) {
  std::set<std::string_view> codes;
  IssueGroup group = IssueGroup::kContainer;
  for (const IssueCode& row : issue_codes()) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code << " twice";
    EXPECT_TRUE(std::regex_match(row.code, std::regex("[FARSC][0-9]{3}"))) << row.code;
    EXPECT_GE(row.group, group) << row.code;
    group = row.group;
  }
  EXPECT_EQ(std::size_t(group) + 1, kIssueGroups) << "a group without a code";
}

TEST(IssueCodes, SayWhatTheyMeanAndHowToCureIt) {
  for (const IssueCode& row : issue_codes()) {
    EXPECT_FALSE(std::string_view(row.title).empty() || std::string_view(row.title).ends_with('.')) << row.code;
    EXPECT_TRUE(std::string_view(row.meaning).ends_with('.')) << row.code;
    EXPECT_TRUE(std::string_view(row.cure).ends_with('.')) << row.code;
    EXPECT_EQ(find_issue_code(row.code), &row);
  }
  EXPECT_EQ(find_issue_code("A999"), nullptr);
  EXPECT_EQ(find_issue_code(""), nullptr);
}

/// "textures.max_size" and the like.
TEST(IssueCodes, CuresNameOnlyKeysOfTheRecipe) {
  const nlohmann::json recipe = nlohmann::json::parse(cook::print_recipe(cook::default_recipe()), nullptr, true, true);
  const std::regex key("\"([a-z_]+)\\.([a-z_]+)\"");
  int keys = 0;
  for (const IssueCode& row : issue_codes()) {
    const std::string cure = row.cure;
    for (std::sregex_iterator match(cure.begin(), cure.end(), key), end; match != end; ++match, ++keys) {
      const bool known = recipe.contains((*match)[1]) && recipe[(*match)[1]].contains((*match)[2]);
      EXPECT_TRUE(known) << row.code << ": " << match->str() << " is no key of a recipe";
    }
  }
  EXPECT_GT(keys, 10);
}

/// Every code that a pass warns by, in the source itself, is a row; and every row of the cook's is warned by.
TEST(IssueCodes, EveryWarningOfTheCookHasItsRow) {
  namespace fs = std::filesystem;
  const std::regex site("(warn\\(\\s*|push_back\\(\\{)\"([A-Z][0-9]{3})\"");
  std::set<std::string> used;
  std::size_t without = 0;
  for (const char* folder : {"cook", "cards", "render"}) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(COIF_ISSUES_PAGE).parent_path().parent_path() / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      const std::string text((std::istreambuf_iterator<char>(file)), {});
      for (std::sregex_iterator match(text.begin(), text.end(), site), end; match != end; ++match)
        used.insert((*match)[2]);
    }
  }
  for (const std::string& code : used) {
    const IssueCode* row = find_issue_code(code);
    ASSERT_NE(row, nullptr) << code;
    EXPECT_TRUE(may_ignore(code)) << code << " cannot be acknowledged";
  }
  for (const IssueCode& row : cook_codes()) without += used.contains(row.code) ? 0 : 1;
  EXPECT_EQ(without, 0u) << "rows that nothing warns by";
}

TEST(IssueCodes, WhatACookRepairsIsAnErrorOfTheFileThatMayBeAcknowledged) {
  std::size_t repaired = 0;
  for (const IssueCode& row : issue_codes()) {
    if (!row.is_repaired) continue;
    ++repaired;
    EXPECT_EQ(row.severity, Severity::kError) << row.code;
    EXPECT_FALSE(judge({make_issue(row.code, "")}, {}).valid()) << row.code;
    EXPECT_TRUE(judge({make_issue(row.code, "")}, {.ignored = {row.code}}).valid()) << row.code;
  }
  EXPECT_GE(repaired, 8u);
}

TEST(IssueCodes, PageIsTheTable) {
  std::ifstream file(COIF_ISSUES_PAGE);
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), code_page()) << "renew it: coif validate --list-codes > tools/validate/ISSUES.md";
}

TEST(IssueCodes, JsonHasThemAll) {
  const nlohmann::json list = nlohmann::json::parse(code_json())["codes"];
  ASSERT_EQ(list.size(), issue_codes().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i]["code"], issue_codes()[i].code);
    EXPECT_EQ(list[i]["severity"], name(issue_codes()[i].severity));
    EXPECT_EQ(list[i]["cure"], issue_codes()[i].cure);
  }
}

/// One error, two warnings of one code, three notes of two codes.
Diagnostics some_issues() {
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
  Diagnostics issues(36, make_issue("A203", "dark"));
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

}  // namespace coif::validate::issue_codes_test
