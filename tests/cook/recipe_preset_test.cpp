#include "cook/recipe/recipe_preset.h"

#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

namespace coif::cook::recipe_preset_test {

TEST(RecipePreset, EachIsARecipeOfItsOwn) {
  std::set<std::string> printed{print_recipe(default_recipe())};
  std::string words = "none";
  for (const RecipePreset& preset : recipe_presets()) {
    words += std::string("|") + preset.name;
    const auto recipe = parse_recipe("{}", "r.json", {preset.name, ""});
    ASSERT_TRUE(recipe) << recipe.error().message;
    EXPECT_EQ(recipe->look_preset, preset.name);
    EXPECT_TRUE(printed.insert(print_recipe(*recipe)).second) << preset.name << " is another one, or none";
    const auto again = parse_recipe(print_recipe(*recipe), "again.json");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(print_recipe(*again), print_recipe(*recipe));
  }
  EXPECT_EQ(words, kPresetWords);
}

TEST(RecipePreset, GivesWayToWhatARecipeSays) {
  const auto plain = parse_recipe(R"({"look": {"preset": "anime"}})", "r.json");
  const auto own = parse_recipe(R"({"look": {"preset": "anime"}, "material": {"primary_exponent": 7}})", "r.json");
  ASSERT_TRUE(plain && own);
  EXPECT_NE(plain->primary_exponent, 7);
  EXPECT_EQ(own->primary_exponent, 7);
  EXPECT_EQ(own->opaque_threshold, plain->opaque_threshold) << "the rest is the preset's";
}

TEST(RecipePreset, BringsAStyleUnlessAnotherIsNamed) {
  const auto ponytail = parse_recipe("{}", "r.json", {"ponytail", ""});
  const auto style = parse_recipe("{}", "r.json", {"", "ponytail"});
  const auto other = parse_recipe(R"({"grow": {"style": "afro"}})", "r.json", {"ponytail", ""});
  ASSERT_TRUE(ponytail && style && other);
  EXPECT_EQ(ponytail->grow_gather, style->grow_gather);
  EXPECT_TRUE(ponytail->grow_gather);
  EXPECT_EQ(other->grow_style, "afro");
  EXPECT_FALSE(other->grow_gather);
}

TEST(RecipePreset, IsRefusedByName) {
  const auto wrong = parse_recipe(R"({"look": {"preset": "animee"}})", "r.json");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("r.json: \"look.preset\""), std::string::npos) << wrong.error().message;
  EXPECT_NE(wrong.error().message.find("anime"), std::string::npos) << wrong.error().message;
}

}  // namespace coif::cook::recipe_preset_test
