// What lies before what along the lines of a view, on cards whose order is known.

#include "visibility/fragment_view.h"
#include "models/card_asset.h"

#include <coif/view_cells.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace coif::visibility::fragment_view_test {

struct View {
  explicit View(const AssetContents& contents, const ViewGrid& grid = {})
      : opened(contents), hair(opened.asset()), view(hair, posed_positions(opened.asset(), {}), grid) {}

  [[nodiscard]] std::size_t lines_with(std::size_t fragments) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < view.line_count(); ++i) count += view.line(i).size() == fragments ? 1 : 0;
    return count;
  }

  lab::OpenedAsset opened;
  HairSurface hair;
  FragmentView view;
};

AssetContents two_cards() {
  return card_contents(
      std::array<Card, 2>{Card{.center = {0, 0, 0.1f}, .alpha = 51}, Card{.center = {0, 0, -0.1f}, .alpha = 204}});
}

TEST(FragmentView, NearestComesFirstFromEachSide) {
  for (const float side : {1.0f, -1.0f}) {
    const View v(two_cards(), {.towards_eye = {0, 0, side}});
    ASSERT_GT(v.lines_with(2), 100u);
    for (std::size_t i = 0; i < v.view.line_count(); ++i) {
      const auto line = v.view.line(i);
      if (line.empty()) continue;
      ASSERT_EQ(line.size(), 2u);
      EXPECT_EQ(line[0].patch, side > 0 ? 0u : 1u);
      EXPECT_FLOAT_EQ(line[0].depth, -0.1f);
      EXPECT_FLOAT_EQ(line[1].depth, 0.1f);
      EXPECT_EQ(line[0].is_front, side > 0) << "cards turn their fronts to +Z";
      EXPECT_NEAR(line[0].alpha, side > 0 ? 0.2f : 0.8f, 1.0e-6f);
    }
  }
}

TEST(FragmentView, TrianglesOfACardNeitherOverlapNorLeaveGaps) {
  for (const float turn : {0.0f, 0.3f, 0.785398f, 1.2f}) {
    const Eigen::Vector3f right(0.1f * std::cos(turn), 0.1f * std::sin(turn), 0);
    const Eigen::Vector3f up(-right.y(), right.x(), 0);
    const View v(card_contents(std::array<Card, 1>{Card{.right = right, .up = up}}), {.spacing = 0.002f});
    EXPECT_EQ(v.lines_with(0) + v.lines_with(1), v.view.line_count()) << turn;
    EXPECT_NEAR(double(v.lines_with(1)), 100 * 100, 250) << "its area of 0.2 m by 0.2 m at " << turn;
  }
}

TEST(FragmentView, WhatIsTooFaintToBeDrawnIsNotThere) {
  AssetContents contents = two_cards();
  contents.material[0].discard_threshold = 0.5f;
  const View v(contents);
  EXPECT_EQ(v.lines_with(2), 0u);
  EXPECT_GT(v.lines_with(1), 100u);
}

TEST(FragmentView, OneSidedHairHasNoBackFaces) {
  AssetContents contents = two_cards();
  contents.material[0].flags = 0;
  EXPECT_GT(View(contents).lines_with(2), 100u);
  const View behind(contents, {.towards_eye = {0, 0, -1}});
  EXPECT_EQ(behind.lines_with(0), behind.view.line_count());
}

TEST(FragmentView, TheMaterialsAlphaCounts) {
  AssetContents contents = two_cards();
  contents.material[0].base_color[3] = 0.5f;
  const View v(contents);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < v.view.line_count(); ++i) {
    if (v.view.line(i).empty()) continue;
    ++seen;
    EXPECT_NEAR(v.view.line(i)[0].alpha, 0.1f, 1.0e-6f);
  }
  EXPECT_GT(seen, 100u);
}

