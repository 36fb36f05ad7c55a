#include "render/picture.h"
#include "models/absent.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "render/egl_context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>

namespace coif::render::picture_test {

/// Small pictures of a wig with few strips.
class PictureTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = EglContext::create(); !context) COIF_FAIL_FOR_LACK_OF(context.error().message);
    settings_.width = 96;
    settings_.height = 72;
  }

  [[nodiscard]] Picture take(const PictureSettings& settings) const {
    auto picture = render_picture(*wig_, settings);
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? *picture : Picture{};
  }

  DrawnAsset wig_{made_up_wig({.strips = 24, .texture_size = 64})};
  PictureSettings settings_;
};

/// Share of pixels that differ by more than a fifth of full scale in some channel.
double difference(const Picture& a, const Picture& b) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = i; k < i + 3; ++k) most = std::max(most, std::abs(a.rgba[k] - b.rgba[k]));
    differing += most > 51 ? 1 : 0;
  }
  return double(differing) / double(a.rgba.size() / 4);
}

std::uint32_t big_endian(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 |
         bytes[at + 3];
}

/// Hair is warm (red above blue by far), backdrop and mannequin are not.
bool is_hair(const Picture& picture, std::size_t x, std::size_t y) {
  const std::uint8_t* p = &picture.rgba[4 * (y * picture.width + x)];
  return p[0] > p[2] + 45;
}

/// Runs of columns that hold hair.
int clumps_across(const Picture& picture) {
  int clumps = 0;
  bool inside = false;
  for (std::size_t x = 0; x < picture.width; ++x) {
    bool column = false;
    for (std::size_t y = 0; y < picture.height && !column; ++y) column = is_hair(picture, x, y);
    if (column && !inside) ++clumps;
    inside = column;
  }
  return clumps;
}

TEST_F(PictureTest, SamePictureTwice) { EXPECT_EQ(take(settings_).rgba, take(settings_).rgba); }

TEST_F(PictureTest, FramesTheHairWithABorder) {
  for (const double yaw : {0.0, 90.0, 215.0}) {
    settings_.yaw_degrees = yaw;
    const Picture picture = take(settings_);
    ASSERT_EQ(picture.rgba.size(), std::size_t{4} * picture.width * picture.height);
    std::size_t hair = 0;
    for (std::size_t y = 0; y < picture.height; ++y) {
      for (std::size_t x = 0; x < picture.width; ++x) {
        const bool border = x == 0 || y == 0 || x + 1 == picture.width || y + 1 == picture.height;
        hair += is_hair(picture, x, y) ? 1 : 0;
        EXPECT_FALSE(border && is_hair(picture, x, y)) << "hair is cut off at " << x << ", " << y;
      }
    }
    EXPECT_GT(hair, picture.rgba.size() / 4 / 20) << "yaw " << yaw;
  }
}

TEST_F(PictureTest, HeadDoesNotShowThroughTheBackOfTheHair) {
  settings_.yaw_degrees = 180;
  const Picture with_head = take(settings_);
  settings_.mannequin = false;
  EXPECT_LT(difference(with_head, take(settings_)), 0.005);
}

/// A level square below the hair.
importer::SourceModel shoulders() {
  importer::SourceModel body;
  body.meshes.emplace_back();
  body.meshes.back().positions = {
      {-0.2f, -0.08f, -0.2f}, {0.2f, -0.08f, -0.2f}, {0.2f, -0.08f, 0.2f}, {-0.2f, -0.08f, 0.2f}};
  body.meshes.back().triangles = {0, 2, 1, 0, 3, 2};
  return body;
}

TEST_F(PictureTest, CollidersHaveAColourOfTheirOwnBesideABodyToo) {
  const auto blue = [&] {
    const Picture picture = take(settings_);
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) count += picture.rgba[i + 2] > picture.rgba[i] + 60;
    return double(count) / double(picture.rgba.size() / 4);
  };
  const importer::SourceModel body = shoulders();
  settings_.yaw_degrees = 0;
  settings_.shadows = &kDeepShadow;
  for (const importer::SourceModel* const beside : {static_cast<const importer::SourceModel*>(nullptr), &body}) {
    settings_.body = beside;
    settings_.colliders = false;
    EXPECT_EQ(blue(), 0);
    settings_.colliders = true;
    EXPECT_GT(blue(), 0.01);
  }
}

