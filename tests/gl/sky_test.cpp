// Light from a sky that is not alike everywhere, against its integral over directions.

#include "gl/gl_test.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace coif::sky_test {

using Eigen::Vector3d;

/// The harmonics' values in a direction, orthonormal over the sphere.
std::array<double, SkyLight::kHarmonics> harmonics_of(const Vector3d& d) {
  const double pi = std::numbers::pi, x = d.x(), y = d.y(), z = d.z();
  const double one = std::sqrt(3 / (4 * pi)), two = std::sqrt(15 / (4 * pi));
  return {std::sqrt(1 / (4 * pi)),
          one * y,
          one * z,
          one * x,
          two * x * y,
          two * y * z,
          std::sqrt(5 / (16 * pi)) * (3 * z * z - 1),
          two * x * z,
          two / 2 * (x * x - y * y)};
}

/// White, without lights and without light of its own.
class Sky : public GlTest {
 protected:
  /// Linear, 0..1, of hair with this normal.
  std::array<double, 3> seen(const SkyLight& sky, const Vector3d& normal, ShadingModel model) {
    DrawnCard card;
    for (std::size_t k = 0; k < 3; ++k) card.normal[k] = float(normal[Eigen::Index(k)]);
    AssetContents contents = card_contents(std::span(&card, 1));
    contents.material = {plain_material()};
    contents.material[0].shading = model;
    contents.material[0].roughness = 0.3f;
    for (float& channel : contents.material[0].ambient) channel = 0;
    HeadDraw desc = at_rest();
    desc.sky = &sky;
    clear();
    draw(contents, desc);
    std::array<double, 3> linear{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double encoded = middle_pixel()[k] / 255.0;
      linear[k] = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    }
    return linear;
  }
};

/// Brighter on one side, and coloured: each channel with harmonics of its own that keep it above 0.
SkyLight uneven_sky() {
  SkyLight sky;
  sky.harmonics[0] = {1.4f, 1.2f, 1.0f};
  sky.harmonics[1] = {0.3f, 0.2f, -0.2f};
  sky.harmonics[3] = {-0.1f, 0.25f, 0.1f};
  sky.harmonics[2] = {0.15f, -0.1f, 0.2f};
  for (std::size_t i = 4; i < SkyLight::kHarmonics; ++i) sky.harmonics[i] = {0.05f, -0.04f, 0.03f * float(i % 2)};
  return sky;
}

/// What a white matte surface sends out: the cosine-weighted mean of the sky before it, from evenly spread directions.
std::array<double, 3> matte(const SkyLight& sky, const Vector3d& normal) {
  constexpr int kDirections = 20000;
  std::array<double, 3> sum{};
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1 - (2 * i + 1.0) / kDirections, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - z * z);
    const Vector3d towards(radius * std::cos(turn), radius * std::sin(turn), z);
    const double weight = 4 * std::max(towards.dot(normal), 0.0) / kDirections;
    const auto values = harmonics_of(towards);
    for (std::size_t h = 0; h < values.size(); ++h) {
      sum[0] += weight * values[h] * double(sky.harmonics[h].x);
      sum[1] += weight * values[h] * double(sky.harmonics[h].y);
      sum[2] += weight * values[h] * double(sky.harmonics[h].z);
    }
  }
  return sum;
}

TEST_F(Sky, IsThatOfAMatteSurfaceWithTheNormal) {
  const SkyLight sky = uneven_sky();
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 12; ++i) {
    Vector3d normal(any(engine), any(engine), std::abs(any(engine)) + 0.1);
    normal.normalize();
    const auto expected = matte(sky, normal), found = seen(sky, normal, ShadingModel::kThesis);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 0.012) << normal.transpose() << ", " << k;
  }
}

TEST_F(Sky, OfOneLightnessIsAsTheMaterialsOwn) {
  SkyLight sky;
  const float grey = 0.5f * std::sqrt(4 * std::numbers::pi_v<float>);
  sky.harmonics[0] = {grey, grey, grey};
  for (const ShadingModel model : {ShadingModel::kThesis, ShadingModel::kVolume}) {
    AssetContents contents = card_contents(std::array{DrawnCard{}});
    contents.material = {plain_material()};
    contents.material[0].shading = model;
    contents.material[0].roughness = 0.3f;
    for (float& channel : contents.material[0].ambient) channel = 0.5f;
    clear();
    draw(contents, at_rest());
    const Pixel own = middle_pixel();
    (void)seen(sky, {0, 0, 1}, model);
    EXPECT_TRUE(near(middle_pixel(), own)) << int(model);
    EXPECT_GT(own[1], 150) << int(model);
  }
}

TEST_F(Sky, ThatIsNotFiniteIsRefused) {
  SkyLight sky = uneven_sky();
  sky.harmonics[7].y = std::numeric_limits<float>::quiet_NaN();
  HeadDraw desc = at_rest();
  desc.sky = &sky;
  const AssetContents contents = card_contents(std::array{DrawnCard{}});
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kBadArgument);
  sky.harmonics[7].y = 0;
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kOk);
  model.destroy();
}

}  // namespace coif::sky_test