TEST(FragmentView, CollidersHideWhatIsBehindThem) {
  AssetContents contents = two_cards();
  add_ball(contents, {0, 0, 0}, 0.05f);
  const View v(contents);
  float nearest = std::numeric_limits<float>::infinity();
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < v.view.line_count(); ++i) {
    nearest = std::min(nearest, v.view.solid_depth(i));
    hidden += std::isfinite(v.view.solid_depth(i)) ? 1 : 0;
  }
  EXPECT_NEAR(nearest, -0.05f, 1.0e-3f);
  const double lines_per_square_metre = 1 / (0.004 * 0.004);
  EXPECT_NEAR(double(hidden), 3.14159 * 0.05 * 0.05 * lines_per_square_metre, 30);
  EXPECT_EQ(v.view.transmittance({0, 0, -0.08f}, 0), 0.0f);
  EXPECT_GT(v.view.transmittance({0, 0.08f, -0.08f}, 0), 0.0f) << "beside the ball";
}

TEST(FragmentView, TransmittanceIsWhatTheCardsBeforeAPointLetThrough) {
  const View v(two_cards());
  EXPECT_EQ(v.view.transmittance({0, 0, 0.2f}, 0), 1.0f);
  EXPECT_NEAR(v.view.transmittance({0, 0, 0}, 0), 0.8f, 1.0e-6f);
  EXPECT_NEAR(v.view.transmittance({0, 0, -0.2f}, 0), 0.8f * 0.2f, 1.0e-6f);
  EXPECT_NEAR(v.view.transmittance({0, 0, -0.1f}, 0.01f), 0.8f, 1.0e-6f) << "a card does not shade itself";
  EXPECT_EQ(v.view.transmittance({0.5f, 0, -1}, 0), 1.0f) << "outside of the grid";
}

/// Alpha alternates from texel to texel; mips have its mean.
AssetContents striped_card() {
  AssetContents contents = card_contents(std::array<Card, 1>{Card{}});
  contents.texels.clear();
  contents.textures[0].mip_count = 9;
  std::uint32_t width = 256;
  for (std::uint32_t mip = 0; mip < 9; ++mip, width /= 2) {
    for (std::uint32_t i = 0; i < width; ++i) {
      const int alpha = mip > 0 ? 100 : i % 2 == 0 ? 0 : 200;
      contents.texels.insert(contents.texels.end(), {std::byte{1}, std::byte{1}, std::byte{1}, std::byte(alpha)});
    }
  }
  contents.textures[0].bytes = contents.texels.size();
  for (std::size_t i = 0; i < 4; ++i) contents.vertices[i].uv[0] = i == 0 || i == 3 ? 0.0f : 1.0f;
  return contents;
}

TEST(FragmentView, MipsFitThePixelNotTheGrid) {
  const auto spread = [](float pixel) {
    const View v(striped_card(), {.spacing = 0.003f, .pixel = pixel});
    float low = 1, high = 0;
    for (std::size_t i = 0; i < v.view.line_count(); ++i) {
      for (const Fragment& fragment : v.view.line(i)) {
        low = std::min(low, fragment.alpha);
        high = std::max(high, fragment.alpha);
      }
    }
    return high - low;
  };
  const float texel = 0.2f / 256;
  EXPECT_GT(spread(0.5f * texel), 0.5f);
  EXPECT_LT(spread(2.1f * texel), 1.0e-5f);
}

SightLines lines_of(const AssetContents& contents, float solid_alpha = 0.95f) {
  const lab::OpenedAsset opened(contents);
  const HairSurface hair(opened.asset());
  return {FragmentView(hair, posed_positions(opened.asset(), {}), {.solid_alpha = solid_alpha}), solid_alpha};
}

AssetContents stack_of(std::initializer_list<int> alphas) {
  std::vector<Card> cards;
  for (const int alpha : alphas) cards.push_back({.center = {0, 0, -0.01f * float(cards.size())}, .alpha = alpha});
  return card_contents(cards);
}

TEST(SightLines, HaveTheLayersNearestFirst) {
  const SightLines lines = lines_of(stack_of({100, 150, 200}));
  ASSERT_GT(lines.size(), 100u);
  EXPECT_EQ(lines.size(), lines.covered);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_EQ(lines.line(i).size(), 3u);
    for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(lines.line(i)[k].triangle / 2, k);
  }
}

