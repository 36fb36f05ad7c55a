// What open() demands of draw orders. small_asset() has three triangles, 0 and 1 in level 0 and 2 in level 1, and two
// orders besides the stored one.

#include "models/small_asset.h"

#include <coif/view_cells.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace coif::open_orders_test {

TEST(OpenOrders, AnOpenAssetGivesThemBack) {
  const AssetContents contents = small_asset();
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.order_count(), 3u);
  EXPECT_TRUE(std::ranges::equal(asset.orders(), contents.orders));
  EXPECT_TRUE(std::ranges::equal(asset.order_views(), contents.order_views));
  EXPECT_EQ(asset.patches()[0].file_place, 2u);
  EXPECT_EQ(Asset{}.order_count(), 0u);
}

TEST(OpenOrders, WithoutThemTheStoredOneIsTheOnlyOne) {
  AssetContents contents = small_asset();
  clear_group("orders", contents);
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.order_count(), 1u);
}

TEST(OpenOrders, OrdersAndViewsComeTogether) {
  EXPECT_EQ(refusal([](auto& a) { a.orders.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.order_views.clear(); }), LoadCode::kChunkMissing);
}

TEST(OpenOrders, RefusesOrdersThatAreNotWholeOrTooMany) {
  EXPECT_EQ(refusal([](auto& a) { a.orders.pop_back(); }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.orders.push_back(0); }), LoadCode::kChunkSize);
  const auto with = [](std::uint32_t further) {
    return [further](AssetContents& a) {
      a.orders.clear();
      for (std::uint32_t i = 0; i < further; ++i) a.orders.insert(a.orders.end(), {1, 0, 2});
    };
  };
  EXPECT_EQ(refusal(with(kMaxOrders - 1)), LoadCode::kOk);
  EXPECT_EQ(refusal(with(kMaxOrders)), LoadCode::kChunkSize);
  AssetContents contents = small_asset();
  with(kMaxOrders + 4)(contents);
  const LoadStatus status = open_written(contents);
  EXPECT_EQ(status.expected, kMaxOrders - 1u);
  EXPECT_EQ(status.found, kMaxOrders + 4u);
}

TEST(OpenOrders, EveryLevelKeepsItsOwnTriangles) {
  EXPECT_EQ(refusal([](auto& a) { std::swap(a.orders[1], a.orders[2]); }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.orders[5] = 3; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.orders[5] = kNone; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { std::swap(a.orders[3], a.orders[4]); }), LoadCode::kOk);
  const auto one_level = [](AssetContents& a) {
    clear_group("lods", a);
    a.orders = {2, 0, 1, 1, 2, 0};
  };
  EXPECT_EQ(refusal(one_level), LoadCode::kOk);
  const auto without_levels = [&](std::vector<std::uint32_t> orders) {
    AssetContents contents = small_asset();
    clear_group("lods", contents);
    contents.orders = std::move(orders);
    return open_written(contents);
  };
  const LoadStatus beyond = without_levels({2, 0, 1, 1, 3, 0});
  EXPECT_EQ(beyond.code, LoadCode::kReference);
  EXPECT_EQ(beyond.item, 4u);
  EXPECT_EQ(beyond.expected, 3u) << "so many there are";
  EXPECT_EQ(beyond.found, 3u);
  EXPECT_EQ(without_levels({2, 0, 1, 1, 2, 2}).code, LoadCode::kOrderCover);
}

TEST(OpenOrders, RefusesATriangleThatIsDrawnTwice) {
  AssetContents contents = small_asset();
  contents.orders[4] = 0;
  const LoadStatus status = open_written(contents);
  EXPECT_EQ(status.code, LoadCode::kOrderCover);
  EXPECT_EQ(status.chunk, chunk::kOrders);
  EXPECT_EQ(status.item, 3u) << "where that order's level begins";
}

