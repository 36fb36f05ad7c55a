// Assets of every version of the format stay readable: sample_assets/versions has one of each.

#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace coif::versions_test {

namespace fs = std::filesystem;

std::vector<fs::path> assets() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(fs::path(COIF_SAMPLE_ASSETS) / "versions")) {
    if (entry.path().extension() == ".coif") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

AlignedBytes bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return AlignedBytes(std::as_bytes(std::span(bytes)));
}

TEST(Versions, EveryOneOpensWholeAndIsWhatItsNameSays) {
  ASSERT_FALSE(assets().empty());
  for (const fs::path& path : assets()) {
    AlignedBytes file = bytes_of(path);
    Asset asset;
    const LoadStatus status = asset.open(file.bytes());
    ASSERT_TRUE(status) << path << ": " << describe(status.code);
    EXPECT_TRUE(asset.verify_draw_data()) << path;
    EXPECT_EQ("1." + std::to_string(asset.minor()), path.stem().string());
  }
}

TEST(Versions, TheFirstHasEveryPartOfAnAsset) {
  AlignedBytes file = bytes_of(fs::path(COIF_SAMPLE_ASSETS) / "versions" / "1.0.coif");
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.skeleton().simulated_count, 9u);
  EXPECT_EQ(asset.chains().size(), 3u);
  EXPECT_EQ(asset.lod_count(), 3u);
  EXPECT_EQ(asset.order_count(), 2u);
  EXPECT_EQ(asset.lod_indices(0).size(), 3u * 2870);
  EXPECT_STREQ(asset.bone_name(0), "Head");
  EXPECT_NE(asset.texture(TextureRole::kBaseColor), nullptr);
  EXPECT_NE(asset.texture(TextureRole::kShiftMask), nullptr);
  EXPECT_FALSE(asset.colliders().empty() || asset.skin().empty() || asset.quality().empty());
  EXPECT_TRUE(asset.motion_names().empty()) << "its numbers of motions are those of the specification's list";
  EXPECT_TRUE(asset.material() != nullptr && asset.tuning() != nullptr && asset.provenance() != nullptr);
}

}  // namespace coif::versions_test
