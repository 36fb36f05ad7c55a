// A head's scale: a head twice as large, seen from twice as far, looks the same.

#include "gl/gl_test.h"
#include "gl/shadow_scene.h"
#include "models/skinned_asset.h"

#include <coif/hair.h>

#include <array>
#include <cmath>
#include <vector>

namespace coif::scale_test {

/// A small scene at its own size or another: every length in it is multiplied.
class Scale : public ShadowScene {
 protected:
  void SetUp() override {
    ShadowScene::SetUp();
    if (!context_) return;
    ASSERT_EQ(model_.upload(renderer_, *wig_), Status::kOk);
    palette_ = bent_gently();
  }
  void TearDown() override {
    model_.destroy();
    ShadowScene::TearDown();
  }

  /// Every chain lifted by an angle of its own.
  [[nodiscard]] std::vector<Mat34> bent_gently() const {
    std::vector<Mat34> palette((*wig_).bones().size());
    for (std::size_t c = 0; c < (*wig_).chains().size(); ++c) {
      const ChainRecord& chain = (*wig_).chains()[c];
      const float(&root)[3] = (*wig_).bones()[chain.first_bone].joint;
      const float angle = 0.1f * float(c % 5), s = std::sin(angle), k = std::cos(angle);
      const Mat34 turn{{{k, -s, 0, root[0] - k * root[0] + s * root[1]},
                        {s, k, 0, root[1] - s * root[0] - k * root[1]},
                        {0, 0, 1, 0}}};
      for (std::uint32_t b = 0; b < chain.bone_count; ++b) palette[chain.first_bone + b] = turn;
    }
    return palette;
  }

  [[nodiscard]] HairInstance head(float scale) const {
    HairInstance head{.head = {}, .palette = palette_};
    head.head.position[0] = 0.03 * double(scale);
    head.head.position[1] = -0.02 * double(scale);
    head.head.rotation = {0, 0.6f, 0, 0.8f};
    head.head.scale = scale;
    return head;
  }

  /// Perspective, from the front and a little above.
  static DrawDesc seen_from(float scale) {
    DrawDesc desc;
    const float near = 0.2f * scale, far = 3 * scale, narrow = 3;
    const Vec3 eye{0, 0.05f * scale, 0.9f * scale};
    float(&m)[16] = desc.clip_from_world;
    m[0] = m[5] = narrow;
    m[10] = (near + far) / (near - far);
    m[11] = -1;
    m[13] = -narrow * eye.y;
    m[14] = 2 * near * far / (near - far) - m[10] * eye.z;
    m[15] = eye.z;
    desc.eye = eye;
    return desc;
  }

  std::vector<std::uint8_t> picture(float scale, const ShadowDesc* shadows, const TransparencyMode& mode = kBlendMode) {
    const HairInstance one = head(scale);
    const Light light = lamp();
    DrawDesc desc = seen_from(scale);
    desc.lights = {&light, 1};
    desc.transparency = &mode;
    HairShadow shadow;
    if (shadows != nullptr) {
      ShadowDesc scaled = *shadows;
      scaled.depth = 0.08f * scale;
      EXPECT_EQ(shadow.create(renderer_, calls_->loader(), scaled), Status::kOk);
      EXPECT_EQ(shadow.begin(light, {{0, 0, 0}, 0.4f * scale}), Status::kOk);
      const ShadowCrowd crowd{&model_, {&one, 1}, nullptr};
      EXPECT_EQ(shadow.draw({&crowd, 1}), Status::kOk);
      desc.shadow = &shadow;
    }
    bind_target();
    clear();
    EXPECT_EQ(renderer_.draw(model_, {&one, 1}, desc), Status::kOk);
    shadow.destroy();
    return read_pixels(kSize);
  }

  DrawnAsset wig_{made_up_wig({.strips = 24, .bones_per_chain = 3, .texture_size = 64})};
  HairModel model_;
  std::vector<Mat34> palette_;
};

// Powers of two change no digit of anything that is computed on the way.
TEST_F(Scale, AHeadTwiceAsLargeFromTwiceAsFarGivesTheSamePicture) {
  for (const TransparencyMode* mode : {&kBlendMode, &kHashedMode}) {
    const auto small = picture(1, nullptr, *mode);
    EXPECT_GT(count_covered(small), kSize * kSize / 20) << name_of(*mode);
    for (const float scale : {0.125f, 16.0f}) {
      EXPECT_LE(worst_difference(small, picture(scale, nullptr, *mode)), 1) << name_of(*mode) << ", scale " << scale;
    }
  }
}

TEST_F(Scale, ShadowsGrowWithTheHead) {
  const auto lit = picture(1, nullptr);
  for (const ShadowTechnique* technique : {&kPlainShadow, &kDeepOpacityShadow, &kDeepShadow}) {
    const ShadowDesc desc{.technique = technique, .size = 128};
    const auto small = picture(1, &desc), large = picture(2, &desc);
    EXPECT_GT(worst_difference(lit, small), 20) << name_of(*desc.technique) << ": no shadow, little is tested";
    EXPECT_LE(worst_difference(small, large), 1) << name_of(*desc.technique);
  }
}

TEST_F(Scale, LightOnHairDoesNotDependOnIt) {
  DrawnCard card;
  card.half_size = 0.05f;
  card.normal = {0.6f, 0, 0.8f};
  const Light light{Light::Kind::kDirectional, {0, 0, 1}, {0.8f, 0.8f, 0.8f}};
  std::array<Pixel, 2> found{};
  for (int i = 0; i < 2; ++i) {
    HeadDraw desc = at_rest();
    desc.lights = {&light, 1};
    desc.component = Component::kDiffuse;
    desc.head.scale = i == 0 ? 1.0f : 7.0f;
    bind_target();
    clear();
    draw_cards(std::array{card}, desc);
    found[std::size_t(i)] = middle_pixel();
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_GT(found[0][0], 50);
}

}  // namespace coif::scale_test
