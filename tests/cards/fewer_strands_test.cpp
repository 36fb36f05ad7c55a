#include "cards/fewer_strands.h"

#include "cards/made_up_groom.h"
#include "cards/strand_picture.h"

#include <gtest/gtest.h>

#include <numeric>

namespace coif::fewer_strands_test {

TEST(FewerStrands, CoverAsMuchOfAPictureAsAll) {
  const Groom all = test::groom_of(test::strands_of_a_head(6000));
  const Groom fewer = fewer_strands(all, 0.0002f, all.points.size() / 6);
  EXPECT_EQ(find_groom_fault(fewer), "");
  EXPECT_EQ(fewer.strand_count(), 1000u);
  EXPECT_EQ(fewer.widths, std::vector<float>(fewer.points.size(), 6 * 0.0002f));
  const PictureFrame frame = frame_along(Eigen::Vector3f(0.3f, 0.2f, 1).normalized(), ball_around(all.points), 64);
  const auto covered = [&](const Groom& groom) {
    const HairPicture picture = draw_strands(groom, frame, 0.0002f, 1);
    return std::accumulate(picture.coverage.begin(), picture.coverage.end(), 0.0);
  };
  EXPECT_NEAR(covered(fewer), covered(all), 0.1 * covered(all));
}

TEST(FewerStrands, AreAllWhereThoseAreFew) {
  const Groom all = test::hanging_wisps(3, 5);
  const Groom same = fewer_strands(all, 0.001f, 1u << 20);
  EXPECT_EQ(same.points, all.points);
  EXPECT_EQ(same.widths, std::vector<float>(all.points.size(), 0.001f));
}

}  // namespace coif::fewer_strands_test