TEST(SightLines, EndAtSolidLayersAtTheHeadAndWhereLittleLightIsLeft) {
  EXPECT_EQ(lines_of(stack_of({100, 250, 200})).line(0).size(), 2u);
  EXPECT_EQ(lines_of(stack_of({100, 250, 200}), 1).line(0).size(), 3u);
  EXPECT_EQ(lines_of(stack_of({240, 240, 240, 240}), 1).line(0).size(), 3u) << "a four thousandth passes three";
  AssetContents contents = stack_of({100, 100, 100});
  add_ball(contents, {0, 0, -1.015f}, 1);
  EXPECT_EQ(lines_of(contents).line(lines_of(contents).size() / 2).size(), 2u);
}

TEST(SightLines, LeaveOutLinesOnWhichNothingCanBeWrongButCountThem) {
  const SightLines lines = lines_of(stack_of({255, 100}));
  EXPECT_EQ(lines.size(), 0u);
  EXPECT_GT(lines.covered, 100u);
}

TEST(SightLines, WhatSolidFragmentsHideIsNotEvenFound) {
  const lab::OpenedAsset opened(stack_of({100, 250, 200}));
  const HairSurface hair(opened.asset());
  const auto positions = posed_positions(opened.asset(), {});
  const FragmentView all(hair, positions, {}), cut(hair, positions, {.solid_alpha = 0.95f});
  ASSERT_EQ(all.line_count(), cut.line_count());
  for (std::size_t i = 0; i < all.line_count(); ++i) {
    const std::size_t kept = all.line(i).empty() ? 0 : 2;
    ASSERT_EQ(cut.line(i).size(), kept);
    for (std::size_t k = 0; k < kept; ++k) EXPECT_EQ(cut.line(i)[k].triangle, all.line(i)[k].triangle);
  }
}

/// Cards of all sizes and directions around a ball, some of them solid.
AssetContents thicket() {
  std::uint32_t seed = 7;
  const auto chance = [&] {
    seed = seed * 1664525u + 1013904223u;
    return float(seed >> 8) / float(1u << 24);
  };
  const auto anywhere = [&] { return Eigen::Vector3f(chance() - 0.5f, chance() - 0.5f, chance() - 0.5f); };
  std::vector<Card> cards;
  for (int i = 0; i < 300; ++i) {
    const float side = i % 3 == 0 ? 0.1f : 0.01f;
    const int alpha = int(40 + 240 * chance());
    cards.push_back({0.3f * anywhere(), side * anywhere(), 0.3f * side * anywhere(), std::min(alpha, 255)});
  }
  AssetContents contents = card_contents(cards);
  add_ball(contents, {0.02f, 0, 0}, 0.08f);
  return contents;
}

TEST(FragmentView, LeavesOutWhatIsHiddenAndNothingElse) {
  constexpr float kSolid = 0.95f;
  const lab::OpenedAsset opened(thicket());
  const HairSurface hair(opened.asset());
  const auto positions = posed_positions(opened.asset(), {});
  std::size_t kept = 0, left_out = 0;
  for (std::uint32_t cell = 0; cell < kViewCells; cell += 5) {
    ViewGrid grid{.towards_eye = direction_in_cell(cell, 0)};
    const FragmentView all(hair, positions, grid);
    grid.solid_alpha = kSolid;
    grid.past_head = false;
    const FragmentView cut(hair, positions, grid);
    ASSERT_EQ(all.line_count(), cut.line_count());
    for (std::size_t i = 0; i < all.line_count(); ++i) {
      std::size_t k = 0;
      for (const Fragment& fragment : all.line(i)) {
        if (fragment.depth > all.solid_depth(i) - 1.0e-5f) break;
        ASSERT_LT(k, cut.line(i).size());
        EXPECT_EQ(cut.line(i)[k].triangle, fragment.triangle);
        EXPECT_EQ(cut.line(i)[k].depth, fragment.depth);
        EXPECT_EQ(cut.line(i)[k].alpha, fragment.alpha);
        ++k;
        if (fragment.alpha >= kSolid) break;
      }
      kept += k;
      left_out += all.line(i).size() - cut.line(i).size();
      for (const Fragment& fragment : cut.line(i)) EXPECT_LE(fragment.depth, all.solid_depth(i) + 1.0e-5f);
    }
  }
  EXPECT_GT(kept, 1000u);
  EXPECT_GT(left_out, 1000u);
}

