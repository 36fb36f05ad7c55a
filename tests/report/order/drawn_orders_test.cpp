#include "report/order/drawn_orders.h"

#include "report/opened_asset.h"
#include "report/order/shells.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif {
namespace {

/// Corners of all triangles, sorted: what is drawn, whatever the order.
std::vector<std::array<std::uint32_t, 3>> triangles(const AssetContents& contents) {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (std::size_t i = 0; i < contents.indices.size(); i += 3) {
    all.push_back({contents.indices[i], contents.indices[i + 1], contents.indices[i + 2]});
  }
  std::ranges::sort(all);
  return all;
}

std::vector<Eigen::Vector3f> rest_positions(const AssetContents& contents) {
  std::vector<Eigen::Vector3f> positions;
  for (const VertexRecord& v : contents.vertices) positions.emplace_back(v.position[0], v.position[1], v.position[2]);
  return positions;
}

TEST(DrawnOrders, OpenAndDrawTheSameTriangles) {
  const AssetContents all = shells_with_orders();
  const AssetContents finest = finest_level(OpenedAsset(all).asset());
  const Eigen::Vector3f eye(0, 0, 1);
  for (const AssetContents& made : {finest, in_file_order(finest), in_head_order(finest), in_stored_order(finest),
                                    sorted_by_unit(finest, each_triangle(finest), rest_positions(finest), eye)}) {
    EXPECT_TRUE(OpenedAsset(made).asset().is_open());
    EXPECT_EQ(triangles(made), triangles(all));
  }
}

TEST(DrawnOrders, FinestLevelKeepsOrdersAndLeavesOutCoarserLevels) {
  AssetContents two_levels = shells_with_orders();
  const std::uint32_t patches = std::uint32_t(two_levels.patches.size()), half = patches / 2;
  two_levels.lods = {{0, half, 0.5f, 0}, {half, half, 0, 0.01f}};
  two_levels.lod_bones.assign(two_levels.bones.size(), 0);
  const auto triangles_of_level = std::uint32_t(two_levels.indices.size() / 6);
  for (std::uint32_t t = 0; t < triangles_of_level; ++t) {
    two_levels.orders[t] = triangles_of_level - 1 - t;
    two_levels.orders[triangles_of_level + t] = 2 * triangles_of_level - 1 - t;
  }
  const OpenedAsset opened(two_levels);
  ASSERT_TRUE(opened.asset().is_open());
  const AssetContents finest = finest_level(opened.asset());
  EXPECT_EQ(finest.patches.size(), half);
  EXPECT_EQ(finest.indices.size(), 3 * triangles_of_level);
  EXPECT_EQ(finest.orders.size(), triangles_of_level);
  EXPECT_TRUE(OpenedAsset(finest).asset().is_open());
}

TEST(DrawnOrders, FileOrderIsTheFilesAndHeadOrderBeginsInside) {
  AssetContents stored = shells();
  std::ranges::reverse(stored.patches);
  std::uint32_t first = 0;
  for (PatchRecord& patch : stored.patches) {
    patch.first_index = first;  // both boxes' patches have as many indices
    first += patch.index_count;
  }
  const AssetContents file = in_file_order(stored), head = in_head_order(stored);
  EXPECT_TRUE(std::ranges::is_sorted(file.patches, {}, &PatchRecord::file_place));
  EXPECT_TRUE(std::ranges::is_sorted(head.patches, {}, &PatchRecord::head_distance));
  EXPECT_LT(head.patches.front().head_distance, head.patches.back().head_distance);
}

TEST(DrawnOrders, AreTheThesissOnlyWithFacesApart) {
  AssetContents together = shells();
  together.material.front().flags |= kMaterialFacesTogether;
  EXPECT_EQ(in_head_order(together).material.front().flags & kMaterialFacesTogether, 0u);
  EXPECT_NE(in_stored_order(together).material.front().flags & kMaterialFacesTogether, 0u);
}

TEST(DrawnOrders, TrianglesAreFarToNear) {
  const AssetContents finest = shells();
  const auto positions = rest_positions(finest);
  const Eigen::Vector3f eye(0.3f, -0.2f, 1);
  const auto indices = far_to_near(finest.indices, each_triangle(finest), positions, eye);
  ASSERT_EQ(indices.size(), finest.indices.size());
  float before = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Eigen::Vector3f sum = positions[indices[i]] + positions[indices[i + 1]] + positions[indices[i + 2]];
    const float distance = (sum / 3 - eye).norm();
    EXPECT_LE(distance, before + 1e-6f);
    before = distance;
  }
}

/// Both boxes' cards on bones of their own but for one corner each.
AssetContents shells_on_two_bones() {
  AssetContents contents = shells();
  contents.skin.resize(contents.vertices.size());
  for (std::size_t v = 0; v < contents.skin.size(); ++v) {
    const bool is_outer = v < contents.skin.size() / 2;
    contents.skin[v].bone[0] = std::uint16_t(is_outer == (v % 4 != 0) ? 5 : 3);
    contents.skin[v].weight[0] = 255;
  }
  return contents;
}

TEST(DrawnOrders, TrianglesHangOnTheBoneThatMovesThemMost) {
  const AssetContents finest = shells_on_two_bones();
  const auto bones = leading_bones(finest);
  ASSERT_EQ(bones.size(), finest.indices.size() / 3);
  for (std::size_t t = 0; t < bones.size(); ++t) EXPECT_EQ(bones[t], t < bones.size() / 2 ? 5u : 3u) << t;
}

TEST(DrawnOrders, BonesAreFarToNearAndKeepTheirTrianglesInStoredOrder) {
  const AssetContents finest = shells_on_two_bones();
  auto positions = rest_positions(finest);
  for (std::size_t v = 0; v < positions.size() / 2; ++v) positions[v].z() += 1;  // the outer box's
  const auto bones = leading_bones(finest);
  const auto in_front = far_to_near(finest.indices, bones, positions, {0, 0, 5});
  const auto behind = far_to_near(finest.indices, bones, positions, {0, 0, -5});
  const auto middle = std::ptrdiff_t(finest.indices.size() / 2);
  std::vector<std::uint32_t> inner_first = finest.indices;
  std::ranges::rotate(inner_first, inner_first.begin() + middle);
  EXPECT_EQ(in_front, inner_first);
  EXPECT_EQ(behind, finest.indices);
}

}  // namespace
}  // namespace coif
