#include "compare/surface_match.h"

#include "animation/open_asset.h"
#include "formats/without_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif {
namespace {

/// small_asset() with every vertex moved.
AssetContents moved(float by) {
  AssetContents contents = small_asset();
  for (VertexRecord& vertex : contents.vertices) vertex.position[2] += by;
  return contents;
}

TEST(SurfaceMatch, OfAnAssetWithItselfIsTheIdentity) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  const auto match = match_surfaces(file.asset(), file.asset());
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_EQ(match->vertex_a, match->vertex_b);
  EXPECT_EQ(match->rest_rms, 0);
  EXPECT_EQ(match->vertex_a.size(), 6u) << "the finest level only";
  EXPECT_NEAR(std::accumulate(match->area.begin(), match->area.end(), 0.0), 1, 1.0e-12);
}

TEST(SurfaceMatch, DoesNotDependOnTheOrderOfVertices) {
  AssetContents contents = small_asset();
  const auto last = std::uint32_t(contents.vertices.size() - 1);
  std::ranges::reverse(contents.vertices);
  std::ranges::reverse(contents.skin);
  for (std::uint32_t& index : contents.indices) index = last - index;
  const OpenAsset a(small_asset()), b(contents);
  ASSERT_TRUE(a.asset().is_open() && b.asset().is_open());
  const auto match = match_surfaces(a.asset(), b.asset());
  ASSERT_TRUE(match) << match.error().message;
  for (std::size_t i = 0; i < match->vertex_a.size(); ++i) {
    const auto& p = a.asset().vertices()[match->vertex_a[i]].position;
    const auto& q = b.asset().vertices()[match->vertex_b[i]].position;
    EXPECT_TRUE(std::equal(p, p + 3, q)) << i;
  }
}

TEST(SurfaceMatch, IsMadeInTheModelsSpace) {
  AssetContents contents = small_asset();
  contents.skeleton.head_joint[1] += 0.25f;
  for (VertexRecord& vertex : contents.vertices) vertex.position[1] -= 0.25f;
  const OpenAsset a(small_asset()), b(contents);
  ASSERT_TRUE(a.asset().is_open() && b.asset().is_open());
  const auto match = match_surfaces(a.asset(), b.asset());
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_EQ(match->vertex_a, match->vertex_b);
  EXPECT_LT(match->rest_rms, 1.0e-6);
}

TEST(SurfaceMatch, AtOnePlaceTakesTheVertexWithTheSameTexture) {
  AssetContents contents = small_asset();
  // The second vertex lies where the first does, with another part of the texture.
  std::copy_n(contents.vertices[0].position, 3, contents.vertices[1].position);
  contents.vertices[1].uv[0] = contents.vertices[0].uv[0] + 0.5f;
  const OpenAsset file(contents);
  ASSERT_TRUE(file.asset().is_open());
  const auto match = match_surfaces(file.asset(), file.asset());
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_EQ(match->vertex_a, match->vertex_b);
}

TEST(SurfaceMatch, MeasuresSmallDifferencesAndRefusesLargeOnes) {
  const OpenAsset a(small_asset());
  for (const float near : {0.0001f, 0.0008f}) {
    const OpenAsset b(moved(near));
    const auto match = match_surfaces(a.asset(), b.asset());
    ASSERT_TRUE(match) << match.error().message;
    EXPECT_NEAR(match->rest_rms, near, 1.0e-6);
  }
  for (const float far : {0.0012f, 0.01f, 100.0f}) {
    const OpenAsset b(moved(far));
    const auto match = match_surfaces(a.asset(), b.asset());
    ASSERT_FALSE(match) << far;
    EXPECT_NE(match.error().message.find("differ at rest"), std::string::npos);
    EXPECT_EQ(match.error().kind, ToolError::Kind::kBadInput);
  }
}

TEST(SurfaceMatch, NeedsAMesh) {
  const OpenAsset bald(without_mesh(small_asset())), hairy(small_asset());
  ASSERT_TRUE(bald.asset().is_open());
  EXPECT_FALSE(match_surfaces(bald.asset(), hairy.asset()));
  EXPECT_FALSE(match_surfaces(hairy.asset(), bald.asset()));
}

}  // namespace
}  // namespace coif