TEST(SolidsAlong, AreWhereEachLineFirstMeetsOneOfThem) {
  std::vector<ColliderRecord> solids(3);
  solids[0].shape = ColliderShape::kEllipsoid;
  std::ranges::copy(std::array{0.0f, 0.05f, 0.0f}, solids[0].center);
  std::ranges::copy(std::array{0.08f, 0.1f, 0.09f}, solids[0].radii);
  std::ranges::copy(std::array{0.0f, 0.6f, 0.0f, 0.8f}, solids[0].rotation);
  solids[1].shape = ColliderShape::kCapsule;
  std::ranges::copy(std::array{0.0f, -0.1f, 0.0f}, solids[1].center);
  std::ranges::copy(std::array{0.0f, 0.1f, 0.02f}, solids[1].axis);
  std::ranges::copy(std::array{0.05f, 0.05f, 0.05f}, solids[1].radii);
  solids[2].shape = ColliderShape::kSphere;
  std::ranges::copy(std::array{0.07f, 0.0f, 0.0f}, solids[2].center);
  std::ranges::copy(std::array{0.04f, 0.04f, 0.04f}, solids[2].radii);
  std::ranges::copy(std::array{0.0f, 0.0f, 0.0f, 1.0f}, solids[2].rotation);
  std::size_t met = 0;
  for (std::uint32_t cell = 0; cell < kViewCells; cell += 3) {
    const Eigen::Vector3f along = direction_in_cell(cell, 0);
    const SolidsAlong from(solids, along);
    for (const float x : {-0.06f, 0.0f, 0.03f, 0.09f}) {
      const Eigen::Vector3f origin(x, 0.5f * x, 0.02f);
      const float expected = solid_depth(solids, origin, along), depth = from.depth(origin);
      EXPECT_EQ(std::isfinite(depth), std::isfinite(expected));
      if (!std::isfinite(expected)) continue;
      EXPECT_NEAR(depth, expected, 1.0e-4f);
      ++met;
    }
  }
  EXPECT_GT(met, 50u);
}

TEST(SampledViews, DirectionsFillTheirCells) {
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
    float middle[3];
    view_cell_direction(cell, middle);
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (std::uint32_t i = 0; i < 64; ++i) {
      const Eigen::Vector3f d = direction_in_cell(cell, i);
      const float direction[3] = {d.x(), d.y(), d.z()};
      EXPECT_EQ(view_cell(direction), cell);
      mean += d / 64;
    }
    EXPECT_GT(mean.normalized().dot(Eigen::Map<Eigen::Vector3f>(middle)), 0.999f);
    EXPECT_LT(mean.norm(), 0.999f) << "they are not all the same";
  }
}

TEST(SampledViews, EveryCellHasEveryPoseAndThreadsDoNotMatter) {
  const lab::OpenedAsset opened(stack_of({100, 150}));
  const HairSurface hair(opened.asset());
  std::vector<HairPositions> poses(3, posed_positions(opened.asset(), {}));
  for (Eigen::Vector3f& p : poses[1]) p.x() += 0.01f;
  SampleSettings settings;
  settings.views_per_cell = 6;
  settings.lines = 200;
  const std::vector<SampledView> one = sample_views(hair, poses, settings);
  settings.threads = 3;
  const std::vector<SampledView> three = sample_views(hair, poses, settings);
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (std::size_t i = 0; i < one.size(); ++i) {
    seen.insert({one[i].cell, one[i].pose});
    EXPECT_EQ(one[i].lines.begin, three[i].lines.begin);
  }
  EXPECT_EQ(seen.size(), 3 * kViewCells);
}

}  // namespace coif::visibility::fragment_view_test
