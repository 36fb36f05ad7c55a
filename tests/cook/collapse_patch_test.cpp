#include "cook/lods/collapse_patch.h"
#include "cook/built_models.h"
#include "cook/select/triangle_distance.h"
#include "platform/stop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace coif::cook::collapse_patch_test {

/// A mesh whose points are its vertices, in the same order.
struct Made {
  explicit Made(const importer::SourceMesh& source) : mesh(hair_from(source)) {
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
  importer::SourceMesh fan;
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

/// Four triangles around a raised point: where it moves to the one above, two of them turn by so much.
TEST(ShrinkingSurface, ATriangleMayTurnByAbout75Degrees) {
  importer::SourceMesh fan;
  fan.triangles = {1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 0};
  for (const auto& [degrees, may] : {std::pair{30.0, true}, {74.5, true}, {76.5, false}, {89.0, false}}) {
    const auto height = float(std::tan(degrees * std::numbers::pi / 180) / std::numbers::sqrt2);
    fan.positions = {{0, 0, height}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
    fan.uvs.clear();
    for (const Eigen::Vector3f& p : fan.positions) fan.uvs.emplace_back(p.x(), p.y());
    const Made made(fan);
    ShrinkingSurface shrinking(made.surface);
    const std::uint32_t middle = made.surface.triangles[0].point[2], above = made.surface.triangles[0].point[0];
    EXPECT_EQ(shrinking.may_collapse(middle, above), may) << degrees;
  }
}

/// A pipe of three sides: each of its rings is a triangle that is none.
TEST(ShrinkingSurface, APipeIsNotPinchedShut) {
  importer::SourceMesh pipe;
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

constexpr CollapseLimits kNoLimit{.largest_error = 1, .fewest_share = 0};

struct Collapsed {
  HairMesh mesh;
  PatchSurface surface;
  CollapseSequence sequence;

  [[nodiscard]] std::vector<std::uint32_t> triangles(std::size_t steps) const {
    return after(mesh, surface, sequence, steps);
  }
  [[nodiscard]] std::vector<std::uint32_t> coarsest() const { return triangles(sequence.steps.size()); }
};

Collapsed collapsed(const importer::SourceMesh& source, const CollapseLimits& limits = kNoLimit) {
  Collapsed result{hair_from(source), {}, {}};
  const std::vector<Pose> rest = {result.mesh.positions};
  result.surface = surface_of(result.mesh, rest);
  result.sequence = collapse_patch(result.surface, limits);
  return result;
}

TEST(CollapsePatch, AFlatCardBecomesTwoTrianglesWithItsOutline) {
  const Collapsed card = collapsed(make_card({}), {.largest_error = 1.0e-6, .fewest_share = 0});
  const auto triangles = card.coarsest();
  EXPECT_EQ(triangles.size(), 6u);
  for (const Eigen::Vector3f& p : card.mesh.positions) EXPECT_LT(distance_from(card.mesh, triangles, p), 1.0e-6);
}

TEST(CollapsePatch, EveryStepHasAsManyTrianglesAsItSays) {
  const Collapsed card = collapsed(make_card({.bend_radius = 0.1f}));
  ASSERT_GT(card.sequence.steps.size(), 20u);
  for (std::size_t s = 1; s <= card.sequence.steps.size(); ++s) {
    EXPECT_EQ(card.triangles(s).size(), 3 * card.sequence.steps[s - 1].triangles_left) << s;
  }
  EXPECT_EQ(card.triangles(0), card.mesh.triangles);
}

TEST(CollapsePatch, TheErrorIsAtLeastTheDistanceOfEveryPoint) {
  const Collapsed card = collapsed(make_card({.columns = 6, .rows = 16, .bend_radius = 0.08f}));
  double before = 0;
  for (std::size_t s = 1; s <= card.sequence.steps.size(); ++s) {
    const auto triangles = card.triangles(s);
    const double error = collapsed_error(card.surface, card.sequence, s);
    double worst = 0;
    for (const Eigen::Vector3f& p : card.mesh.positions)
      worst = std::max(worst, distance_from(card.mesh, triangles, p));
    EXPECT_LE(worst, error + 1.0e-6) << s;
    EXPECT_GE(card.sequence.steps[s - 1].error, before) << s;
    before = card.sequence.steps[s - 1].error;
  }
  EXPECT_GT(before, 0.001);
}

/// Without corners nothing is fixed, and an ear that is cut off is nobody's move.
TEST(CollapsePatch, TheErrorCountsEveryPointOfARoundPiece) {
  constexpr std::uint32_t kSides = 12;
  importer::SourceMesh disc;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const float angle = 6.2831853f * float(i) / float(kSides);
    disc.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
    disc.uvs.emplace_back(std::cos(angle), std::sin(angle));
    if (i >= 2) disc.triangles.insert(disc.triangles.end(), {0, i - 1, i});
  }
  const Collapsed result = collapsed(disc, {.largest_error = 10, .fewest_share = 0});
  ASSERT_GT(result.sequence.steps.size(), 4u);
  for (std::size_t s = 0; s <= result.sequence.steps.size(); ++s) {
    const auto triangles = result.triangles(s);
    ASSERT_FALSE(triangles.empty());
    double worst = 0;
    for (const Eigen::Vector3f& p : disc.positions) worst = std::max(worst, distance_from(result.mesh, triangles, p));
    EXPECT_LE(worst, collapsed_error(result.surface, result.sequence, s) + 1.0e-6) << s;
  }
}

TEST(CollapsePatch, NoStepIsMadeAboveTheLimit) {
  const importer::SourceMesh bent = make_card({.bend_radius = 0.08f});
  const Collapsed fine = collapsed(bent, {.largest_error = 0.0005, .fewest_share = 0});
  const Collapsed coarse = collapsed(bent, {.largest_error = 0.01, .fewest_share = 0});
  ASSERT_FALSE(fine.sequence.steps.empty());
  EXPECT_LE(fine.sequence.steps.back().error, 0.0005f);
  EXPECT_LT(coarse.sequence.steps.back().triangles_left, fine.sequence.steps.back().triangles_left);
  const Collapsed half = collapsed(bent, {.largest_error = 1, .fewest_share = 0.5});
  EXPECT_GE(half.sequence.steps.back().triangles_left, bent.triangles.size() / 3 / 2 - 2);
}

/// Shorter than what the bend costs at the end, so only its being a corner keeps it.
TEST(CollapsePatch, APointedTipStays) {
  importer::SourceMesh strip = make_card({.columns = 2, .rows = 10, .width = 0.002f, .bend_radius = 0.15f});
  const auto tip = std::uint32_t(strip.positions.size());
  const Eigen::Vector3f end = strip.positions[tip - 2];
  strip.positions.push_back(end + 0.05f * (end - strip.positions[tip - 5]));
  strip.uvs.emplace_back(0.5f, 1.05f);
  strip.triangles.insert(strip.triangles.end(), {tip - 3, tip, tip - 2, tip - 2, tip, tip - 1});
  const Collapsed pointed = collapsed(strip);
  ASSERT_GT(pointed.sequence.steps.back().error, 0.003f);
  for (std::size_t s = 0; s <= pointed.sequence.steps.size(); ++s) {
    const auto triangles = pointed.triangles(s);
    EXPECT_NE(std::ranges::find(triangles, tip), triangles.end()) << s;
  }
}

/// Unrolled into its texture, a card's straight borders only ever lose points along themselves.
TEST(CollapsePatch, BordersStayWhereTheyAre) {
  const Collapsed card = collapsed(make_card({.columns = 6, .rows = 16, .bend_radius = 0.08f}));
  for (std::size_t s = 0; s <= card.sequence.steps.size(); ++s) {
    const auto triangles = card.triangles(s);
    double area = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const auto& uv = card.mesh.uvs;
      const Eigen::Vector2f b = uv[triangles[i + 1]] - uv[triangles[i]], c = uv[triangles[i + 2]] - uv[triangles[i]];
      area += 0.5 * std::abs(double(b.x() * c.y() - b.y() * c.x()));
    }
    EXPECT_NEAR(area, 1, 1.0e-5) << s;
  }
}

TEST(CollapsePatch, NoPieceOfAPatchVanishes) {
  importer::SourceMesh pieces;
  for (int i = 0; i < 5; ++i)
    append_card(make_card({.bend_radius = 0.05f, .root = {0.1f * float(i), 1.6f, 0}}), pieces);
  const Collapsed result = collapsed(pieces);
  std::set<std::size_t> left;
  for (std::uint32_t v : result.coarsest()) left.insert(v / (pieces.positions.size() / 5));
  EXPECT_EQ(left.size(), 5u);
}

TEST(CollapsePatch, HardEdgesDoNotTearTheSurface) {
  const importer::SourceMesh smooth = make_card({});
  importer::SourceMesh flat = smooth;
  split_vertices(flat);
  EXPECT_EQ(collapsed(flat).coarsest().size(), collapsed(smooth).coarsest().size());
}

/// Two halves side by side that share places, but not texture coordinates.
TEST(CollapsePatch, NoTriangleCrossesATextureSeam) {
  importer::SourceMesh halves;
  importer::SourceMesh left = make_card({.columns = 3, .width = 0.04f, .root = {-0.02f, 1.6f, 0}});
  importer::SourceMesh right = make_card({.columns = 3, .width = 0.04f, .root = {0.02f, 1.6f, 0}});
  for (Eigen::Vector2f& uv : right.uvs) uv.x() += 5;
  append_card(left, halves);
  append_card(right, halves);
  const Collapsed result = collapsed(halves);
  const auto triangles = result.coarsest();
  EXPECT_LT(triangles.size(), halves.triangles.size() / 4);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const auto is_right = [&](std::size_t k) { return result.mesh.uvs[triangles[i + k]].x() > 2; };
    EXPECT_TRUE(is_right(0) == is_right(1) && is_right(1) == is_right(2));
  }
}

TEST(CollapsePatch, NoTriangleTurnsOver) {
  const Collapsed card = collapsed(make_card({.columns = 5, .rows = 9}));
  for (std::size_t s = 0; s <= card.sequence.steps.size(); ++s) {
    const auto triangles = card.triangles(s);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const auto& p = card.mesh.positions;
      const Eigen::Vector3f& a = p[triangles[i]];
      EXPECT_GT((p[triangles[i + 1]] - a).cross(p[triangles[i + 2]] - a).z(), 0) << s;
    }
  }
}

