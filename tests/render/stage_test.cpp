// What surrounds the hair in a picture: lights, backdrop, bodies with textures, a head where there is none.

#include "models/absent.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "render/egl_context.h"
#include "render/picture.h"
#include "render/presentation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

namespace coif::render::stage_test {

TEST(Backdrop, HasNamesAndColours) {
  EXPECT_EQ(find_backdrop("clear")->opacity, 0);
  EXPECT_GT(find_backdrop("dark")->vignette, 0);
  EXPECT_LT(find_backdrop("dark")->top[0], find_backdrop("light")->top[0]);
  const auto white = find_backdrop("#ff8000");
  ASSERT_TRUE(white);
  EXPECT_NEAR(white->top[0], 1, 1e-6f);
  EXPECT_NEAR(white->top[1], 0.2159f, 1e-3f) << "sRGB to linear";
  EXPECT_EQ(white->bottom, white->top);
  for (const char* const bad : {"", "grey", "#12345", "#1234567", "#12345g", "ff8000"})
    EXPECT_FALSE(find_backdrop(bad)) << bad;
}

TEST(Lights, ComeFromWhereTheyAreCalledAfter) {
  Camera camera;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.back = {0, 0, 1};
  EXPECT_GT(rig_lights(LightRig::kStudio, camera)[0].from.z, 0) << "the key is in front";
  EXPECT_LT(rig_lights(LightRig::kRim, camera)[0].from.z, 0) << "and here behind";
  const auto measured = rig_lights(LightRig::kMeasured, camera);
  const auto studio = studio_lights(camera);
  for (std::size_t i = 0; i < studio.size(); ++i) EXPECT_EQ(measured[i].from.y, studio[i].from.y);
}

class StageTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = EglContext::create(); !context) COIF_FAIL_FOR_LACK_OF(context.error().message);
    settings_.width = 96;
    settings_.height = 72;
    settings_.yaw_degrees = 0;
  }

  [[nodiscard]] Picture take() const {
    auto picture = render_picture(*wig_, settings_);
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? *picture : Picture{96, 72, std::vector<std::uint8_t>(4 * 96 * 72), {}};
  }

  static std::array<int, 4> pixel(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* p = &picture.rgba[std::size_t(4) * (y * picture.width + x)];
    return {p[0], p[1], p[2], p[3]};
  }

  DrawnAsset wig_{made_up_wig({.strips = 12, .texture_size = 32})};
  PictureSettings settings_;
};

TEST_F(StageTest, AClearBackdropLeavesThePictureTransparent) {
  const Picture opaque = take();
  settings_.backdrop = *find_backdrop("clear");
  const Picture clear = take();
  EXPECT_EQ(pixel(opaque, 1, 1)[3], 255);
  EXPECT_EQ(pixel(clear, 1, 1), (std::array{0, 0, 0, 0}));
  int covered = 0, equal = 0;
  for (std::uint32_t y = 0; y < clear.height; ++y) {
    for (std::uint32_t x = 0; x < clear.width; ++x) {
      if (pixel(clear, x, y)[3] != 255) continue;
      ++covered;
      const auto a = pixel(clear, x, y), b = pixel(opaque, x, y);
      equal += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) <= 3 ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 500);
  EXPECT_EQ(equal, covered) << "what is there looks as before another backdrop";
}

TEST_F(StageTest, AColouredBackdropIsThatColour) {
  settings_.backdrop = *find_backdrop("#306090");
  const auto corner = pixel(take(), 1, 1);
  EXPECT_NEAR(corner[0], 0x30, 1);
  EXPECT_NEAR(corner[1], 0x60, 1);
  EXPECT_NEAR(corner[2], 0x90, 1);
}

/// Left half red, right half blue with alpha 0.
std::shared_ptr<const SolidTexture> two_halves() {
  SolidTexture texture{64, 1, {}};
  for (std::uint32_t x = 0; x < texture.width; ++x) {
    const bool is_left = x < texture.width / 2;
    for (const int channel : {is_left ? 255 : 0, 0, is_left ? 0 : 255, is_left ? 255 : 0}) {
      texture.rgba.push_back(std::uint8_t(channel));
    }
  }
  return std::make_shared<SolidTexture>(std::move(texture));
}

