#include "cook/shrinking_surface.h"

#include "cook/lod_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace coif {
namespace {

/// A mesh whose points are its vertices, in the same order.
struct Made {
  explicit Made(const SourceMesh& source) : mesh(hair_from(source)) {
    const std::vector<Pose> rest = {mesh.positions};
    surface = surface_of(mesh, rest);
  }

  HairMesh mesh;
  PatchSurface surface;
};

/// Three by three points, numbered row by row.
TEST(ShrinkingSurface, ABorderMovesOnlyAlongItself) {
  const Made grid(make_card({.columns = 2, .rows = 2}));
  ShrinkingSurface shrinking(grid.surface);
  EXPECT_FALSE(shrinking.may_collapse(1, 4)) << "from the border to the middle";
  EXPECT_TRUE(shrinking.may_collapse(1, 0)) << "along the border";
  EXPECT_TRUE(shrinking.may_collapse(4, 1)) << "from the middle to the border";
  EXPECT_FALSE(shrinking.may_collapse(0, 1)) << "a corner";
}

/// Four triangles around a point; the one above has a corner on each side of a seam, which ends at the point.
TEST(ShrinkingSurface, TheEndOfATextureSeamDoesNotMoveAlongIt) {
  SourceMesh fan;
  fan.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}};
  fan.triangles = {1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0};
  for (const float seam : {0.0f, 3.0f}) {
    fan.uvs.clear();
    for (const Eigen::Vector3f& p : fan.positions) fan.uvs.emplace_back(p.x(), p.y());
    fan.uvs[5].x() += seam;
    const HairMesh mesh = hair_from(fan);
    const std::vector<Pose> rest = {mesh.positions};
    const PatchSurface surface = surface_of(mesh, rest);
    ShrinkingSurface shrinking(surface);
    const std::uint32_t middle = surface.triangles[0].point[2], above = surface.triangles[0].point[0];
    EXPECT_EQ(shrinking.may_collapse(middle, above), seam == 0) << seam;
  }
}

/// A pipe of three sides: each of its rings is a triangle that is none.
TEST(ShrinkingSurface, APipeIsNotPinchedShut) {
  SourceMesh pipe;
  for (std::uint32_t ring = 0; ring < 3; ++ring) {
    for (const Eigen::Vector2f& at : {Eigen::Vector2f(0, 1), Eigen::Vector2f(-1, -1), Eigen::Vector2f(1, -1)}) {
      pipe.positions.emplace_back(at.x(), float(ring), at.y());
      pipe.uvs.emplace_back(0.0f, 0.0f);
    }
  }
  for (std::uint32_t ring = 0; ring < 2; ++ring) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t a = 3 * ring + side, b = 3 * ring + (side + 1) % 3;
      pipe.triangles.insert(pipe.triangles.end(), {a, b, a + 3, b, b + 3, a + 3});
    }
  }
  const Made made(pipe);
  ShrinkingSurface shrinking(made.surface);
  EXPECT_FALSE(shrinking.may_collapse(3, 4)) << "around the pipe";
  EXPECT_TRUE(shrinking.may_collapse(3, 0) || shrinking.may_collapse(3, 6)) << "along it";
}

TEST(ShrinkingSurface, AfterACollapseTheStarIsThatOfTheOtherEnd) {
  const Made grid(make_card({.columns = 4, .rows = 4}));
  ShrinkingSurface shrinking(grid.surface);
  const std::uint32_t before = shrinking.triangles_left();
  std::vector<CornerMove> moves;
  ASSERT_TRUE(shrinking.may_collapse(12, 13));
  const auto star = shrinking.star_after(12, 13);
  const std::vector<ShrinkingSurface::Points> expected(star.begin(), star.end());
  shrinking.collapse(12, 13, moves);
  EXPECT_EQ(shrinking.triangles_left(), before - 2);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].to, 13u);
  std::set<std::uint32_t> around;
  for (const auto& points : expected) around.insert(points.begin(), points.end());
  around.erase(13);
  const auto neighbours = shrinking.neighbours(13);
  EXPECT_EQ(around, std::set<std::uint32_t>(neighbours.begin(), neighbours.end()));
  EXPECT_FALSE(around.contains(12));
}

}  // namespace
}  // namespace coif
