#include "report/order/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coif {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Pixels of one grey and one alpha.
Bytes grey(std::uint8_t value, std::size_t pixels, std::uint8_t alpha = 255) {
  Bytes bytes;
  for (std::size_t i = 0; i < pixels; ++i) bytes.insert(bytes.end(), {value, value, value, alpha});
  return bytes;
}

Bytes joined(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(PictureError, EqualPicturesHaveTheMostThatIsSaid) {
  const PictureError error = picture_error(grey(100, 4), grey(100, 4));
  EXPECT_EQ(error.psnr_db(), kEqualDb);
  EXPECT_EQ(error.rmse(), 0);
  EXPECT_EQ(error.pixels, 4u);
}

TEST(PictureError, IsTheDecibelsOfTheRootMeanSquare) {
  const PictureError error = picture_error(grey(100, 8), grey(151, 8));
  EXPECT_NEAR(error.rmse(), 0.2, 1e-12);
  EXPECT_NEAR(error.psnr_db(), -20 * std::log10(0.2), 1e-9);
}

TEST(PictureError, LooksOnlyWhereHairIsInTheExactPicture) {
  const Bytes exact = joined(grey(100, 3, 255), grey(100, 5, 0));
  const Bytes other = joined(grey(100, 3, 0), grey(0, 5, 255));
  const PictureError error = picture_error(exact, other);
  EXPECT_EQ(error.pixels, 3u);
  EXPECT_EQ(error.psnr_db(), kEqualDb);
}

TEST(PictureError, FaintHairCountsAsWell) { EXPECT_EQ(picture_error(grey(0, 2, 1), grey(9, 2)).pixels, 2u); }

TEST(PictureError, BadPixelsAreThoseOffByMoreThanATenth) {
  EXPECT_EQ(picture_error(grey(100, 1), grey(125, 1)).bad, 0u);
  EXPECT_EQ(picture_error(grey(100, 1), grey(126, 1)).bad, 1u);
  Bytes one_channel = grey(100, 1);
  one_channel[1] = 140;
  EXPECT_EQ(picture_error(grey(100, 1), one_channel).bad, 1u);
}

TEST(PictureError, SumsWeighPixelsAlike) {
  const std::vector<PictureError> views = {picture_error(grey(0, 30), grey(0, 30)),
                                           picture_error(grey(0, 10), grey(51, 10)),
                                           picture_error(grey(0, 10), grey(51, 10))};
  const OrderError sum = sum_up(views);
  EXPECT_NEAR(sum.rmse, std::sqrt(0.2 * 0.2 * 20 / 50), 1e-12);
  EXPECT_NEAR(sum.bad_pixels_pct, 40, 1e-9);
  EXPECT_NEAR(sum.worst_psnr_db, -20 * std::log10(0.2), 1e-9);
  EXPECT_EQ(sum.median_psnr_db, sum.worst_psnr_db);
  ASSERT_EQ(sum.view_psnr_db.size(), 3u);
  EXPECT_EQ(sum.view_psnr_db[0], kEqualDb);
}

TEST(PictureError, ViewsWithoutHairHaveNoError) {
  const std::vector<PictureError> views = {picture_error(grey(0, 4, 0), grey(200, 4, 0))};
  EXPECT_EQ(sum_up(views).psnr_db, kEqualDb);
  EXPECT_EQ(sum_up(views).bad_pixels_pct, 0);
}

TEST(ExcessChange, IsNoneWhereTheExactPictureChangesAsMuch) {
  EXPECT_EQ(excess_change(grey(50, 4), grey(90, 4), grey(60, 4), grey(100, 4)).rmse(), 0);
  EXPECT_EQ(excess_change(grey(50, 4), grey(90, 4), grey(60, 4), grey(60, 4)).rmse(), 0) << "less change is no popping";
}

TEST(ExcessChange, IsWhatJumpsWhileTheExactPictureStays) {
  const PictureError change = excess_change(grey(50, 4), grey(50, 4), grey(50, 4), grey(101, 4));
  EXPECT_NEAR(change.rmse(), 0.2, 1e-12);
  EXPECT_EQ(change.pixels, 4u);
}

TEST(SideBySide, HasTheThreePicturesInEveryRow) {
  const Bytes exact = joined(grey(10, 2), grey(20, 2)), other = joined(grey(10, 2), grey(23, 2));
  const Bytes row = side_by_side(exact, other, 2);
  ASSERT_EQ(row.size(), 3 * exact.size());
  EXPECT_EQ(row[0], 10);
  EXPECT_EQ(row[2 * 4], 10);
  EXPECT_EQ(row[4 * 4], 0);
  EXPECT_EQ(row[6 * 4], 20);
  EXPECT_EQ(row[8 * 4], 23);
  EXPECT_EQ(row[10 * 4], 12) << "four times the difference";
  for (std::size_t alpha = 3; alpha < row.size(); alpha += 4) EXPECT_EQ(row[alpha], 255);
}

TEST(MeanCoverage, IsTheSumOfAlphaOverTheArea) {
  EXPECT_NEAR(mean_coverage(joined(grey(0, 1, 255), grey(0, 3, 51))), (1 + 3 * 0.2) / 4, 1e-12);
}

}  // namespace
}  // namespace coif