/// A straight strip may lose every row, unless bones bend it.
TEST(CollapsePatch, RowsThatBonesBendStay) {
  HairMesh mesh = hair_from(make_card({.columns = 1, .rows = 12}));
  Pose bent = mesh.positions;
  for (Eigen::Vector3f& p : bent) {
    const float below = std::max(0.0f, 1.45f - p.y());  // a hinge halfway down
    p += Eigen::Vector3f(0, 0.3f * below, 0.7f * below);
  }
  const CollapseLimits limits{.largest_error = 0.001, .fewest_share = 0};
  const std::vector<Pose> rest = {mesh.positions}, both = {mesh.positions, bent};
  EXPECT_EQ(collapse_patch(surface_of(mesh, rest), limits).steps.back().triangles_left, 2u);
  EXPECT_EQ(collapse_patch(surface_of(mesh, both), limits).steps.back().triangles_left, 4u);
}

TEST(TriangleDistance, IsThatOfTheNearestOfManyPointsOnIt) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] { return Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random)); };
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p = 2 * point(), a = point(), b = point(), c = i % 10 == 0 ? Eigen::Vector3d(b) : point();
    double nearest = INFINITY;
    for (int u = 0; u <= 60; ++u) {
      for (int v = 0; v + u <= 60; ++v) {
        nearest = std::min(nearest, (a + (b - a) * u / 60.0 + (c - a) * v / 60.0 - p).norm());
      }
    }
    const double distance = std::sqrt(squared_distance(p, a, b, c));
    EXPECT_LE(distance, nearest + 1.0e-9);
    EXPECT_GE(distance, nearest - 0.06);
  }
}

TEST(CollapsePatch, EndsWhenAskedToStop) {
  const Collapsed card = collapsed(make_card({}));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)collapse_patch(card.surface, kNoLimit, stop.get_token()), platform::Stopped);
}

}  // namespace coif::cook::collapse_patch_test