TEST(OpenOrders, PatchesNeedNotStayTogether) {
  AssetContents contents = small_asset();
  contents.indices.insert(contents.indices.begin(), {0, 1, 2});
  contents.patches[0].index_count = 6;
  contents.patches[1].first_index = 6;
  contents.patches[2].first_index = 9;
  contents.orders = {0, 2, 1, 3};
  contents.order_views.assign(kViewCells, 1);
  EXPECT_EQ(open_written(contents).code, LoadCode::kOk);
  std::swap(contents.orders[2], contents.orders[3]);
  EXPECT_EQ(open_written(contents).code, LoadCode::kReference) << "but levels do";
}

TEST(OpenOrders, EveryDirectionHasAnOrderThatExists) {
  EXPECT_EQ(refusal([](auto& a) { a.order_views.pop_back(); }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.order_views.push_back(0); }), LoadCode::kChunkSize);
  AssetContents contents = small_asset();
  contents.order_views[95] = 3;
  const LoadStatus status = open_written(contents);
  EXPECT_EQ(status.code, LoadCode::kReference);
  EXPECT_EQ(status.chunk, chunk::kOrderViews);
  EXPECT_EQ(status.item, 95u);
}

TEST(OpenOrders, MaterialsMayAskForBothFacesTogether) {
  EXPECT_EQ(refusal([](auto& a) { a.material[0].flags = kMaterialDoubleSided | kMaterialFacesTogether; }),
            LoadCode::kOk);
}

constexpr float kAlongX[3] = {2, 0.5f, -0.5f};
static_assert(view_cell(kAlongX) == 6, "known where the program is compiled");

TEST(ViewCells, TheMiddleOfACellLiesInIt) {
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
    float direction[3];
    view_cell_direction(cell, direction);
    EXPECT_EQ(view_cell(direction), cell);
    EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1.0, 1.0e-6);
    for (float& x : direction) x *= 1000;
    EXPECT_EQ(view_cell(direction), cell) << "length does not matter";
  }
}

TEST(ViewCells, NoDirectionLiesOutside) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  const float values[] = {-kInf, -1, -0.0f, 0.0f, 1.0e-30f, 1, kInf, kNan};
  for (const float x : values) {
    for (const float y : values) {
      for (const float z : values) {
        const float direction[3] = {x, y, z};
        EXPECT_LT(view_cell(direction), kViewCells) << x << " " << y << " " << z;
      }
    }
  }
}

/// Directions spread evenly over the sphere, by a spiral with the golden angle; none on the edge of a cell.
std::array<float, 3> spiral_point(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, turn = 0.1 + 2.399963229728653 * i, r = std::sqrt(1 - z * z);
  return {float(r * std::cos(turn)), float(r * std::sin(turn)), float(z)};
}

TEST(ViewCells, CellsAreNearlyEqualInSolidAngle) {
  std::array<int, kViewCells> hits{};
  constexpr int kCount = 96 * 500;
  for (int i = 0; i < kCount; ++i) {
    const std::array<float, 3> p = spiral_point(i, kCount);
    const float direction[3] = {p[0], p[1], p[2]};
    ++hits[view_cell(direction)];
  }
  for (const int count : hits) {
    EXPECT_GT(count, 500 * 0.75);
    EXPECT_LT(count, 500 * 1.25);
  }
}

TEST(ViewCells, OppositeDirectionsLieInOppositeCells) {
  for (int i = 0; i < 1000; ++i) {
    const std::array<float, 3> p = spiral_point(i, 1000);
    const float there[3] = {p[0], p[1], p[2]}, back[3] = {-p[0], -p[1], -p[2]};
    const std::uint32_t a = view_cell(there), b = view_cell(back);
    EXPECT_EQ(a / 32, b / 32);
    EXPECT_NE(a / 16, b / 16);
    EXPECT_EQ(a % 16 + b % 16, 15u);
  }
}

}  // namespace coif::open_orders_test
