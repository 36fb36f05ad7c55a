#include "compare/rig_difference.h"
#include "animation/glb_reader.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::compare::rig_difference_test {

/// small_asset() with this much of each vertex's weight, of 255, on the bone that moves it; the rest follows the head.
AssetContents moving_by(std::uint8_t weight) {
  AssetContents contents = small_asset();
  for (SkinRecord& skin : contents.skin) {
    skin.weight[0] = weight;
    skin.weight[1] = std::uint8_t(255 - weight);
  }
  return contents;
}

RigDifference difference(const AssetContents& a, const AssetContents& b, const animation::RecordingSettings& settings) {
  const animation::OpenAsset file_a(a), file_b(b);
  const auto match = match_surfaces(file_a.asset(), file_b.asset());
  EXPECT_TRUE(match) << match.error().message;
  const auto result = compare_rigs(file_a.asset(), file_b.asset(), *match, settings);
  EXPECT_TRUE(result) << result.error().message;
  return *result;
}

TEST(RigDifference, OfEqualRigsIsNothing) {
  for (const motion::MotionInfo& info : motion::all_motions()) {
    const auto d = difference(small_asset(), small_asset(), {.motion = info.motion, .seconds = 1});
    EXPECT_EQ(d.rms, 0) << info.name;
    EXPECT_EQ(d.max, 0) << info.name;
    EXPECT_EQ(d.ratio, 0) << info.name;
    EXPECT_GT(d.moved, 0) << info.name;
  }
}

TEST(RigDifference, OfARigidRigIsOneOfWhatTheOtherMoves) {
  const auto d = difference(moving_by(255), moving_by(0), {.motion = motion::Motion::kTurn, .seconds = 1});
  EXPECT_GT(d.moved, 0.001);
  EXPECT_NEAR(d.rms, d.moved, 1.0e-9);
  EXPECT_NEAR(d.ratio, 1, 1.0e-9);
  EXPECT_GE(d.max, d.rms);
}

TEST(RigDifference, GrowsWithTheWeightThatIsMissing) {
  for (const int missing : {51, 102, 204}) {
    const auto d = difference(moving_by(255), moving_by(std::uint8_t(255 - missing)),
                              {.motion = motion::Motion::kNod, .seconds = 1});
    EXPECT_NEAR(d.ratio, missing / 255.0, 1.0e-4);
  }
}

TEST(RigDifference, HasNoRatioWhereNothingMoves) {
  const auto d = difference(moving_by(0), moving_by(255), {.motion = motion::Motion::kTurn, .seconds = 1});
  EXPECT_LT(d.moved, 1.0e-6);
  EXPECT_GT(d.rms, 0);
}

TEST(RigDifference, PointsWithoutAreaDoNotCount) {
  const animation::OpenAsset moved(moving_by(255)), still(moving_by(0));
  auto match = match_surfaces(moved.asset(), still.asset());
  ASSERT_TRUE(match);
  std::ranges::fill(match->area, 0);
  const auto d = compare_rigs(moved.asset(), still.asset(), *match, {.motion = motion::Motion::kTurn, .seconds = 1});
  ASSERT_TRUE(d);
  EXPECT_EQ(d->rms, 0);
  EXPECT_EQ(d->max, 0);
}

TEST(RigDifference, TellsSagFromSwing) {
  const auto sag = difference(small_asset(), small_asset(), {.motion = motion::Motion::kStill, .seconds = 1});
  EXPECT_LT(sag.still_ratio, 0.05) << "settled hair holds its mean pose";
  // Where no collider and no weight holds hair off its pose, all it does is swing.
  AssetContents free = small_asset();
  for (BoneRecord& bone : free.bones) bone.colliders = 0;
  for (DynamicsRecord& bone : free.dynamics) bone.gravity_scale = 0;
  const auto swing = difference(free, free, {.motion = motion::Motion::kNod, .seconds = 2});
  EXPECT_GT(swing.still_ratio, 0.9);
  EXPECT_LE(swing.still_ratio, 1);
}

TEST(RigDifference, RefusesWhatTheRecordingRefuses) {
  const animation::OpenAsset file(small_asset());
  const auto match = match_surfaces(file.asset(), file.asset());
  ASSERT_TRUE(match);
  EXPECT_FALSE(compare_rigs(file.asset(), file.asset(), *match, {.fps = 1}));
}

TEST(HairSize, IsTheDiagonalOfTheBoxAroundTheFinestLevel) {
  const animation::OpenAsset file(small_asset());
  // Vertices of level 0: x 0 .. 0.15, y -0.1 .. 0.
  EXPECT_NEAR(hair_size(file.asset()), std::hypot(0.15, 0.1), 1.0e-6);
}

/// small_asset() with every vertex moved.
AssetContents moved(float by) {
  AssetContents contents = small_asset();
  for (VertexRecord& vertex : contents.vertices) vertex.position[2] += by;
  return contents;
}

TEST(SurfaceMatch, OfAnAssetWithItselfIsTheIdentity) {
  const animation::OpenAsset file(small_asset());
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
  const animation::OpenAsset a(small_asset()), b(contents);
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
  const animation::OpenAsset a(small_asset()), b(contents);
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
  const animation::OpenAsset file(contents);
  ASSERT_TRUE(file.asset().is_open());
  const auto match = match_surfaces(file.asset(), file.asset());
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_EQ(match->vertex_a, match->vertex_b);
}

TEST(SurfaceMatch, MeasuresSmallDifferencesAndRefusesLargeOnes) {
  const animation::OpenAsset a(small_asset());
  for (const float near : {0.0001f, 0.0008f}) {
    const animation::OpenAsset b(moved(near));
    const auto match = match_surfaces(a.asset(), b.asset());
    ASSERT_TRUE(match) << match.error().message;
    EXPECT_NEAR(match->rest_rms, near, 1.0e-6);
  }
  for (const float far : {0.0012f, 0.01f, 100.0f}) {
    const animation::OpenAsset b(moved(far));
    const auto match = match_surfaces(a.asset(), b.asset());
    ASSERT_FALSE(match) << far;
    EXPECT_NE(match.error().message.find("differ at rest"), std::string::npos);
    EXPECT_EQ(match.error().kind, ToolError::Kind::kBadInput);
  }
}

TEST(SurfaceMatch, NeedsAMesh) {
  const animation::OpenAsset bald(without_mesh(small_asset())), hairy(small_asset());
  ASSERT_TRUE(bald.asset().is_open());
  EXPECT_FALSE(match_surfaces(bald.asset(), hairy.asset()));
  EXPECT_FALSE(match_surfaces(hairy.asset(), bald.asset()));
}

}  // namespace coif::compare::rig_difference_test
