#include "cards/hair_picture.h"

#include "cards/made_up_cards.h"
#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

namespace coif::cards::card_picture_test {

constexpr float kWidth = 0.002f;

struct MadeCards {
  MadeCards(const groom::Groom& groom, std::size_t count, std::size_t triangles)
      : cards(test::unfitted_cards(groom, kWidth, count, triangles, std::size_t{1} << 19)),
        surface(surface_of(cards)) {}
  Cards cards;
  CardSurface surface;
};

TEST(CardStrips, TakeTheTrianglesThereAreWhereStripsBend) {
  auto strands = test::strands_of_a_head(300);
  for (int i = 0; i < 100; ++i) strands.push_back(test::hanging({1 + 0.0005f * float(i), 0, 0}, 0.3f));
  const EvenStrands even = even_strands(test::groom_of(strands), kWidth);
  const auto wisps = find_wisps(even, 30, 2);
  for (const std::size_t triangles : {60u, 200u, 500u}) {
    const auto strips = make_strips(wisps, triangles);
    std::size_t made = 0;
    for (const CardStrip& strip : strips) {
      made += strip.triangles();
      EXPECT_EQ(strip.stations.front(), 0);
      EXPECT_EQ(strip.stations.back(), Ribbon::kStations - 1);
      EXPECT_TRUE(std::ranges::is_sorted(strip.stations));
      const bool hangs_straight = wisps[strip.wisp].members.front() >= 300;
      if (hangs_straight) {
        EXPECT_EQ(strip.triangles(), 2u) << "a straight one needs no more";
      }
    }
    EXPECT_LE(made, triangles);
    EXPECT_GE(made + 2, triangles);
  }
  EXPECT_EQ(make_strips(wisps, 0).size(), wisps.size()) << "one quad each is the least";
}

/// Mean over the stations, metres squared.
double off_ribbon(const Ribbon& ribbon, const CardStrip& strip, std::span<const std::array<Eigen::Vector3f, 2>> edges) {
  double sum = 0;
  std::size_t e = 0;
  for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
    if (k > strip.stations[e + 1]) ++e;
    const float share = float(k - strip.stations[e]) / float(strip.stations[e + 1] - strip.stations[e]);
    const auto wanted = edge_at(ribbon, k);
    for (std::size_t side = 0; side < 2; ++side) {
      sum += double((edges[e][side] + share * (edges[e + 1][side] - edges[e][side]) - wanted[side]).squaredNorm());
    }
  }
  return sum / double(Ribbon::kStations);
}

TEST(CardStrips, LieNearerToABendThanItsChords) {
  const EvenStrands even = even_strands(test::groom_of(test::strands_of_a_head(300)), kWidth);
  const auto wisps = find_wisps(even, 30, 2);
  double fitted = 0, chords = 0;
  for (const CardStrip& strip : make_strips(wisps, 160)) {
    const Ribbon& ribbon = wisps[strip.wisp].ribbon;
    std::vector<std::array<Eigen::Vector3f, 2>> on_it;
    for (const std::uint8_t station : strip.stations) on_it.push_back(edge_at(ribbon, station));
    const auto edges = edges_of(ribbon, strip);
    ASSERT_EQ(edges.size(), on_it.size());
    fitted += off_ribbon(ribbon, strip, edges);
    chords += off_ribbon(ribbon, strip, on_it);
  }
  EXPECT_GT(chords, 0);
  EXPECT_LT(fitted, 0.6 * chords);
}

TEST(CardTexture, CoversWhatStrandsCoverOfTheFlatCard) {
  const groom::Groom groom = test::hanging_wisps(1, 12);
  const MadeCards cards(groom, 1, 2);
  ASSERT_EQ(cards.cards.wisps.size(), 1u);
  const PictureFrame frame = frame_along({0, 0, -1}, ball_around(groom.points), 256);
  const HairPicture flat = draw_strands(groom, frame, kWidth, 2);
  const double pixels = std::accumulate(flat.coverage.begin(), flat.coverage.end(), 0.0) /
                        double(frame.pixels_of_metre * frame.pixels_of_metre);
  const CardTexture& texture = cards.cards.textures[0];
  const double share =
      std::accumulate(texture.opacity.begin(), texture.opacity.end(), 0.0) / double(texture.opacity.size());
  const double card = 2 * double(cards.cards.wisps[0].ribbon.half_width[5]) * 0.3;
  EXPECT_NEAR(share * card / pixels, 1, 0.08);
  for (std::size_t i = 0; i < texture.opacity.size(); ++i) {
    ASSERT_GE(texture.opacity[i], 0);
    ASSERT_LE(texture.opacity[i], 1);
    if (texture.opacity[i] > 0) {
      ASSERT_GT(texture.along[i].y(), 0.99f) << "strands hang along the card";
    }
  }
}

TEST(CardPicture, CardsOfFlatWispsLookLikeTheirStrands) {
  const groom::Groom groom = test::hanging_wisps(5, 40);
  const MadeCards cards(groom, 5, 20);
  for (const Eigen::Vector3f& direction :
       {Eigen::Vector3f(0, 0, -1), Eigen::Vector3f(0.3f, 0.2f, -1), Eigen::Vector3f(0, 0, 1)}) {
    const PictureFrame frame = frame_along(direction, ball_around(groom.points), 192);
    const HairPicture wanted = draw_strands(groom, frame, kWidth, 2);
    const HairPicture seen = draw_cards(cards.surface, frame, 2);
    EXPECT_GT(compare_hair(wanted, seen).coverage_iou, 0.88) << direction.transpose();
  }
}

TEST(CardPicture, MoreCardsAreNearerToTheStrands) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(400));
  double before = 0;
  for (const std::size_t count : {10u, 40u, 160u}) {
    const MadeCards cards(groom, count, 12 * count);
    double sum = 0;
    for (const Eigen::Vector3f& direction : spread_directions(6)) {
      const PictureFrame frame = frame_along(direction, ball_around(groom.points), 128);
      sum += compare_hair(draw_strands(groom, frame, kWidth, 2), draw_cards(cards.surface, frame, 2)).coverage_iou / 6;
    }
    EXPECT_GT(sum, before + 0.03) << count;
    before = sum;
  }
}

}  // namespace coif::cards::card_picture_test
