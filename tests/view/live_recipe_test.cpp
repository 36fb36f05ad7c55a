#include "cook/recipe/recipe.h"
#include "view/server/live_cook.h"

#include "cook/recipe/recipe_keys.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <variant>

namespace coif::view::live_recipe_test {
namespace {

namespace fs = std::filesystem;

class LiveRecipeTest : public testing::Test {
 protected:
  ~LiveRecipeTest() override { fs::remove(file_); }

  void write(const std::string& text) const { std::ofstream(file_) << text; }
  /// The message, or "".
  [[nodiscard]] std::string fault(const std::string& changes) const {
    const auto read = read_changes(changes);
    if (!read) return read.error().message;
    const auto merged = live_recipe(file_, *read);
    return merged ? "" : merged.error().message;
  }

  fs::path file_ = fs::temp_directory_path() / ("coif_live_recipe_test." + std::to_string(getpid()) + ".json");
};

TEST_F(LiveRecipeTest, ChangesLieOverTheFile) {
  write(
      "{\"material\": {\"primary_shift\": 0.5, \"secondary_shift\": 0.25}, // said by hand\n \"dynamics\": "
      "{\"friction\": 3}}");
  const auto merged =
      live_recipe(file_, *read_changes("{\"material\": {\"primary_shift\": 1.5}, \"dynamics\": {\"friction\": null}}"));
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->recipe.primary_shift, 1.5);
  EXPECT_EQ(merged->recipe.secondary_shift, 0.25);
  EXPECT_FALSE(merged->recipe.friction) << "null is as if the file did not say it";
  EXPECT_EQ(merged->file["material"]["primary_shift"], 0.5);
}

TEST_F(LiveRecipeTest, NoFileIsTheDefaults) {
  const auto merged = live_recipe({}, *read_changes("{\"material\": {\"primary_shift\": 1.5}}"));
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->recipe.primary_shift, 1.5);
  EXPECT_EQ(merged->recipe.secondary_shift, cook::default_recipe().secondary_shift);
  EXPECT_TRUE(merged->file.empty());
}

TEST_F(LiveRecipeTest, ShortPatchesMerge) {
  write("{\"patches\": [{\"select\": {\"index\": [1]}, \"keep\": false}]}");
  const auto merged = live_recipe(file_, *read_changes("{\"patches\": {\"connectivity\": \"index\"}}"));
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(merged->recipe.patch_overrides.size(), 1u);
  EXPECT_EQ(merged->recipe.patch_connectivity, cook::Connectivity::kIndex);
}

TEST_F(LiveRecipeTest, FaultsAreToldAsOfAFile) {
  write("{}");
  for (const char* changes :
       {"{\"material\": {\"primary_shft\": 1}}", "{\"material\": {\"primary_shift\": 1e9}}", "{\"material\": 3}",
        "{\"matereal\": {\"tilt\": 1}}", "[]", "{", "{\"head\": {\"center\": [0, 1, 0]}}"}) {
    const auto told = cook::parse_recipe(changes, "changes of the page");
    ASSERT_FALSE(told) << changes;
    EXPECT_EQ(fault(changes), told.error().message);
  }
}

TEST_F(LiveRecipeTest, FaultsOfTheFileNameIt) {
  write("{\"material\": {\"primary_shft\": 1}}");
  EXPECT_EQ(fault("{}"), cook::read_recipe(file_).error().message);
  write("{\"material\": ");
  EXPECT_EQ(fault("{}"), cook::read_recipe(file_).error().message);
  fs::remove(file_);
  EXPECT_EQ(fault("{}"), cook::read_recipe(file_).error().message);
}

/// Every key of the table whose value is a file's path, in each way that a request may write it.
TEST_F(LiveRecipeTest, ChangesNameNoFiles) {
  write("{}");
  std::set<std::string> keys;
  for (const cook::RecipeKey& key : cook::recipe_keys()) {
    if (!key.names_file) continue;
    keys.insert(key.path());
    for (const char* value :
         {"\"/etc/passwd\"", "\"../secret.png\"", "\"\"", "{\"file\": \"/etc/passwd\"}", "[\"/etc/passwd\"]"}) {
      EXPECT_EQ(fault(fmt::format("{{\"{}\": {{\"{}\": {}}}}}", key.section, key.name, value)),
                fmt::format("changes of the page: \"{}\" names a file; only a recipe's file may", key.path()))
          << value;
    }
  }
  for (const char* known : {"cards.body", "textures.base_color", "textures.shift", "textures.mask", "textures.normal"})
    EXPECT_TRUE(keys.contains(known)) << known;
  EXPECT_EQ(fault("{\"textures\": {\"normal_green\": \"up\", \"max_size\": 512}}"), "");
}

/// A key that takes any text names a file or is known not to: a new one has to be decided.
TEST_F(LiveRecipeTest, KeysOfAnyTextSayWhetherTheyNameFiles) {
  const std::set<std::string> names_no_file{"source.variant", "skeleton.head"};
  for (const cook::RecipeKey& key : cook::recipe_keys()) {
    const bool is_text = std::holds_alternative<std::string cook::Recipe::*>(key.field) && key.choices == nullptr;
    EXPECT_TRUE(!is_text || key.names_file || names_no_file.contains(key.path())) << key.path();
  }
}

}  // namespace
}  // namespace coif::view::live_recipe_test
