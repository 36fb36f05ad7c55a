#include "cards/even_strands.h"

#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cards::even_strands_test {

constexpr float kWidth = 0.0001f;

TEST(EvenStrands, HavePointsAtEvenSharesOfTheirLength) {
  // Points where they are not even: the shape is what counts.
  const groom::Groom groom =
      test::groom_of({{{0, 0, 0}, {0, -0.01f, 0}, {0, -0.2f, 0}, {0.1f, -0.2f, 0}}, {{0, 0, 1}, {0, 0, 2}}});
  const EvenStrands even = even_strands(groom, kWidth);
  ASSERT_EQ(even.count(), 2u);
  EXPECT_NEAR(even.lengths[0], 0.3f, 1e-6f);
  const auto bent = even.strand(0);
  for (std::size_t k = 0; k < EvenStrands::kStations; ++k) {
    const float along = 0.3f * float(k) / float(EvenStrands::kStations - 1);
    const Eigen::Vector3f wanted =
        along < 0.2f ? Eigen::Vector3f(0, -along, 0) : Eigen::Vector3f(along - 0.2f, -0.2f, 0);
    EXPECT_LT((bent[k] - wanted).norm(), 1e-6f) << k;
  }
  EXPECT_EQ(even.strand(1).front(), Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(even.strand(1).back(), Eigen::Vector3f(0, 0, 2));
}

TEST(EvenStrands, BeginWithRootsWhereThatIsSaid) {
  const groom::Groom groom = test::groom_of({{{0, 0, 0}, {0, -1, 0}}});
  const std::uint8_t reversed = 1;
  const EvenStrands even = even_strands(groom, kWidth, std::span(&reversed, 1));
  EXPECT_EQ(even.strand(0).front(), Eigen::Vector3f(0, -1, 0));
  EXPECT_EQ(even.strand(0).back(), Eigen::Vector3f(0, 0, 0));
}

/// Whatever order a file has them in, roots are those that lie on the scalp.
TEST(ReversedStrands, AreThoseWhoseLastPointLiesOnTheScalp) {
  for (const int reversed_of_ten : {0, 2, 8, 10}) {
    auto strands = test::strands_of_a_head(400);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
      if (int(i % 10) >= reversed_of_ten) continue;
      std::ranges::reverse(strands[i]);
      ++expected;
    }
    groom::Groom groom = test::groom_of(strands);
    groom.root_first = false;
    const auto found = find_reversed_strands(groom);
    std::size_t right = 0;
    for (std::size_t i = 0; i < strands.size(); ++i)
      right += (found[i] != 0) == (int(i % 10) < reversed_of_ten) ? 1 : 0;
    EXPECT_GE(double(right), 0.97 * double(strands.size())) << expected << " reversed";
  }
}

TEST(ReversedStrands, AreNoneInFormatsThatBeginWithRoots) {
  auto strands = test::strands_of_a_head(50);
  for (auto& strand : strands) std::ranges::reverse(strand);
  const auto found = find_reversed_strands(test::groom_of(strands));
  EXPECT_EQ(std::ranges::count(found, 0), 50);
}

TEST(ScalpRadius, IsThatOfTheSphereThatRootsLieOn) {
  auto strands = test::strands_of_a_head(400);
  for (std::vector<Eigen::Vector3f>& strand : strands) {
    for (Eigen::Vector3f& point : strand) point *= 35;
  }
  const auto radius_of = [](const auto& some) { return scalp_radius_of(even_strands(test::groom_of(some), 0.001f)); };
  EXPECT_NEAR(radius_of(strands), 3.5, 0.05);
  for (int i = 0; i < 80; ++i) strands.push_back(test::hanging({9 + 0.1f * float(i), 5, 0}, 3));
  EXPECT_NEAR(radius_of(strands), 3.5, 0.05) << "though some grow elsewhere";
}

TEST(ScalpRadius, IsNotToldByALock) {
  EXPECT_EQ(scalp_radius_of(even_strands(test::hanging_wisps(3, 40), 0.001f)), 0);
  EXPECT_EQ(scalp_radius_of(EvenStrands{}), 0);
}

}  // namespace coif::cards::even_strands_test
