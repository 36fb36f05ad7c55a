// Artists' files, cooked with the recipes beside this test. They are not part of the project: where the folder is
// absent every case skips and says so.

#include "cook/cook.h"
#include "formats/aligned_bytes.h"
#include "import/import.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace coif {
namespace {

struct RealFile {
  const char* path;  ///< Below the corpus' folder "hair".
  std::uint32_t triangles;
  std::uint32_t patches;
  std::uint32_t chains;
  std::uint32_t simulated_bones;
};

// Triangles are those of the file's hair materials or pieces, counted by hand from its lists; chains are those that the
// hierarchy below the head bone shows.
const RealFile kFiles[] = {
    {"mh_ponytail01/ponytail01_skinned.glb", 5352, 59, 1, 5},
    {"unitychan/UnityChan.fbx", 1168 + 530 + 227 + 658, 87, 6, 15},
    {"seedsan/new_seedsan_betterfbx.fbx", 238 + 7820, 59, 12, 16},
    {"godette/Godette_vrm_v4.vrm", 3 * 80 + 139, 7, 7, 7},
    {"quaternius_witch/Witch.glb", 2316, 20, 0, 0},
};

class RealFiles : public testing::TestWithParam<RealFile> {
 protected:
  void SetUp() override {
    path_ = std::filesystem::path(COIF_TEST_ASSETS) / "hair" / GetParam().path;
    if (!std::filesystem::exists(path_)) GTEST_SKIP() << path_ << ": no corpus of artists' files here";
  }

  CookResult cooked(unsigned threads) {
    const auto recipe =
        read_recipe(std::filesystem::path(COIF_TEST_RECIPES) / (path_.stem().string() + ".recipe.json"));
    EXPECT_TRUE(recipe) << (recipe ? "" : recipe.error().message);
    const auto source = import_model(path_);
    EXPECT_TRUE(source) << (source ? "" : source.error().message);
    if (!recipe || !source) return {};
    auto result = cook(*source, *recipe, {.threads = threads, .recipe_directory = {}, .source_hash = 0});
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? *result : CookResult{};
  }

  std::filesystem::path path_;
};

TEST_P(RealFiles, HaveTheirTrianglesPatchesAndChains) {
  const CookReport report = cooked(1).report;
  EXPECT_EQ(report.triangles, GetParam().triangles);
  EXPECT_EQ(report.patches, GetParam().patches);
  EXPECT_EQ(report.chains, GetParam().chains);
  EXPECT_EQ(report.simulated_bones, GetParam().simulated_bones);
}

TEST_P(RealFiles, GiveTheSameBytesOnOneAndTwoThreads) { EXPECT_EQ(cooked(1).asset, cooked(2).asset); }

TEST_P(RealFiles, AreOfAHeadsSizeInMetres) {
  AlignedBytes file(cooked(1).asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  float low = 0, high = 0;
  for (const VertexRecord& vertex : asset.vertices()) {
    low = std::min(low, vertex.position[1]);
    high = std::max(high, vertex.position[1]);
  }
  EXPECT_GT(high - low, 0.15f);
  EXPECT_LT(high - low, 1.5f);
  EXPECT_LT(high, 0.6f) << "head space starts at the head's joint";
  ASSERT_EQ(asset.colliders().size(), 1u);
  for (float radius : asset.colliders()[0].radii) {
    EXPECT_GT(radius, 0.05f);
    EXPECT_LT(radius, 0.25f);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealFiles, testing::ValuesIn(kFiles), [](const auto& tested) {
  return std::filesystem::path(tested.param.path).parent_path().string();
});

}  // namespace
}  // namespace coif
