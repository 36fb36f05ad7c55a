#include "visibility/sight_lines.h"

#include "visibility/card_asset.h"
#include "visibility/view_samples.h"

#include <coif/view_cells.h>

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace coif {
namespace {

SightLines lines_of(const AssetContents& contents, float solid_alpha = 0.95f) {
  const OpenedAsset opened(contents);
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
  const OpenedAsset opened(stack_of({100, 250, 200}));
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

TEST(ViewSamples, DirectionsFillTheirCells) {
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

TEST(ViewSamples, EveryCellHasEveryPoseAndThreadsDoNotMatter) {
  const OpenedAsset opened(stack_of({100, 150}));
  const HairSurface hair(opened.asset());
  std::vector<HairPositions> poses(3, posed_positions(opened.asset(), {}));
  for (Eigen::Vector3f& p : poses[1]) p.x() += 0.01f;
  SampleSettings settings;
  settings.views_per_cell = 6;
  settings.lines = 200;
  const ViewSamples one = sample_views(hair, poses, settings);
  settings.threads = 3;
  const ViewSamples three = sample_views(hair, poses, settings);
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (std::size_t i = 0; i < one.views.size(); ++i) {
    seen.insert({one.views[i].cell, one.views[i].pose});
    EXPECT_EQ(one.views[i].lines.begin, three.views[i].lines.begin);
  }
  EXPECT_EQ(seen.size(), 3 * kViewCells);
}

}  // namespace
}  // namespace coif
