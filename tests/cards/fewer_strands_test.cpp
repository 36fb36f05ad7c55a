#include "cards/fit_opacity.h"

#include "cards/hair_picture.h"
#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace coif::cards::fewer_strands_test {

TEST(FewerStrands, CoverAsMuchOfAPictureAsAll) {
  const groom::Groom all = test::groom_of(test::strands_of_a_head(6000));
  const groom::Groom fewer = fewer_strands(all, 0.0002f, all.points.size() / 6);
  EXPECT_EQ(groom::find_groom_fault(fewer), "");
  EXPECT_EQ(fewer.strand_count(), 1000u);
  EXPECT_EQ(fewer.widths, std::vector<float>(fewer.points.size(), 6 * 0.0002f));
  const PictureFrame frame = frame_along(Eigen::Vector3f(0.3f, 0.2f, 1).normalized(), ball_around(all.points), 64);
  const auto covered = [&](const groom::Groom& groom) {
    const HairPicture picture = draw_strands(groom, frame, 0.0002f, 1);
    return std::accumulate(picture.coverage.begin(), picture.coverage.end(), 0.0);
  };
  EXPECT_NEAR(covered(fewer), covered(all), 0.1 * covered(all));
}

TEST(FewerStrands, AreAllWhereThoseAreFew) {
  const groom::Groom all = test::hanging_wisps(3, 5);
  const groom::Groom same = fewer_strands(all, 0.001f, 1u << 20);
  EXPECT_EQ(same.points, all.points);
  EXPECT_EQ(same.widths, std::vector<float>(all.points.size(), 0.001f));
}

TEST(StraighterStrands, LieWhereTheyLayWithFewerPoints) {
  const groom::Groom all = test::groom_of(test::strands_of_a_head(100));
  constexpr float kTolerance = 0.002f;
  const groom::Groom straighter = straighter_strands(all, kTolerance);
  EXPECT_EQ(groom::find_groom_fault(straighter), "");
  ASSERT_EQ(straighter.strand_count(), all.strand_count());
  EXPECT_LT(straighter.points.size(), 2 * all.points.size() / 3);
  for (std::size_t i = 0; i < all.strand_count(); ++i) {
    const auto kept = straighter.strand(i);
    EXPECT_EQ(kept.front(), all.strand(i).front());
    EXPECT_EQ(kept.back(), all.strand(i).back());
    for (const Eigen::Vector3f& point : all.strand(i)) {
      float nearest = 1;
      for (std::size_t p = 1; p < kept.size(); ++p) {
        const Eigen::Vector3f way = kept[p] - kept[p - 1];
        const float share = std::clamp((point - kept[p - 1]).dot(way) / way.squaredNorm(), 0.0f, 1.0f);
        nearest = std::min(nearest, (kept[p - 1] + share * way - point).norm());
      }
      EXPECT_LE(nearest, 1.001f * kTolerance);
    }
  }
  EXPECT_EQ(straighter_strands(test::hanging_wisps(2, 3), 1e-6f).points.size(), 2u * 3 * 2)
      << "straight ones keep their ends";
}

}  // namespace coif::cards::fewer_strands_test
