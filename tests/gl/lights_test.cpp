// How much of a light arrives: cones and distances, as glTF's KHR_lights_punctual has them, and sums of many.

#include "gl/gl_test.h"
#include "render/egl_context.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace coif::lights_test {

/// White, without ambient light, that faces the eye at the origin: a light in front of it shows as it arrives.
class Lights : public GlTest {
 protected:
  /// Linear, 0..1, at the picture's middle.
  double arriving(std::span<const Light> lights, const MaterialRecord& material = dark_material()) {
    AssetContents contents = card_contents(std::array{DrawnCard{}});
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
    light.spot_axis = {3 * std::sin(angle), 0, -3 * std::cos(angle)};
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
  for (const ShadingModel model :
       {ShadingModel::kThesis, ShadingModel::kKajiyaKay, ShadingModel::kMarschner, ShadingModel::kVolume}) {
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

// Shading is linear; sRGB is encoded once, by the framebuffer or by the shader. What differs between the two is what
// blending mixes.

using Bytes = std::vector<std::uint8_t>;

double decode(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// Draws into two targets that differ in who encodes.
class LinearLight : public GlTest {
 protected:
  Bytes drawn(const AssetContents& contents, std::span<const Light> lights, double wall, bool framebuffer_encodes) {
    std::optional<render::OffscreenTarget> target;
    if (framebuffer_encodes) {
      auto made = render::OffscreenTarget::create(kSize, kSize, 0);
      EXPECT_TRUE(made) << made.error().message;
      if (!made) return {};
      target.emplace(std::move(*made));
      target->bind();
    } else {
      bind_own_target();
    }
    const auto clear_to = float(framebuffer_encodes ? decode(wall) : wall);
    glClearColor(clear_to, clear_to, clear_to, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    HeadDraw desc = at_rest();
    desc.lights = lights;
    desc.framebuffer_is_srgb = framebuffer_encodes;
    draw(contents, desc);
    if (target) return target->read();
    Bytes rgba(4 * kSize * kSize);
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
  }

  const std::array<Light, 2> lights_{Light{Light::Kind::kDirectional, {0.3f, 0.8f, 0.5f}, {0.7f, 0.7f, 0.7f}},
                                     Light{Light::Kind::kPoint, {-0.6f, 0.2f, 1.0f}, {0.4f, 0.4f, 0.5f}}};

 private:
  void SetUp() override {
    GlTest::SetUp();
    GLint bound = 0;
    if (!IsSkipped()) glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    own_target_ = GLuint(bound);
  }
  void bind_own_target() const {
    glBindFramebuffer(GL_FRAMEBUFFER, own_target_);
    glViewport(0, 0, kSize, kSize);
  }
  GLuint own_target_ = 0;
};

AssetContents shaded_card(ShadingModel model, std::array<std::uint8_t, 4> rgba) {
  DrawnCard card;
  card.half_size = 2;  // the same everywhere but for light and view
  card.rgba = rgba;
  AssetContents contents = card_contents(std::array{card});
  MaterialRecord& m = contents.material[0];
  m.shading = model;
  m.roughness = 0.2f;
  m.scatter = 0.5f;
  m.primary_exponent = m.secondary_exponent = 20;
  std::fill_n(m.ambient, 3, 0.05f);
  std::fill_n(m.primary_color, 3, 0.4f);
  std::fill_n(m.secondary_color, 3, 0.3f);
  return contents;
}

TEST_F(LinearLight, OpaqueColorsAreTheSameWhoeverEncodes) {
  for (const ShadingModel model :
       {ShadingModel::kThesis, ShadingModel::kKajiyaKay, ShadingModel::kMarschner, ShadingModel::kVolume}) {
    for (const int level : {8, 60, 140, 250}) {
      const AssetContents card =
          shaded_card(model, {std::uint8_t(level), std::uint8_t(level / 2), std::uint8_t(level / 3), 255});
      const Bytes by_framebuffer = drawn(card, lights_, 0, true), by_shader = drawn(card, lights_, 0, false);
      ASSERT_EQ(by_framebuffer.size(), by_shader.size());
      int brightest = 0;
      for (int y = 0; y < kSize; ++y) {
        for (int i = 0; i < 4 * kSize; ++i) {
          const int found = by_framebuffer[std::size_t(4 * kSize * (kSize - 1 - y) + i)];  // rows from the top
          const int expected = by_shader[std::size_t(4 * kSize * y + i)];
          ASSERT_NEAR(found, expected, 1) << "model " << int(model) << ", level " << level << ", row " << y;
          if (i % 4 != 3) brightest = std::max(brightest, expected);
        }
      }
      EXPECT_GT(brightest, level / 2) << "something is lit";
    }
  }
}

/// A card of one grey, with alpha from 0 at the left to 1 at the right.
AssetContents soft_card(std::uint8_t grey) {
  AssetContents contents = shaded_card(ShadingModel::kThesis, {grey, grey, grey, 255});
  contents.material[0] = plain_material();
  contents.material[0].opaque_threshold = 1;
  contents.material[0].discard_threshold = 0;
  for (VertexRecord& v : contents.vertices) v.uv[0] = 0.5f + 0.5f * v.position[0];  // 0..1 over what is seen
  constexpr std::uint32_t kTexels = 64;
  contents.textures.resize(1);
  TextureRecord& texture = contents.textures[0];
  texture.width = kTexels;
  texture.bytes = 4 * kTexels;
  contents.texels.clear();
  for (std::uint32_t i = 0; i < kTexels; ++i) {
    for (const std::uint32_t value :
         {std::uint32_t{grey}, std::uint32_t{grey}, std::uint32_t{grey}, i * 255 / (kTexels - 1)}) {
      contents.texels.push_back(std::byte(value));
    }
  }
  return contents;
}

/// Decibels of blended encoded values against blended light, peak 255.
double blending_psnr(const Bytes& encoded, const Bytes& linear) {
  double square = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < encoded.size(); i += 4, ++count) square += std::pow(double(encoded[i]) - linear[i], 2);
  return 10 * std::log10(255.0 * 255.0 * double(count) / square);
}

// The figures that coif/renderer.h states at DrawDesc::framebuffer_is_srgb.
TEST_F(LinearLight, BlendingEncodedValuesCostsWhatTheHeaderSays) {
  struct Edge {
    const char* name;
    std::uint8_t hair;
    double wall;
    double decibels;
  };
  for (const Edge& edge : {Edge{"dark hair, light wall", 40, 0.8, 20.5},
                           {"brown hair, grey wall", 80, 0.5, 41.8},
                           {"light hair, dark wall", 200, 0.1, 19.0},
                           {"hair over hair", 80, 60 / 255.0, 49.0}}) {
    const AssetContents card = soft_card(edge.hair);
    const Bytes linear = drawn(card, {}, edge.wall, true), encoded = drawn(card, {}, edge.wall, false);
    const double found = blending_psnr(encoded, linear);
    std::printf("%-24s %.1f dB\n", edge.name, found);
    // Where it costs a level or two of 255, how a driver rounds these counts.
    EXPECT_NEAR(found, edge.decibels, edge.decibels > 30 ? 4 : 0.5) << edge.name;
  }
}

}  // namespace coif::lights_test