TEST_F(PictureTest, ViewComponentMotionAndTransparencyChangeThePicture) {
  const Picture plain = take(settings_);
  PictureSettings other = settings_;
  other.yaw_degrees = 200;
  EXPECT_GT(difference(plain, take(other)), 0.02);
  other = settings_;
  other.component = Component::kAmbient;
  EXPECT_GT(difference(plain, take(other)), 0.1);
  other = settings_;
  other.transparency = &kOpaqueMode;
  EXPECT_GT(difference(plain, take(other)), 0.01);
  other = settings_;
  other.motion = motion::Motion::kTumble;
  other.time = 0.5;
  EXPECT_GT(difference(plain, take(other)), 0.02);
}

TEST_F(PictureTest, HeadsStandBesideEachOther) {
  settings_.mannequin = false;
  settings_.yaw_degrees = 180;
  settings_.width = 240;
  settings_.height = 64;
  for (const int heads : {1, 2, 3}) {
    settings_.heads = static_cast<std::uint32_t>(heads);
    EXPECT_EQ(clumps_across(take(settings_)), heads);
  }
}

using Mask = std::vector<bool>;  // one per pixel

Mask equal_pixels(const Picture& a, const Picture& b) {
  Mask equal(a.rgba.size() / 4);
  for (std::size_t i = 0; i < equal.size(); ++i) {
    equal[i] = std::equal(&a.rgba[4 * i], &a.rgba[4 * i] + 4, &b.rgba[4 * i]);
  }
  return equal;
}

/// Mean green of the masked pixels.
double brightness(const Picture& picture, const Mask& mask) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) sum += picture.rgba[4 * i + 1], count += 1;
  }
  return sum / count;
}

TEST_F(PictureTest, ShadowsDarkenHairAndBody) {
  const importer::SourceModel body = shoulders();
  settings_.body = &body;
  settings_.mannequin = false;
  settings_.pitch_degrees = 20;
  PictureSettings bald = settings_;  // tells which pixels are hair's, which the body's alone
  bald.material = *(*wig_).material();
  bald.material->base_color[3] = 0;
  PictureSettings empty = bald;
  empty.body = nullptr;
  const Picture lit = take(settings_), lit_body = take(bald);
  const Mask bare = equal_pixels(lit, lit_body), backdrop = equal_pixels(lit_body, take(empty));
  Mask hair(bare.size()), skin(bare.size());
  for (std::size_t i = 0; i < bare.size(); ++i) {
    hair[i] = !bare[i];
    skin[i] = bare[i] && !backdrop[i];
  }
  for (const ShadowTechnique* technique : shadow_techniques()) {
    settings_.shadows = bald.shadows = technique;
    const Picture shaded = take(settings_), shaded_body = take(bald);
    EXPECT_LT(brightness(shaded, hair), 0.95 * brightness(lit, hair)) << name_of(*technique);
    EXPECT_GT(brightness(shaded, hair), 0.4 * brightness(lit, hair)) << name_of(*technique) << ": the top stays lit";
    EXPECT_LT(brightness(shaded, skin), 0.9 * brightness(lit, skin)) << name_of(*technique);
    EXPECT_EQ(shaded_body.rgba, lit_body.rgba) << name_of(*technique) << ": a flat thing shades nothing";
    EXPECT_EQ(take(settings_).rgba, shaded.rgba);
  }
  settings_.shadows = nullptr;
  EXPECT_EQ(take(settings_).rgba, lit.rgba);
}

TEST_F(PictureTest, TheHeadsOwnShadowHasASoftEdge) {
  settings_.width = 480;
  settings_.height = 360;
  settings_.material = *(*wig_).material();
  settings_.material->base_color[3] = 0;
  for (const ShadowTechnique* technique : shadow_techniques()) {
    settings_.shadows = technique;
    const Picture picture = take(settings_);
    int steepest = 0, least = 255, most = 0;
    for (std::size_t y = 120; y < 240; ++y) {
      for (std::size_t x = 180; x < 300; ++x) {  // well within the head
        const std::uint8_t* green = &picture.rgba[4 * (y * picture.width + x) + 1];
        steepest = std::max(steepest, std::abs(green[4] - green[0]));
        least = std::min(least, int{green[0]});
        most = std::max(most, int{green[0]});
      }
    }
    EXPECT_GT(most - least, 40) << name_of(*technique) << ": from light to shadow";
    EXPECT_LT(steepest, 6) << name_of(*technique);
  }
}

