#include "validate/issue_codes.h"

#include "cook/recipe.h"
#include "validate/code_page.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace coif {
namespace {

TEST(IssueCodes, AreUniqueAndGrouped) {
  std::set<std::string_view> codes;
  IssueGroup group = IssueGroup::kContainer;
  for (const IssueCode& row : issue_codes()) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code << " twice";
    EXPECT_TRUE(std::regex_match(row.code, std::regex("[FARS][0-9]{3}"))) << row.code;
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
  const nlohmann::json recipe = nlohmann::json::parse(print_recipe(default_recipe()), nullptr, true, true);
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

}  // namespace
}  // namespace coif
