#include "cards/hair_picture.h"

#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <numeric>

namespace coif::cards::strand_picture_test {

const ShownBall kBall{Eigen::Vector3f::Zero(), 1};

double covered_area(const HairPicture& picture, const PictureFrame& frame) {
  const double pixels = std::accumulate(picture.coverage.begin(), picture.coverage.end(), 0.0);
  return pixels / double(frame.pixels_of_metre) / double(frame.pixels_of_metre);
}

/// However thin a strand is, and whatever its direction, it covers what its width and length are worth.
TEST(StrandPicture, CoversTheAreaOfStrands) {
  for (const float width : {0.1f, 0.01f, 0.002f}) {
    for (const float angle : {0.0f, 0.3f, 0.8f, 1.5f}) {
      std::vector<std::vector<Eigen::Vector3f>> strands;
      for (int i = 0; i < 9; ++i) {
        const Eigen::Vector3f along(std::cos(angle), std::sin(angle), 0), beside(-along.y(), along.x(), 0);
        const Eigen::Vector3f middle = (0.17f * float(i - 4) + 0.001f) * beside;
        strands.push_back({middle - 0.5f * along, middle + 0.5f * along});
      }
      const PictureFrame frame = frame_along({0, 0, -1}, kBall, 128);
      const double area = covered_area(draw_strands(test::groom_of(strands), frame, width, 2), frame);
      const double caps = 3.14159265 * double(width) * double(width) / 4;
      EXPECT_NEAR(area / (9 * (double(width) + caps)), 1, width > 0.05f ? 0.02 : 0.06) << width << " at " << angle;
    }
  }
}

TEST(StrandPicture, ShowsWhatIsNearest) {
  const groom::Groom groom = test::groom_of({{{-1, 0, -0.5f}, {1, 0, -0.5f}}, {{0, -1, 0.5f}, {0, 1, 0.5f}}});
  const PictureFrame frame = frame_along({0, 0, -1}, kBall, 64);  // from +Z: the upright one is in front
  const HairPicture picture = draw_strands(groom, frame, 0.2f, 2);
  const std::size_t middle = 32 * 64 + 32;
  EXPECT_EQ(picture.coverage[middle], 1);
  EXPECT_NEAR(picture.depth[middle], -0.5f, 1e-5f);
  EXPECT_NEAR(picture.shade[middle], 1, 1e-5f) << "at right angles to the line of sight";
  EXPECT_NEAR(picture.depth[32 * 64 + 10], 0.5f, 1e-5f);
  EXPECT_EQ(picture.coverage[0], 0);
}

TEST(StrandPicture, IsTheSameFromBehindAndWithAnyNumberOfThreads) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(200));
  const PictureFrame front = frame_along({0, 0, -1}, ball_around(groom.points), 96);
  const PictureFrame back = frame_along({0, 0, 1}, ball_around(groom.points), 96);
  const HairPicture one = draw_strands(groom, front, 0.002f, 1), four = draw_strands(groom, front, 0.002f, 4);
  EXPECT_EQ(one.coverage, four.coverage);
  EXPECT_EQ(one.depth, four.depth);
  const HairPicture mirrored = draw_strands(groom, back, 0.002f, 2);
  double difference = 0;
  for (std::size_t y = 0; y < 96; ++y) {
    for (std::size_t x = 0; x < 96; ++x)
      difference += std::abs(double(one.coverage[y * 96 + x]) - double(mirrored.coverage[y * 96 + 95 - x]));
  }
  EXPECT_LT(difference / (96 * 96), 1e-3);
}

TEST(PictureFrame, DirectionsAreUnitAndSpread) {
  const auto directions = spread_directions(32);
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& direction : directions) {
    EXPECT_NEAR(direction.norm(), 1, 1e-5f);
    sum += direction;
    const PictureFrame frame = frame_along(direction, kBall, 64);
    EXPECT_NEAR(frame.axes.determinant(), 1, 1e-4f);
    EXPECT_LT((frame.place(kBall.center) - Eigen::Vector3f(32, 32, 0)).norm(), 1e-4f);
  }
  EXPECT_LT(sum.norm(), 0.5f);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((directions[i] - directions[j]).norm(), 0.35f);
  }
}

}  // namespace coif::cards::strand_picture_test
