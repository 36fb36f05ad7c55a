#include "groom/strand_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coif::groom::join_lines_test {

using Line = std::vector<std::uint32_t>;

std::vector<Line> joined(const std::vector<Line>& lines, std::size_t vertices) {
  VertexLines all;
  for (const Line& line : lines) all.add(line);
  const JoinedLines out = joined_lines(all, vertices);
  std::vector<Line> strands;
  for (std::size_t i = 0; i < out.strands.count(); ++i) {
    const auto strand = out.strands.line(i);
    strands.emplace_back(strand.begin(), strand.end());
  }
  return strands;
}

TEST(JoinedLines, GoOnWhereTwoMeetEndToEnd) {
  EXPECT_EQ(joined({{0, 1}, {1, 2}, {2, 3}}, 4), (std::vector<Line>{{0, 1, 2, 3}}));
  EXPECT_EQ(joined({{2, 3}, {1, 2}, {0, 1}}, 4), (std::vector<Line>{{0, 1, 2, 3}}));
  EXPECT_EQ(joined({{1, 0}, {1, 2}, {3, 2}}, 4), (std::vector<Line>{{3, 2, 1, 0}}));
  EXPECT_EQ(joined({{0, 1}, {2, 3}}, 4), (std::vector<Line>{{0, 1}, {2, 3}}));
}

TEST(JoinedLines, StopWhereMoreThanTwoMeetOrOneGoesThrough) {
  EXPECT_EQ(joined({{0, 1}, {1, 2}, {1, 3}}, 4), (std::vector<Line>{{0, 1}, {1, 2}, {1, 3}}));
  EXPECT_EQ(joined({{0, 1, 2}, {1, 3}}, 4), (std::vector<Line>{{0, 1, 2}, {1, 3}}));
}

TEST(JoinedLines, RingsEndWhereTheyBegin) {
  EXPECT_EQ(joined({{0, 1}, {1, 2}, {2, 0}}, 3), (std::vector<Line>{{0, 1, 2, 0}}));
  EXPECT_EQ(joined({{0, 1, 0}}, 2), (std::vector<Line>{{0, 1, 0}}));
  EXPECT_EQ(joined({{0, 0}}, 1), (std::vector<Line>{{0, 0}}));
}

/// However strands are cut into segments, and in whatever order and direction these come, they are the same strands
/// again.
TEST(JoinedLines, SegmentsInAnyOrderAreTheStrandsAgain) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<Line> strands, segments;
    std::uint32_t next = 0;
    for (int s = 0; s < 20; ++s) {
      Line strand;
      for (std::uint32_t k = 0; k < 2 + random() % 8; ++k) strand.push_back(next++);
      for (std::size_t k = 0; k + 1 < strand.size(); ++k) {
        segments.push_back({strand[k], strand[k + 1]});
        if (random() % 2 != 0) std::swap(segments.back()[0], segments.back()[1]);
      }
      strands.push_back(strand);
    }
    std::shuffle(segments.begin(), segments.end(), random);
    std::vector<Line> found = joined(segments, next);
    for (Line& strand : found) {
      if (strand.front() > strand.back()) std::ranges::reverse(strand);
    }
    std::ranges::sort(found);
    EXPECT_EQ(found, strands);
  }
}

}  // namespace coif::groom::join_lines_test