/// A wall before everything.
importer::SourceModel wall(importer::AlphaUse use) {
  importer::SourceModel body;
  importer::SourceMesh& mesh = body.meshes.emplace_back();
  mesh.positions = {{-1, -1, 0.3f}, {1, -1, 0.3f}, {1, 1, 0.3f}, {-1, 1, 0.3f}};
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.triangles = {0, 1, 2, 0, 2, 3};
  mesh.material = 0;
  body.materials.emplace_back().base_texture.path = "wall.png";
  body.materials.back().alpha_use = use;
  return body;
}

TEST_F(StageTest, BodiesShowTheirTexturesAndTheHolesInThem) {
  importer::SourceModel body = wall(importer::AlphaUse::kOpaque);
  settings_.body = &body;
  const auto clay = pixel(take(), 10, 36);
  EXPECT_LT(std::abs(clay[0] - clay[2]), 60) << "nobody has the texture: clay";
  settings_.body_textures = {two_halves()};
  const Picture painted = take();
  EXPECT_GT(pixel(painted, 10, 36)[0], 2 * pixel(painted, 10, 36)[2] + 40);
  EXPECT_GT(pixel(painted, 85, 36)[2], 2 * pixel(painted, 85, 36)[0] + 40) << "opaque: alpha does not matter";
  body.materials[0].alpha_use = importer::AlphaUse::kMask;
  settings_.backdrop = *find_backdrop("clear");
  const Picture masked = take();
  EXPECT_EQ(pixel(masked, 1, 1)[3], 255);
  EXPECT_EQ(pixel(masked, 94, 1)[3], 0) << "a hole";
}

TEST_F(StageTest, LightsChangeWhatIsSeen) {
  const Picture plain = take();
  for (const LightRig rig : {LightRig::kStudio, LightRig::kSun, LightRig::kRim}) {
    settings_.lights = rig;
    EXPECT_NE(take().rgba, plain.rgba);
  }
}

TEST_F(StageTest, EdgesGetAsManySamplesAsTheDeviceHas) {
  settings_.edge_samples = 2;
  const std::uint32_t two = take().edge_samples;
  settings_.edge_samples = 64;
  EXPECT_GE(take().edge_samples, two);
  EXPECT_LE(take().edge_samples, 64u);
  settings_.edge_samples = 1;
  EXPECT_EQ(take().edge_samples, 1u);
}

ColliderRecord head_ball(float x, float y, float z) {
  ColliderRecord ball{};
  ball.shape = ColliderShape::kEllipsoid;
  ball.radii[0] = x;
  ball.radii[1] = y;
  ball.radii[2] = z;
  ball.rotation[3] = 1;
  return ball;
}

TEST(MannequinBust, IsAsLargeAsTheColliderAndKeepsItsSkullInside) {
  for (const float size : {1.0f, 3.0f}) {
    const ColliderRecord ball = head_ball(0.074f * size, 0.090f * size, 0.096f * size);
    const auto meshes = bust_meshes({&ball, 1}, false);
    ASSERT_EQ(meshes.size(), 3u) << "skin, eyes, lashes";
    float top = -1, front = -1, outside = 0;
    for (const SolidVertex& v : meshes[0].vertices) {
      top = std::max(top, v.position.y());
      front = std::max(front, v.position.z());
      const Eigen::Map<const Eigen::Vector3f> radii(ball.radii);
      if (v.position.y() > 0.4f * radii.y()) outside = std::max(outside, v.position.cwiseQuotient(radii).norm());
    }
    EXPECT_NEAR(top, 0.087f * size, 0.004f * size);
    EXPECT_GT(front, 0.100f * size) << "the nose is before it";
    EXPECT_LT(outside, 1);
    float behind = 1;
    const auto turned = bust_meshes({&ball, 1}, true);
    for (const SolidVertex& v : turned[0].vertices) behind = std::min(behind, v.position.z());
    EXPECT_NEAR(behind, -front, 0.002f * size);
  }
}

TEST(MannequinBust, NeedsAHead) {
  EXPECT_TRUE(bust_meshes({}, false).empty());
  const ColliderRecord floor = head_ball(20, 20, 20);
  EXPECT_TRUE(bust_meshes({&floor, 1}, false).empty());
  EXPECT_TRUE(bust_outline({&floor, 1}, false).empty());
}

}  // namespace coif::render::stage_test
