#include "golden/golden_cases.h"
#include "models/absent.h"
#include "models/cook_fingerprint.h"
#include "render/egl_context.h"
#include "report/order/drawn_way.h"

#include <gtest/gtest.h>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <random>
#include <string>

namespace coif::golden_test {

constexpr const char* kRenew = "; where the change is meant: tests/golden/renew.sh BUILD_FOLDER, and look at them";

render::Picture read_png(const std::string& path) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &width, &height, &channels, 4);
  if (pixels == nullptr) return {};
  render::Picture picture{std::uint32_t(width), std::uint32_t(height), {pixels, pixels + 4 * width * height}, "", 0};
  stbi_image_free(pixels);
  return picture;
}

class Golden : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = render::EglContext::create(); !context) COIF_FAIL_FOR_LACK_OF(context.error().message);
    ASSERT_TRUE(sample_.asset().is_open()) << COIF_COOKED_SAMPLE " is absent: ctest cooks it, test cli.cook_sample";
  }

  static render::Picture taken(const Asset& asset, const GoldenCase& golden) {
    auto picture = render::render_picture(asset, golden.settings);
    EXPECT_TRUE(picture) << golden.name << ": " << picture.error().message;
    return picture ? std::move(*picture) : render::Picture{};
  }

  /// By what its lightness differs from the kept one's, whatever the verdict.
  static testing::AssertionResult looks_as_kept(const render::Picture& picture, const GoldenCase& golden) {
    const std::string path = std::string(COIF_GOLDEN_FOLDER "/") + golden.name + ".png";
    const render::Picture kept = read_png(path);
    if (kept.rgba.empty() || kept.rgba.size() != picture.rgba.size()) {
      return testing::AssertionFailure() << path << ": absent, or of another size" << kRenew;
    }
    const PerceptualDifference difference = perceptual_difference(kept.rgba, picture.rgba, picture.width);
    return (looks_the_same(difference) ? testing::AssertionSuccess() : testing::AssertionFailure())
           << golden.name << ": lightness differs by " << difference.mean << " on average, " << difference.largest
           << " at most" << kRenew;
  }

  static GoldenCase named(const std::string& name) {
    const auto cases = golden_cases();
    return *std::ranges::find(cases, name, &GoldenCase::name);
  }

  const GoldenAsset sample_{COIF_COOKED_SAMPLE};
};

/// Without pictures, so also where none can be drawn.
TEST(GoldenCook, ChunksAreAsTheyWere) {
  const GoldenAsset sample(COIF_COOKED_SAMPLE);
  ASSERT_TRUE(sample.asset().is_open()) << COIF_COOKED_SAMPLE " is absent: ctest cooks it, test cli.cook_sample";
  EXPECT_TRUE(is_cooked_as_before("bob", sample.asset()));
}

TEST_F(Golden, EveryPictureLooksAsItDid) {
  for (const GoldenCase& golden : golden_cases()) {
    EXPECT_TRUE(looks_as_kept(taken(sample_.asset(), golden), golden));
  }
}

TEST_F(Golden, PicturesAreTheSameBytesFromRunToRun) {
  for (const GoldenCase& golden : golden_cases()) {
    EXPECT_TRUE(taken(sample_.asset(), golden).rgba == taken(sample_.asset(), golden).rgba) << golden.name;
  }
}

TEST_F(Golden, RoundingOfAnotherDriverPasses) {
  const GoldenCase golden = named("front");
  render::Picture rounded = taken(sample_.asset(), golden);
  std::mt19937 random(1);
  for (std::uint8_t& value : rounded.rgba) value = std::uint8_t(std::clamp(int(value) + int(random() % 5) - 2, 0, 255));
  EXPECT_TRUE(looks_as_kept(rounded, golden));
}

TEST_F(Golden, WrongOrderFails) {
  AssetContents reversed = report::finest_level(sample_.asset());
  for (PatchRecord& patch : reversed.patches) patch.head_distance = 10 - patch.head_distance;
  const lab::OpenedAsset inside_out(report::in_head_order(std::move(reversed)));
  ASSERT_TRUE(inside_out.asset().is_open());
  for (const char* name : {"front", "back", "above"}) {
    EXPECT_FALSE(looks_as_kept(taken(inside_out.asset(), named(name)), named(name)));
  }
}

TEST_F(Golden, MissingPassFails) {
  for (const char* name : {"front", "back", "above", "turn"}) {
    GoldenCase golden = named(name);
    golden.settings.transparency = &kOpaqueMode;  // the first of the four passes alone
    EXPECT_FALSE(looks_as_kept(taken(sample_.asset(), golden), golden));
  }
}

TEST_F(Golden, HairThatMovedByTwoPixelsFails) {
  const GoldenCase golden = named("front");
  render::Picture moved = taken(sample_.asset(), golden);
  std::ranges::rotate(moved.rgba, moved.rgba.begin() + 8);
  EXPECT_FALSE(looks_as_kept(moved, golden));
}

}  // namespace coif::golden_test
