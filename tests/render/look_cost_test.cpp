// What makes a sheet of many small pictures quick, and that it shows the same.
#include "base/encodings.h"
#include "base/srgb.h"
#include "cook/texture/image.h"
#include "models/absent.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "render/egl_context.h"
#include "render/picture.h"
#include "render/picture_scene.h"

#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace coif::render::look_cost_test {

TEST(QuickPng, HoldsThePixelsAndNoAlphaWhereAllIsOpaque) {
  constexpr std::uint32_t kWidth = 37, kHeight = 300;
  std::vector<std::uint8_t> rgba(std::size_t{4} * kWidth * kHeight);
  std::uint32_t noise = 1;
  for (std::uint8_t& byte : rgba) byte = std::uint8_t((noise = noise * 1664525 + 1013904223) >> 24);
  for (const bool opaque : {false, true}) {
    for (std::size_t alpha = 3; opaque && alpha < rgba.size(); alpha += 4) rgba[alpha] = 255;
    const auto png = encode_png_quickly(rgba, kWidth, kHeight);
    ASSERT_GT(png.size(), 33u);
    EXPECT_EQ(png[25], opaque ? 2 : 6) << "the colour type";
    const auto image = cook::decode_image(std::span<const std::uint8_t>(png));
    ASSERT_TRUE(image) << image.error();
    EXPECT_EQ(image->width, kWidth);
    EXPECT_EQ(image->height, kHeight);
    EXPECT_EQ(image->texels, rgba);
  }
}

TEST(Develop, EncodesEachNumberAsTheCurveSays) {
  std::vector<float> samples;
  for (int i = 0; i <= 40'000; ++i) {
    const float light = 0.75f * float(i) / 40'000;  // Below the tone curve's shoulder.
    samples.insert(samples.end(), {light, light, light, 1});
  }
  const auto pixels = develop(samples, std::uint32_t(samples.size() / 4), 1, 1);
  for (std::size_t i = 0; i < pixels.size(); i += 4)
    ASSERT_EQ(pixels[i], std::lround(255 * encode_srgb(samples[i]))) << samples[i];
}

class LookCostTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = EglContext::create(); !context) COIF_FAIL_FOR_LACK_OF(context.error().message);
    settings_.width = settings_.height = 128;
    settings_.warm_up = false;
  }

  /// How many the current context has.
  static int count_programs() {
    int programs = 0;
    for (GLuint name = 1; name < 1000; ++name) programs += glIsProgram(name) == GL_TRUE ? 1 : 0;
    return programs;
  }

  DrawnAsset wig_{made_up_wig({.strips = 24, .texture_size = 64})};
  PictureSettings settings_;
};

TEST_F(LookCostTest, OtherSidesOfTheSameThingsNeedNoOtherProgram) {
  auto maker = PictureMaker::create(*wig_);
  ASSERT_TRUE(maker) << maker.error().message;
  const auto take_from = [&](double yaw) {
    settings_.yaw_degrees = yaw;
    const auto picture = maker->take(settings_);
    EXPECT_TRUE(picture) << picture.error().message;
  };
  take_from(0);
  const int first = count_programs();
  EXPECT_GT(first, 0);
  for (const double yaw : {90.0, 180.0, 270.0}) take_from(yaw);
  EXPECT_EQ(count_programs(), first);
  settings_.patches = true;
  take_from(0);
  settings_.patches = false;
  const int both = count_programs();
  take_from(0);
  EXPECT_EQ(count_programs(), both) << "the first stage is still there";
}

TEST_F(LookCostTest, PicturesOfManyStagesFreeTheOldest) {
  auto maker = PictureMaker::create(*wig_);
  ASSERT_TRUE(maker) << maker.error().message;
  settings_.patches = true;
  int most = 0;
  for (std::uint32_t marked = 0; marked < 12; ++marked) {
    settings_.marked_patch = marked;
    ASSERT_TRUE(maker->take(settings_));
    if (marked == 3) most = count_programs();
  }
  EXPECT_LE(count_programs(), most);
}

TEST_F(LookCostTest, APictureDoesNotShowTheOneBefore) {
  auto maker = PictureMaker::create(*wig_);
  ASSERT_TRUE(maker) << maker.error().message;
  ASSERT_TRUE(maker->take(settings_));
  PictureSettings other = settings_;
  other.yaw_degrees = 200;
  other.backdrop.opacity = 0;
  other.mannequin = false;
  const auto after = maker->take(other), alone = render_picture(*wig_, other);
  ASSERT_TRUE(after && alone);
  EXPECT_EQ(after->rgba, alone->rgba);
}

TEST_F(LookCostTest, ACoarseMannequinLooksTheSame) {
  settings_.yaw_degrees = 40;
  const auto fine = render_picture(*wig_, settings_);
  settings_.coarse_mannequin = true;
  const auto coarse = render_picture(*wig_, settings_);
  ASSERT_TRUE(fine && coarse);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < fine->rgba.size(); ++i)
    differing += std::abs(fine->rgba[i] - coarse->rgba[i]) > 8 ? 1 : 0;
  EXPECT_LT(differing, fine->rgba.size() / 200);
  EXPECT_NE(fine->rgba, coarse->rgba) << "and is another one";
}

}  // namespace coif::render::look_cost_test