TEST_F(PictureTest, BodyReplacesTheMannequin) {
  importer::SourceModel body;
  body.meshes.emplace_back();
  importer::SourceMesh& wall = body.meshes.back();  // in front of everything
  wall.positions = {{-1, -1, 0.2f}, {1, -1, 0.2f}, {0, 2, 0.2f}};
  wall.triangles = {0, 1, 2};
  settings_.body = &body;
  const Picture picture = take(settings_);
  EXPECT_EQ(clumps_across(picture), 0);
}

/// Different hues among the pixels, of 36.
std::size_t hues(const Picture& picture) {
  std::set<int> found;
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const double r = picture.rgba[i], g = picture.rgba[i + 1], b = picture.rgba[i + 2];
    const double most = std::max({r, g, b}), least = std::min({r, g, b});
    if (most - least < 60) continue;  // backdrop and mannequin are nearly grey
    found.insert(int((std::atan2(std::sqrt(3.0) * (g - b), 2 * r - g - b) + 3.15) / 6.3 * 36));
  }
  return found.size();
}

TEST_F(PictureTest, PatchesHaveColoursOfTheirOwn) {
  const std::size_t shaded = hues(take(settings_));
  settings_.patches = true;
  const Picture patches = take(settings_);
  EXPECT_GT(hues(patches), 15u) << "24 strips, about half of them seen";
  EXPECT_LT(shaded, 5u);
  settings_.motion = motion::Motion::kTumble;
  settings_.time = 0.5;
  EXPECT_GT(difference(patches, take(settings_)), 0.02) << "patches move with the hair";
}

TEST_F(PictureTest, DirectionRunsFromGreenAboveToRedBelow) {
  settings_.component = Component::kDirection;
  settings_.yaw_degrees = 180;
  settings_.mannequin = false;
  const Picture picture = take(settings_);
  double green = 0, red = 0, green_rows = 0, red_rows = 0;
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const int greener = picture.rgba[i + 1] - picture.rgba[i];
    const double row = double(i / 4 / picture.width);
    if (greener > 60) green += 1, green_rows += row;
    if (greener < -60) red += 1, red_rows += row;
  }
  ASSERT_GT(green, 50);
  ASSERT_GT(red, 50);
  EXPECT_LT(green_rows / green + 10, red_rows / red) << "the wig's strips hang from the crown";
}

TEST_F(PictureTest, PngDeclaresThePicture) {
  const Picture picture = take(settings_);
  const auto png = encode_png(picture);
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(big_endian(png, 0), 0x89504E47u);
  EXPECT_EQ(big_endian(png, 16), picture.width);
  EXPECT_EQ(big_endian(png, 20), picture.height);
  EXPECT_EQ(png[25], 6);  // RGBA
}

TEST_F(PictureTest, RefusesWhatItCannotDraw) {
  const auto kind_of = [&](auto spoil) {
    PictureSettings bad = settings_;
    spoil(bad);
    const auto picture = render_picture(*wig_, bad);
    EXPECT_FALSE(picture);
    EXPECT_FALSE(!picture && picture.error().message.empty());
    return picture ? ToolError::Kind::kInternal : picture.error().kind;
  };
  EXPECT_EQ(kind_of([](auto& s) { s.width = 15; }), ToolError::Kind::kUsage);
  EXPECT_EQ(kind_of([](auto& s) { s.height = 8193; }), ToolError::Kind::kUsage);
  EXPECT_EQ(kind_of([](auto& s) { s.heads = 0; }), ToolError::Kind::kUsage);
  EXPECT_EQ(kind_of([](auto& s) { s.time = -1; }), ToolError::Kind::kUsage);
  EXPECT_EQ(kind_of([](auto& s) { s.time = std::numeric_limits<double>::quiet_NaN(); }), ToolError::Kind::kUsage);
  EXPECT_EQ(kind_of([](auto& s) { s.pitch_degrees = INFINITY; }), ToolError::Kind::kUsage);
  EXPECT_EQ(kind_of([](auto& s) { s.lod = 1; }), ToolError::Kind::kUsage);

  const auto no_asset = render_picture(Asset{}, settings_);
  ASSERT_FALSE(no_asset);
  EXPECT_EQ(no_asset.error().kind, ToolError::Kind::kBadInput);
}

}  // namespace coif::render::picture_test
