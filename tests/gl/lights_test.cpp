// How much of a light arrives: cones and distances, as glTF's KHR_lights_punctual has them, and sums of many.

#include "gl/gl_test.h"

#include <array>
#include <cmath>
#include <vector>

namespace coif {
namespace {

/// White, without ambient light, that faces the eye at the origin: a light in front of it shows as it arrives.
class Lights : public GlTest {
 protected:
  /// Linear, 0..1, at the picture's middle.
  double arriving(std::span<const Light> lights, const MaterialRecord& material = dark_material()) {
    AssetContents contents = card_contents(std::array{Card{}});
    contents.material = {material};
    HeadDraw desc = at_rest();
    desc.lights = lights;
    clear();
    draw(contents, desc);
    const double encoded = middle_pixel()[0] / 255.0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  }
  double arriving(const Light& light) { return arriving(std::span(&light, 1)); }

  static MaterialRecord dark_material() {
    MaterialRecord m = plain_material();
    m.ambient[0] = m.ambient[1] = m.ambient[2] = 0;
    return m;
  }

  static constexpr float kPlace = 1.0f / kSize;  ///< x and y of the middle pixel's centre, metres.

  /// A metre in front of that place, shining past it by `angle` radians.
  static Light spot(float angle, float inner, float outer) {
    Light light{Light::Kind::kSpot, {kPlace, kPlace, 1}, {0.8f, 0.8f, 0.8f}};
    light.direction = {3 * std::sin(angle), 0, -3 * std::cos(angle)};
    light.inner_cosine = std::cos(inner);
    light.outer_cosine = std::cos(outer);
    return light;
  }
};

constexpr double kStep = 0.006;  // 1/255 of sRGB where it is bright

TEST_F(Lights, OfASpotArriveWhollyInsideItsInnerCone) {
  for (const float angle : {0.0f, 0.1f, 0.25f}) EXPECT_NEAR(arriving(spot(angle, 0.35f, 0.6f)), 0.8, kStep) << angle;
}

TEST_F(Lights, OfASpotDoNotArriveOutsideItsOuterCone) {
  for (const float angle : {0.7f, 1.5f, 3.1f}) EXPECT_EQ(arriving(spot(angle, 0.35f, 0.6f)), 0) << angle;
}

TEST_F(Lights, OfASpotFallWithTheSquareOfTheCosinesWayFromEdgeToEdge) {
  const float inner = 0.2f, outer = 1.2f;
  for (const double way : {0.25, 0.5, 0.75}) {
    const double cosine = std::cos(outer) + way * (std::cos(inner) - std::cos(outer));
    EXPECT_NEAR(arriving(spot(float(std::acos(cosine)), inner, outer)), 0.8 * way * way, kStep) << way;
  }
}

TEST_F(Lights, OfASpotThatShinesAllAroundArriveAsAPointsDo) {
  Light all_around = spot(0, 0, 3.14159265f);
  all_around.inner_cosine = -0.999f;
  all_around.outer_cosine = -1;
  Light point = all_around;
  point.kind = Light::Kind::kPoint;
  EXPECT_NEAR(arriving(all_around), arriving(point), 1e-9);
  EXPECT_NEAR(arriving(point), 0.8, kStep);
}

TEST_F(Lights, OfAPointFallWithTheSquareOfTheDistance) {
  for (const float metres : {0.5f, 1.0f, 2.0f, 4.0f, 100.0f}) {
    const float color = 0.6f * metres * metres;
    EXPECT_NEAR(arriving({Light::Kind::kPoint, {kPlace, kPlace, metres}, {color, color, color}}), 0.6, kStep) << metres;
  }
  const double near = arriving({Light::Kind::kPoint, {kPlace, kPlace, 2}, {2, 2, 2}});
  const double far = arriving({Light::Kind::kPoint, {kPlace, kPlace, 4}, {2, 2, 2}});
  EXPECT_NEAR(near / far, 4, 0.15);
}

TEST_F(Lights, WithoutColorOrNoneAtAllLeaveTheAmbientAlone) {
  EXPECT_EQ(arriving(std::span<const Light>()), 0);
  EXPECT_EQ(arriving({Light::Kind::kPoint, {0, 0, 1}, {0, 0, 0}}), 0);
}

/// `count` lights at one place, each with its share of the colour.
std::vector<Light> parts_of(const Light& whole, std::uint32_t count) {
  Light part = whole;
  const float share = 1.0f / float(count);
  part.color = {whole.color.x * share, whole.color.y * share, whole.color.z * share};
  return std::vector<Light>(count, part);
}

TEST_F(Lights, AddUpWhateverTheirKindAndTheModel) {
  const Light directional{Light::Kind::kDirectional, {0.2f, 0.5f, 0.8f}, {0.7f, 0.7f, 0.7f}};
  const Light point{Light::Kind::kPoint, {0.3f, 0.2f, 0.9f}, {0.5f, 0.5f, 0.5f}};
  for (const ShadingModel model : {ShadingModel::kThesis, ShadingModel::kKajiyaKay, ShadingModel::kMarschner}) {
    MaterialRecord material = dark_material();
    material.shading = model;
    material.roughness = 0.3f;
    material.scatter = 0.5f;
    for (const Light& whole : {directional, point, spot(0.1f, 0, 0.4f)}) {
      arriving(std::span(&whole, 1), material);
      const Pixel one = middle_pixel();
      EXPECT_GT(one[0], 40);
      for (const std::uint32_t count : {2u, 5u, kMaxLights}) {
        arriving(parts_of(whole, count), material);
        EXPECT_TRUE(near(middle_pixel(), one, 1)) << count << " lights, model " << int(model);
      }
    }
  }
}

}  // namespace
}  // namespace coif
