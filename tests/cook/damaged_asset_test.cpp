// What a game may do with a cooked file in which any one byte was changed: open() refuses it, or it simulates.

#include "cook/cook.h"

#include "cook/built_models.h"
#include "formats/aligned_bytes.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

/// A wig with two patches and both textures, cooked as small as it gets, so that every byte can be tried.
std::vector<std::byte> cooked_wig() {
  SourceModel model = make_wig();
  model.meshes.push_back(make_strip({.root = {0.05f, 1.6f, -0.1f}, .tip_width = 0.4f}));
  model.meshes.back().node = 1;
  SourceMaterial strands;
  strands.name = "strands";
  strands.base_texture.image = 0;
  model.materials.push_back(strands);
  // A TGA of one pixel: header without compression, 32 bits.
  model.images.push_back({"dot", {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 8, 10, 20, 30, 255}});
  for (SourceMesh& mesh : model.meshes) mesh.material = 0;
  Recipe recipe = default_recipe();
  recipe.texture_max_size = 4;
  const auto result = cook(model, recipe, {});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  EXPECT_TRUE(result && result->report.warnings.empty());
  return result ? result->asset : std::vector<std::byte>{};
}

/// Three steps of a head that jerks sideways; the sum of all matrices.
double simulate(const Asset& asset) {
  const MemoryNeed need = Hair::memory_need(asset, {});
  AlignedBytes memory(std::vector<std::byte>(need.bytes));
  Hair hair;
  if (hair.create(asset, {}, memory.bytes()) != Status::kOk) return NAN;
  for (int frame = 1; frame <= 3; ++frame) {
    HeadPose pose;
    pose.position[0] = 0.1 * frame;
    if (hair.set_head(0, pose) != Status::kOk || hair.step({}) != Status::kOk) return NAN;
  }
  double sum = 0;
  for (const Mat34& bone : hair.palette(0)) {
    for (const auto& row : bone.m) {
      for (float value : row) sum += value;
    }
  }
  return sum;
}

TEST(DamagedAsset, AnyChangedByteIsRefusedOrSimulates) {
  AlignedBytes file(cooked_wig());
  const std::span<std::byte> bytes = file.bytes();
  ASSERT_GT(bytes.size(), 1000u);
  ASSERT_LT(bytes.size(), 10000u) << "small enough to try every byte";
  std::size_t refused = 0, harmless = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::byte original = bytes[at];
    for (unsigned flip = 1; flip < 256; ++flip) {
      bytes[at] = original ^ std::byte(flip);
      Asset asset;
      ASSERT_FALSE(asset.open(bytes) && asset.verify_draw_data()) << "the hashes must see byte " << at;
      if (!asset.open(bytes, {.verify_hash = false})) {
        ++refused;
        continue;
      }
      ++harmless;
      ASSERT_TRUE(std::isfinite(simulate(asset))) << "byte " << at << " xor " << flip;
    }
    bytes[at] = original;
  }
  EXPECT_GT(refused, 0u);
  EXPECT_GT(harmless, 0u) << "a position may change a little without harm";
}

TEST(DamagedAsset, EveryTruncationIsRefused) {
  const std::vector<std::byte> good = cooked_wig();
  for (std::size_t n = 0; n < good.size(); ++n) {
    AlignedBytes cut({good.data(), n});
    EXPECT_FALSE(Asset{}.open(cut.bytes(), {.verify_hash = false})) << n << " of " << good.size() << " bytes";
  }
}

}  // namespace
}  // namespace coif
