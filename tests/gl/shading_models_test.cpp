// Every shading model against the same model on the CPU, and what a program holds of them.

#include "gl/gl_test.h"
#include "gl/reference_shading.h"

#include <coif/shading_models.h>

#include <GLES3/gl3.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace coif::shading_models_test {

using Eigen::Vector3d;

constexpr ShadingModel kModels[] = {ShadingModel::kThesis, ShadingModel::kKajiyaKay, ShadingModel::kMarschner,
                                    ShadingModel::kVolume};

/// A card, its material and its light, drawn from a seed.
struct Scene {
  DrawnCard card;
  MaterialRecord material;
  std::vector<Light> lights;
};

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  float between(float low, float high) { return low + (high - low) * float(engine_() % 65536) / 65535; }
  std::uint8_t byte(float low, float high) { return std::uint8_t(between(low, high)); }
  Vector3d direction() {
    const double z = between(-1, 1), turn = between(0, 6.2831853f), radius = std::sqrt(1 - z * z);
    return {radius * std::cos(turn), radius * std::sin(turn), z};
  }

 private:
  std::mt19937 engine_;
};

void store(const Vector3d& v, std::array<float, 3>& out) { out = {float(v.x()), float(v.y()), float(v.z())}; }

MaterialRecord random_material(Dice& dice, ShadingModel model) {
  MaterialRecord m = plain_material();
  m.shading = model;
  for (float& c : m.ambient) c = dice.between(0, 0.1f);
  for (float& c : m.base_color) c = dice.between(0.3f, 1);
  m.base_color[3] = 1;
  for (float& c : m.primary_color) c = dice.between(0, 1);
  for (float& c : m.secondary_color) c = dice.between(0, 1);
  m.primary_exponent = dice.between(5, 120);
  m.secondary_exponent = dice.between(2, 40);
  m.primary_shift = dice.between(-0.8f, 0.8f);
  m.secondary_shift = dice.between(-0.8f, 0.8f);
  m.tilt = dice.between(-0.1f, 0.1f);
  m.roughness = dice.between(0.1f, 0.5f);
  m.scatter = dice.between(0, 1);
  m.light_cut = dice.between(0, 0.5f);
  return m;
}

Scene random_scene(std::uint32_t seed, ShadingModel model) {
  Dice dice(seed);
  Scene scene;
  Vector3d normal = dice.direction();
  normal.z() = std::abs(normal.z());
  store(normal, scene.card.normal);
  store(normal.cross(dice.direction()).normalized(), scene.card.tangent);
  scene.card.half_size = 0.95f;
  scene.card.rgba = {dice.byte(20, 255), dice.byte(20, 255), dice.byte(20, 255), 255};
  scene.card.shift_mask = {dice.byte(64, 192), dice.byte(0, 255)};
  scene.material = random_material(dice, model);
  for (int i = 0; i < 3; ++i) {
    const Vector3d towards = dice.direction();
    scene.lights.push_back({Light::Kind::kDirectional,
                            {float(towards.x()), float(towards.y()), float(towards.z())},
                            {dice.between(0, 0.7f), dice.between(0, 0.7f), dice.between(0, 0.7f)}});
  }
  return scene;
}

/// As the vertex holds it: 16 bits a coordinate.
Vector3d stored(const std::array<float, 3>& v) {
  Vector3d rounded;
  for (std::size_t i = 0; i < 3; ++i) rounded[Eigen::Index(i)] = double(std::lround(v[i] * 32767)) / 32767;
  return rounded.normalized();
}

class ShadingModels : public GlTest {
 protected:
  static Pixel expected_at(int x, int y, const Scene& scene, Component component) {
    const auto place = [](int i) { return (i + 0.5) / (kSize / 2) - 1; };
    const ShadedPoint seen{{place(x), place(y), 0},
                           stored(scene.card.normal),
                           stored(scene.card.tangent),
                           scene.card.rgba,
                           scene.card.shift_mask};
    const auto color = reference_color(seen, {0, 0, 3}, scene.lights, scene.material, component);
    return {color[0], color[1], color[2], 255};
  }

  void draw_scene(const Scene& scene, Component component = Component::kAll) {
    AssetContents contents = card_contents(std::span(&scene.card, 1));
    contents.material = {scene.material};
    HeadDraw desc = at_rest();
    desc.lights = scene.lights;
    desc.component = component;
    clear();
    draw(contents, desc);
  }

  /// Largest channel that the reference has anywhere in these scenes: a model that is black would agree with anything.
  int brightest_ = 0;

  void expect_reference(const Scene& scene, Component component, std::uint32_t seed) {
    draw_scene(scene, component);
    for (const auto& [x, y] : {std::array{3, 5}, {16, 16}, {28, 11}}) {
      const Pixel expected = expected_at(x, y, scene, component);
      EXPECT_TRUE(near(pixel(x, y), expected)) << "model " << int(scene.material.shading) << ", seed " << seed
                                               << ", component " << int(component) << " at " << x << ", " << y;
      brightest_ = std::max({brightest_, expected[0], expected[1], expected[2]});
    }
  }
};

TEST_F(ShadingModels, HaveTheColorsOfTheReferenceAtRandomPoints) {
  for (const ShadingModel model : kModels) {
    brightest_ = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) expect_reference(random_scene(seed, model), Component::kAll, seed);
    EXPECT_GT(brightest_, 100) << int(model);
  }
}

