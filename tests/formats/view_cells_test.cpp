#include <coif/view_cells.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
