// Which pairs of layers vote, and with what weight.

#include "visibility/order_votes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace coif {
namespace {

/// One line with these layers, nearest first.
SightLines line_of(std::initializer_list<Layer> layers) {
  SightLines lines;
  lines.layers = layers;
  lines.begin = {0, std::uint32_t(layers.size())};
  lines.covered = 1;
  return lines;
}

Layer layer(std::uint32_t triangle, float alpha, bool is_front = true) {
  return {alpha, triangle & 0xFFu, is_front ? 1u : 0u};
}

const std::vector<std::uint32_t> kOwnUnits = {0, 1, 2, 3};
const DrawRule kApart{0.95f, false}, kTogether{0.95f, true};

TEST(OrderVotes, WhatIsFurtherComesFirst) {
  const auto votes = votes_of(line_of({layer(2, 0.5f), layer(1, 0.4f)}), kOwnUnits, kApart);
  ASSERT_EQ(votes.size(), 1u);
  EXPECT_EQ(votes[0].first, 1u);
  EXPECT_EQ(votes[0].second, 2u);
  EXPECT_FLOAT_EQ(votes[0].weight, 0.2f * 0.2f) << "the square of both alphas";
  const auto other = votes_of(line_of({layer(1, 0.5f), layer(2, 0.4f)}), kOwnUnits, kApart);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_FLOAT_EQ(other[0].weight, -0.04f) << "against the lower number first";
}

TEST(OrderVotes, LayersBeforeAndBetweenDimThem) {
  const auto votes = votes_of(line_of({layer(0, 0.5f), layer(1, 0.4f), layer(2, 0.2f)}), kOwnUnits, kApart);
  ASSERT_EQ(votes.size(), 3u);
  EXPECT_FLOAT_EQ(votes[0].weight, -0.04f) << "0 over 1";
  EXPECT_FLOAT_EQ(votes[1].weight, -(0.5f * 0.6f * 0.2f) * (0.5f * 0.6f * 0.2f)) << "0 over 2, behind 1";
  EXPECT_FLOAT_EQ(votes[2].weight, -(0.5f * 0.4f * 0.2f) * (0.5f * 0.4f * 0.2f)) << "1 over 2, both behind 0";
}

TEST(OrderVotes, FacesDrawnApartDoNotVoteOnEachOther) {
  const SightLines lines = line_of({layer(0, 0.5f, true), layer(1, 0.5f, false), layer(2, 0.5f, true)});
  const auto apart = votes_of(lines, kOwnUnits, kApart);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_EQ(apart[0].first, 0u);
  EXPECT_EQ(apart[0].second, 2u);
  EXPECT_EQ(votes_of(lines, kOwnUnits, kTogether).size(), 3u);
}

TEST(OrderVotes, OfGroupsAreThoseOfTheirMembers) {
  const SightLines lines = line_of({layer(2, 0.5f), layer(0, 0.4f), layer(3, 0.7f), layer(1, 0.2f)});
  const std::vector<std::uint32_t> groups = {1, 0, 0, 1};
  const auto of_groups = votes_of_groups(votes_of(lines, kOwnUnits, kTogether), groups);
  const auto wanted = votes_of(lines, groups, kTogether);
  ASSERT_EQ(of_groups.size(), 1u);
  ASSERT_EQ(wanted.size(), 1u);
  EXPECT_EQ(of_groups[0].first, wanted[0].first);
  EXPECT_EQ(of_groups[0].second, wanted[0].second);
  EXPECT_FLOAT_EQ(of_groups[0].weight, wanted[0].weight);
}

TEST(OrderVotes, AUnitDoesNotVoteOnItself) {
  const std::vector<std::uint32_t> units = {0, 0, 1, 1};
  EXPECT_TRUE(votes_of(line_of({layer(0, 0.5f), layer(1, 0.5f)}), units, kApart).empty());
  EXPECT_EQ(votes_of(line_of({layer(0, 0.5f), layer(1, 0.5f), layer(3, 0.5f)}), units, kApart).size(), 1u);
}

TEST(OrderVotes, SolidLayersAreSortedByDepthAndHideWhatIsBehind) {
  const SightLines lines = line_of({layer(0, 0.5f), layer(1, 0.96f), layer(2, 0.5f)});
  EXPECT_TRUE(votes_of(lines, kOwnUnits, kApart).empty());
  EXPECT_EQ(votes_of(lines, kOwnUnits, {0.97f, false}).size(), 3u) << "none is solid";
}

TEST(OrderVotes, VotesOfAPairAddUpAndMayCancel) {
  const std::vector<std::vector<Vote>> lists = {{{0, 1, 2.0f}, {1, 2, 1.0f}}, {{0, 1, -2.0f}, {1, 2, 0.5f}}};
  const auto sum = sum_of(lists);
  ASSERT_EQ(sum.size(), 1u);
  EXPECT_EQ(sum[0].first, 1u);
  EXPECT_FLOAT_EQ(sum[0].weight, 1.5f);
}

TEST(OrderError, OnlyTheOrderByDepthIsExact) {
  const SightLines lines = line_of({layer(0, 0.5f), layer(1, 0.4f), layer(2, 0.3f)});
  EXPECT_NEAR(squared_error(lines, std::vector<std::uint32_t>{2, 1, 0}, kApart), 0, 1.0e-12);
  const double swapped = squared_error(lines, std::vector<std::uint32_t>{1, 2, 0}, kApart);
  EXPECT_NEAR(swapped, 2 * 0.2 * 0.2, 1.0e-6) << "two layers' shares each off by the product of their alphas";
  EXPECT_GT(squared_error(lines, std::vector<std::uint32_t>{0, 1, 2}, kApart), swapped);
}

TEST(OrderError, BackFacesBeforeFrontFacesMayBeWrong) {
  const SightLines lines = line_of({layer(0, 0.5f, false), layer(1, 0.5f, true)});
  const std::vector<std::uint32_t> by_depth = {1, 0};
  EXPECT_NEAR(squared_error(lines, by_depth, kTogether), 0, 1.0e-12);
  EXPECT_NEAR(squared_error(lines, by_depth, kApart), 2 * 0.25 * 0.25, 1.0e-6);
}

TEST(OrderError, SolidLayersHideWhatTheirAlphaLetsThrough) {
  const SightLines lines = line_of({layer(0, 0.5f), layer(1, 0.96f), layer(2, 0.9f)});
  const std::vector<std::uint32_t> any = {0, 1, 2};
  const double error = squared_error(lines, any, kApart);
  EXPECT_NEAR(error, (1 + kHiddenVariance) * 0.02 * 0.02, 1.0e-6);
  EXPECT_NEAR(threshold_error(lines, 0.95f), error, 1.0e-12) << "and no order helps";
  EXPECT_EQ(threshold_error(lines, 0.97f), 0);
}

TEST(OrderError, PsnrFallsByTenPerTenfoldError) {
  EXPECT_NEAR(psnr_db(0.1, 10) - psnr_db(1, 10), 10, 1.0e-9);
  EXPECT_NEAR(psnr_db(1, 100), psnr_db(0.1, 10), 1.0e-9);
  EXPECT_EQ(psnr_db(0, 10), 99);
  EXPECT_EQ(psnr_db(0, 0), 99);
}

}  // namespace
}  // namespace coif
