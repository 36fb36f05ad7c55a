// What artists' files and the samples cook to raises no error, and no warning but those that are known to be deserved.

#include "cook/cook.h"
#include "import/import.h"
#include "validate/asset_issues.h"
#include "validate/doubtful_asset.h"
#include "validate/source_issues.h"

#include <filesystem>

namespace coif {
namespace {

namespace fs = std::filesystem;
using Codes = std::set<std::string>;

struct RealAsset {
  const char* name;
  fs::path source;
  fs::path recipe{};  ///< Empty: the defaults.
  Codes warnings{};
};

const fs::path kHair = fs::path(COIF_TEST_ASSETS) / "hair";
const fs::path kSamples = COIF_SAMPLE_ASSETS;

const RealAsset kAssets[] = {
    {"bob", kSamples / "bob/bob.glb", kSamples / "bob/bob.recipe.json"},
    // 100 chains of 16 bones: its default budget of 0.7 % is beyond reach, and its table says so.
    {"long", kSamples / "long/long.glb", kSamples / "long/long.recipe.json", {"A281"}},
    {"ponytail_skinned", kHair / "mh_ponytail01/ponytail01_skinned.glb"},
    {"ponytail", kHair / "mh_ponytail01/ponytail01.obj"},
    {"braid", kHair / "mh_braid01/braid01.obj"},
    {"long2", kHair / "mh2013_long2/long2.obj"},
    {"unitychan", kHair / "unitychan/UnityChan.fbx"},
    {"seedsan", kHair / "seedsan/new_seedsan_betterfbx.fbx"},
    {"godette", kHair / "godette/Godette_vrm_v4.vrm"},
    {"churro", kHair / "churro/ChurroChurro.vrm"},
    {"witch", kHair / "quaternius_witch/Witch.glb"},
    {"rocketbox", kHair / "rocketbox_Female_Adult_03/Female_Adult_03.fbx"},
    {"moz_braids", kHair / "moz_french-braids-double/hair_french-braids-double-brown.glb"},
};

Codes above_notes(const std::vector<Issue>& issues) {
  Codes codes;
  for (const Issue& issue : issues) {
    if (issue.severity != Severity::kInfo) codes.insert(issue.code);
  }
  return codes;
}

class RealAssets : public testing::TestWithParam<RealAsset> {};

TEST_P(RealAssets, RaiseNoMoreThanTheyDeserve) {
  const RealAsset& tested = GetParam();
  if (!fs::exists(tested.source)) GTEST_SKIP() << tested.source << ": no corpus of artists' files here";
  auto recipe = tested.recipe.empty() ? default_recipe() : *read_recipe(tested.recipe);
  recipe.order_method = "head";  // The search takes most of a cook's time and finds orders that are all in use.
  const auto source = import_model(tested.source);
  ASSERT_TRUE(source) << source.error().message;
  Codes of_source = above_notes(find_source_issues(*source, recipe));
  of_source.erase("S201");  // The corpus has files that need repair.
  EXPECT_EQ(of_source, Codes{});

  const auto result = cook(*source, recipe, {.threads = 2, .recipe_directory = tested.source.parent_path()});
  ASSERT_TRUE(result) << result.error().message;
  AlignedBytes file(result->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(above_notes(find_asset_issues(asset)), tested.warnings);
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealAssets, testing::ValuesIn(kAssets),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace coif