TEST_F(ShadingModels, SplitIntoTheComponentsOfTheReference) {
  for (const ShadingModel model : kModels) {
    for (const Component component :
         {Component::kAmbient, Component::kDiffuse, Component::kSpecular, Component::kPrimary, Component::kSecondary}) {
      brightest_ = 0;
      for (std::uint32_t seed = 100; seed < 112; ++seed) expect_reference(random_scene(seed, model), component, seed);
      const bool has_it = model != ShadingModel::kKajiyaKay || component != Component::kSecondary;
      EXPECT_EQ(brightest_ > 10, has_it) << int(model) << ", component " << int(component);
    }
  }
}

TEST_F(ShadingModels, StayFiniteWhereAnglesHaveNoMeaning) {
  for (const ShadingModel model : kModels) {
    Scene scene = random_scene(1, model);
    scene.material.roughness = kLeastRoughness;
    scene.card.normal = {1, 0, 0};
    scene.card.tangent = {0, 0, 1};  // towards the eye
    for (const Vec3 towards : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}}) {
      for (Light& light : scene.lights) light = {Light::Kind::kDirectional, towards, {0, 0, 0}};
      draw_scene(scene);
      const Pixel unlit = middle_pixel();
      for (Light& light : scene.lights) light.color = {0.3f, 0.3f, 0.3f};
      draw_scene(scene);
      // A NaN would be black or leave the clear colour.
      for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(middle_pixel()[i], unlit[i]) << int(model);
      EXPECT_EQ(middle_pixel()[3], 255);
    }
  }
}

TEST_F(ShadingModels, BlackHairOfFibersStillShines) {
  Scene scene = random_scene(3, ShadingModel::kMarschner);
  std::fill_n(scene.material.base_color, 3, 0.0f);
  std::fill_n(scene.material.ambient, 3, 0.0f);
  scene.card.normal = {0, 0, 1};
  scene.card.tangent = {0, -1, 0};
  scene.card.shift_mask = {128, 255};
  scene.lights = {{Light::Kind::kDirectional, {0, 0, 1}, {4, 4, 4}}};
  draw_scene(scene, Component::kPrimary);
  EXPECT_GT(middle_pixel()[0], 60);
  for (const Component component : {Component::kDiffuse, Component::kSecondary}) {
    draw_scene(scene, component);
    EXPECT_TRUE(near(middle_pixel(), {0, 0, 0, 255}, 0));
  }
}

/// What the fragment shaders of all programs of this context say.
std::string all_shader_text() {
  std::string text;
  for (GLuint name = 1; name < 64; ++name) {
    if (glIsShader(name) != GL_TRUE) continue;
    std::vector<char> source(65536);
    GLsizei length = 0;
    glGetShaderSource(name, GLsizei(source.size()), &length, source.data());
    text.append(source.data(), std::size_t(length));
  }
  return text;
}

TEST_F(ShadingModels, AProgramHoldsTheOneItDrawsWith) {
  constexpr const char* kSigns[] = {"strand_specular", "to_cone", "transmitted", "volume_color"};
  for (std::size_t model = 0; model < std::size(kModels); ++model) {
    renderer_.destroy();
    ASSERT_EQ(renderer_.create(context_->loader(), kSmallBlocks), Status::kOk);
    HairModel uploaded;
    AssetContents contents = card_contents(std::array{DrawnCard{}});
    contents.material = {random_scene(5, kModels[model]).material};
    ASSERT_EQ(uploaded.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
    const std::string text = all_shader_text();
    ASSERT_FALSE(text.empty());
    for (std::size_t other = 0; other < std::size(kModels); ++other) {
      EXPECT_EQ(text.find(kSigns[other]) != std::string::npos, other == model) << model << ", " << other;
    }
    uploaded.destroy();
  }
}

TEST_F(ShadingModels, AMaterialOfTheCallMayHaveAnotherModel) {
  Scene scene = random_scene(8, ShadingModel::kThesis);
  AssetContents contents = card_contents(std::span(&scene.card, 1));
  contents.material = {scene.material};
  scene.material.shading = ShadingModel::kMarschner;
  HeadDraw desc = at_rest();
  desc.lights = scene.lights;
  desc.material = &scene.material;
  draw(contents, desc);
  EXPECT_TRUE(near(middle_pixel(), expected_at(kSize / 2, kSize / 2, scene, Component::kAll)));
}

TEST_F(ShadingModels, NumbersOutOfRangeAreRefused) {
  const auto drawn_with = [&](auto change) {
    MaterialRecord material = random_scene(9, ShadingModel::kMarschner).material;
    change(material);
    const AssetContents contents = card_contents(std::array{DrawnCard{}});
    HairModel model;
    EXPECT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
    HeadDraw desc = at_rest();
    desc.material = &material;
    const Status status = draw_head(renderer_, model, desc);
    model.destroy();
    return status;
  };
  EXPECT_EQ(drawn_with([](MaterialRecord&) {}), Status::kOk);
  EXPECT_EQ(drawn_with([](MaterialRecord& m) { m.shading = ShadingModel(kShadingModelCount); }), Status::kBadArgument);
  EXPECT_EQ(drawn_with([](MaterialRecord& m) { m.roughness = 0; }), Status::kBadArgument);
  EXPECT_EQ(drawn_with([](MaterialRecord& m) { m.tilt = 1; }), Status::kBadArgument);
  EXPECT_EQ(drawn_with([](MaterialRecord& m) { m.scatter = 1.5f; }), Status::kBadArgument);
  EXPECT_EQ(drawn_with([](MaterialRecord& m) { m.light_cut = std::numeric_limits<float>::quiet_NaN(); }),
            Status::kBadArgument);
}

}  // namespace coif::shading_models_test
