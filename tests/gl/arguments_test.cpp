#include "gl/gl_test.h"

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace coif {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A host that does not find one function.
struct PartialHost {
  GlLoader real;
  std::string missing;

  static void* find(const char* name, void* user) {
    const auto& host = *static_cast<const PartialHost*>(user);
    return name == host.missing ? nullptr : host.real.get_proc(name, host.real.user);
  }
  GlLoader loader() { return {find, this}; }
};

TEST(HairRendererWithoutContext, CreateRefusesNullLoader) {
  HairRenderer renderer;
  EXPECT_EQ(renderer.create({}), Status::kBadArgument);
  EXPECT_FALSE(renderer.is_created());
}

TEST(HairRendererWithoutContext, CreateRefusesHostWithoutFunctionsAndNamesOne) {
  HairRenderer renderer;
  EXPECT_EQ(renderer.create({[](const char*, void*) -> void* { return nullptr; }, nullptr}), Status::kDriver);
  EXPECT_NE(std::strstr(renderer.failure(), "gl"), nullptr);
  EXPECT_FALSE(renderer.is_created());
}

TEST(HairRendererWithoutContext, DrawAndUploadNeedCreate) {
  HairRenderer renderer;
  HairModel model;
  const OpenedAsset asset(card_contents(std::array{Card{}}));
  EXPECT_EQ(model.upload(renderer, *asset), Status::kNotCreated);
  EXPECT_EQ(renderer.draw(model, {}, {}), Status::kNotCreated);
  model.destroy();
  renderer.destroy();
}

class Arguments : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    ASSERT_EQ(model_.upload(renderer_, *OpenedAsset(card_contents(std::array{Card{}}))), Status::kOk);
  }
  void TearDown() override {
    model_.destroy();
    GlTest::TearDown();
  }

  HairModel model_;
};

TEST_F(Arguments, EveryMissingFunctionIsNamed) {
  for (const char* name :
       {"glActiveTexture", "glDrawElementsInstanced", "glVertexAttribIPointer", "glUniformBlockBinding"}) {
    PartialHost host{context_->loader(), name};
    HairRenderer renderer;
    EXPECT_EQ(renderer.create(host.loader()), Status::kDriver);
    EXPECT_NE(std::strstr(renderer.failure(), name), nullptr) << renderer.failure();
    EXPECT_FALSE(renderer.is_created());
  }
}

TEST_F(Arguments, DrawRefusesBadValuesAndDrawsNothing) {
  MaterialRecord bad_material = plain_material();
  bad_material.primary_exponent = 0;
  const std::array<Mat34, 2> two_bones{};
  const std::vector<Light> crowd(kMaxLights + 1, Light{Light::Kind::kDirectional, {0, 0, 1}});
  const std::array dark{Light{}};  // no direction
  const std::array lost{Light{Light::Kind::kPoint, {0, kNan, 0}}};
  struct Bad {
    const char* what;
    Status expected;
    std::function<void(HeadDraw&)> spoil;
  };
  const std::vector<Bad> all = {
      {"palette too large", Status::kSizeMismatch, [&](HeadDraw& d) { d.palette = two_bones; }},
      {"palette empty", Status::kSizeMismatch, [](HeadDraw& d) { d.palette = {}; }},
      {"too many lights", Status::kBadArgument, [&](HeadDraw& d) { d.lights = crowd; }},
      {"light without direction", Status::kBadArgument, [&](HeadDraw& d) { d.lights = dark; }},
      {"light without place", Status::kBadArgument, [&](HeadDraw& d) { d.lights = lost; }},
      {"head nowhere", Status::kBadPose, [](HeadDraw& d) { d.head.position[2] = kNan; }},
      {"rotation not unit", Status::kBadPose, [](HeadDraw& d) { d.head.rotation.w = 1.1f; }},
      {"rotation NaN", Status::kBadPose, [](HeadDraw& d) { d.head.rotation.x = kNan; }},
      {"matrix", Status::kBadArgument, [](HeadDraw& d) { d.clip_from_world[7] = INFINITY; }},
      {"eye", Status::kBadArgument, [](HeadDraw& d) { d.eye.y = kNan; }},
      {"material", Status::kBadArgument, [&](HeadDraw& d) { d.material = &bad_material; }},
      {"level of detail", Status::kBadArgument, [](HeadDraw& d) { d.lod = 1; }},
      {"component", Status::kBadArgument, [](HeadDraw& d) { d.component = static_cast<Component>(7); }},
  };
  for (const Bad& bad : all) {
    HeadDraw desc = at_rest();
    bad.spoil(desc);
    EXPECT_EQ(draw_head(renderer_, model_, desc), bad.expected) << bad.what;
    EXPECT_EQ(middle_pixel(), (Pixel{0, 0, 0, 0})) << bad.what;
  }
}

TEST_F(Arguments, DrawRefusesModelOfAnotherRenderer) {
  HairRenderer other;
  ASSERT_EQ(other.create(context_->loader()), Status::kOk);
  EXPECT_EQ(draw_head(other, model_, at_rest()), Status::kNotCreated);
  other.destroy();
}

TEST_F(Arguments, UploadRefusesAssetWithoutMeshAndKeepsTheModel) {
  AssetContents skeleton_only = card_contents({});
  skeleton_only.textures.clear();
  skeleton_only.texels.clear();
  EXPECT_EQ(model_.upload(renderer_, *OpenedAsset(skeleton_only)), Status::kAssetLacksData);
  EXPECT_EQ(model_.upload(renderer_, Asset{}), Status::kAssetLacksData);
  EXPECT_EQ(draw_head(renderer_, model_, at_rest()), Status::kOk);
  EXPECT_TRUE(near(middle_pixel(), {255, 255, 255, 255}));
}

TEST_F(Arguments, UploadReplacesTheModel) {
  Card red;
  red.rgba = {255, 0, 0, 255};
  ASSERT_EQ(model_.upload(renderer_, *OpenedAsset(card_contents(std::array{red}, 3))), Status::kOk);
  EXPECT_EQ(model_.bone_count(), 3u);
  ASSERT_EQ(draw_head(renderer_, model_, at_rest(3)), Status::kOk);
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
}

TEST_F(Arguments, DestroyTwiceIsHarmless) {
  model_.destroy();
  model_.destroy();
  EXPECT_FALSE(model_.is_uploaded());
  EXPECT_EQ(draw_head(renderer_, model_, at_rest()), Status::kNotCreated);
  renderer_.destroy();
  renderer_.destroy();
  EXPECT_FALSE(renderer_.is_created());
}

}  // namespace
}  // namespace coif
