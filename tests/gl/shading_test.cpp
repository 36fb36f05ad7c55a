#include "gl/gl_test.h"
#include "gl/reference_shading.h"
#include "render/egl_context.h"

#include <GLES3/gl3.h>
#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace coif::shading_test {

using Eigen::Vector3d;

Vector3d to_eigen(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

struct Case {
  const char* name;
  DrawnCard card;
  std::vector<Light> lights;
};

Light directional(Vec3 towards, Vec3 color) { return {Light::Kind::kDirectional, towards, color}; }
Light point(Vec3 place, Vec3 color) { return {Light::Kind::kPoint, place, color}; }

DrawnCard large_card() {
  DrawnCard card;
  card.half_size = 0.95f;
  card.rgba = {180, 120, 70, 255};
  card.shift_mask = {150, 90};
  return card;
}

DrawnCard leaning_card() {  // as an artist's bent normals, still perpendicular to the tangent
  DrawnCard card = large_card();
  card.normal = {0.6f, 0, 0.8f};
  card.tangent = {0.48f, -0.8f, -0.36f};
  card.shift_mask = {40, 255};
  return card;
}

MaterialRecord shiny_material() {
  MaterialRecord m = plain_material();
  const float ambient[3] = {0.05f, 0.04f, 0.06f}, primary[3] = {0.8f, 0.7f, 0.9f}, secondary[3] = {0.9f, 0.5f, 0.3f};
  std::copy_n(ambient, 3, m.ambient);
  std::copy_n(primary, 3, m.primary_color);
  std::copy_n(secondary, 3, m.secondary_color);
  m.base_color[0] = 0.9f;
  m.base_color[2] = 0.7f;
  m.primary_exponent = 80;
  m.secondary_exponent = 12;
  m.primary_shift = 0.4f;
  m.secondary_shift = -0.1f;
  return m;
}

std::vector<Case> cases() {
  std::vector<Light> crowd;
  for (std::uint32_t i = 0; i < kMaxLights; ++i) {
    const float turn = 0.7f * float(i);
    crowd.push_back(i % 2 == 0 ? directional({std::cos(turn), 0.3f, std::sin(turn)}, {0.12f, 0.1f, 0.08f})
                               : point({std::cos(turn), std::sin(turn), 0.8f}, {0.1f, 0.12f, 0.2f}));
  }
  return {{"no light", large_card(), {}},
          {"from the front", large_card(), {directional({0, 0, 2}, {0.9f, 0.9f, 0.9f})}},
          {"from above", large_card(), {directional({0.2f, 1, 0.6f}, {0.7f, 0.6f, 0.5f})}},
          {"from behind", large_card(), {directional({0, 0.3f, -1}, {0.8f, 0.8f, 0.8f})}},
          {"straight against the view", large_card(), {directional({0, 0, -1}, {0.5f, 0.5f, 0.5f})}},
          {"point", large_card(), {point({0.4f, 0.5f, 0.9f}, {0.5f, 0.4f, 0.6f})}},
          {"leaning", leaning_card(), {directional({-0.3f, 0.9f, 0.5f}, {0.8f, 0.9f, 0.7f})}},
          {"leaning, point", leaning_card(), {point({-0.5f, 0.9f, 0.4f}, {0.5f, 0.5f, 0.5f})}},
          {"as many as there may be", leaning_card(), crowd}};
}

class Shading : public GlTest {
 protected:
  static Pixel expected_at(int x, int y, const Case& c, Component component = Component::kAll) {
    const auto place = [](int i) { return (i + 0.5) / (kSize / 2) - 1; };
    const double side = c.card.turned ? -1 : 1;
    const ShadedPoint seen{{place(x), place(y), c.card.center[2]},
                           side * to_eigen(c.card.normal),
                           to_eigen(c.card.tangent),
                           c.card.rgba,
                           c.card.shift_mask};
    const auto color = reference_color(seen, {0, 0, 3}, c.lights, shiny_material(), component);
    return {color[0], color[1], color[2], 255};
  }

  void draw_case(const Case& c, Component component = Component::kAll, bool framebuffer_is_srgb = false) {
    AssetContents contents = card_contents(std::span(&c.card, 1));
    contents.material = {shiny_material()};
    HeadDraw desc = at_rest();
    desc.lights = c.lights;
    desc.component = component;
    desc.framebuffer_is_srgb = framebuffer_is_srgb;
    draw(contents, desc);
  }

  static void expect_reference(const Case& c, Component component = Component::kAll) {
    for (const auto& [x, y] : {std::array{4, 4}, {16, 16}, {27, 9}, {10, 28}}) {
      EXPECT_TRUE(near(pixel(x, y), expected_at(x, y, c, component))) << c.name << " at " << x << ", " << y;
    }
  }
};

TEST_F(Shading, OpaqueTexelHasColorOfAlgorithm3) {
  for (const Case& c : cases()) {
    clear();
    draw_case(c);
    expect_reference(c);
  }
}

TEST_F(Shading, EachComponentIsItsPartOfAlgorithm3) {
  const Case c = cases()[6];
  for (const Component component : {Component::kAll, Component::kAmbient, Component::kDiffuse, Component::kSpecular,
                                    Component::kPrimary, Component::kSecondary}) {
    clear();
    draw_case(c, component);
    expect_reference(c, component);
  }
}

TEST_F(Shading, BackFaceIsLitOnTheSideThatIsSeen) {
  for (Case c : cases()) {
    c.card.turned = true;
    clear();
    draw_case(c);
    expect_reference(c);
  }
}

TEST_F(Shading, FramebufferThatEncodesGivesTheSameColors) {
  const auto target = render::OffscreenTarget::create(kSize, kSize, 0);
  ASSERT_TRUE(target) << target.error().message;
  for (const Case& c : cases()) {
    target->bind();
    clear();
    draw_case(c, Component::kAll, true);
    const auto rgba = target->read();  // rows from the top
    const std::uint8_t* found = &rgba[4 * (std::size_t{kSize - 1 - 9} * kSize + 27)];
    EXPECT_TRUE(near({found[0], found[1], found[2], found[3]}, expected_at(27, 9, c))) << c.name;
  }
}

TEST_F(Shading, FramebufferThatEncodesBlendsLinearLight) {
  const auto target = render::OffscreenTarget::create(kSize, kSize, 0);
  ASSERT_TRUE(target) << target.error().message;
  target->bind();
  clear();
  DrawnCard half = large_card();
  half.rgba = {255, 255, 255, 128};
  HeadDraw desc = at_rest();
  desc.framebuffer_is_srgb = true;
  draw_cards(std::span(&half, 1), desc);
  const auto rgba = target->read();
  EXPECT_NEAR(rgba[4 * (std::size_t{kSize / 2} * kSize + kSize / 2)], 188, 2);  // sRGB of half the light of white
}

TEST_F(Shading, MaterialOfTheCallReplacesTheAssets) {
  const DrawnCard white;
  MaterialRecord red = plain_material();
  red.base_color[1] = red.base_color[2] = 0;
  HeadDraw desc = at_rest();
  desc.material = &red;
  draw_cards(std::span(&white, 1), desc);
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
}

TEST_F(Shading, AssetWithoutTexturesIsWhiteWithNeutralShiftAndFullMask) {
  Case c = cases()[2];
  AssetContents contents = card_contents(std::span(&c.card, 1));
  contents.textures.clear();
  contents.texels.clear();
  contents.material = {shiny_material()};
  HeadDraw desc = at_rest();
  desc.lights = c.lights;
  draw(contents, desc);
  c.card.rgba = {255, 255, 255, 255};
  c.card.shift_mask = {128, 255};
  expect_reference(c);
}

}  // namespace coif::shading_test
