// What shadows bring into programs and onto the GPU, and what stays away without them.

#include "gl/shadow_scene.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace coif::shadow_programs_test {

constexpr const char* kSamplers[] = {"hair_shadow_solid",      "hair_shadow_front",  "hair_shadow_layers",
                                     "hair_shadow_far_layers", "hair_shadow_slices", "hair_shadow_middle_slices",
                                     "hair_shadow_far_slices", "hair_shadow_steps"};

class ShadowPrograms : public ShadowScene {
 protected:
  void draw_lit(const HairShadow* shadow) {
    const Light light = lamp();
    HeadDraw desc = at_rest();
    desc.lights = {&light, 1};
    desc.shadow = shadow;
    bind_target();
    calls_->forget();
    ASSERT_EQ(draw_head(renderer_, receiver_, desc), Status::kOk);
    ASSERT_FALSE(calls_->drawn_with.empty());
  }
  /// The samplers that the programs of the last draw have.
  [[nodiscard]] std::vector<std::string> samplers() const {
    std::vector<std::string> found;
    for (const char* name : kSamplers) {
      const bool used = std::ranges::any_of(calls_->drawn_with,
                                            [&](GLuint program) { return glGetUniformLocation(program, name) >= 0; });
      if (used) found.emplace_back(name);
    }
    return found;
  }
};

TEST_F(ShadowPrograms, ADrawWithoutShadowHasNoTraceOfIt) {
  HairShadow shadow;
  ASSERT_EQ(shadow.create(renderer_, calls_->loader(), {.technique = &kDeepOpacityShadow, .size = 64, .layers = 8}),
            Status::kOk);
  cast(shadow, std::array{card_above(0.5f, 0.5)});
  draw_lit(nullptr);
  const GLuint plain = calls_->drawn_with[0];
  EXPECT_TRUE(samplers().empty());
  draw_lit(&shadow);
  EXPECT_EQ(samplers().size(), 4u);
  draw_lit(nullptr);
  EXPECT_EQ(calls_->drawn_with[0], plain) << "the same program as before";
  EXPECT_TRUE(samplers().empty());
  shadow.destroy();
}

TEST_F(ShadowPrograms, EachTechniqueReadsItsOwnTexturesOnly) {
  const std::vector<ShadowDesc> descs = all_shadows();
  for (std::size_t i = 0; i < descs.size(); ++i) {
    HairShadow shadow;
    calls_->forget();
    ASSERT_EQ(shadow.create(renderer_, calls_->loader(), descs[i]), Status::kOk);
    const int textures[] = {1, 3, 4, 4, 2}, scratch[] = {0, 0, 0, 0, 9};
    EXPECT_EQ(calls_->textures, textures[i] + scratch[i]);
    cast(shadow, std::array{card_above(0.5f, 0.5)});
    draw_lit(&shadow);
    std::vector<std::string> named;
    for (std::uint32_t k = 0; k < HairShadow::kTextures; ++k) {
      EXPECT_EQ(shadow.sampler(k) != nullptr, shadow.texture(k) != 0) << k;
      if (shadow.sampler(k) != nullptr) named.emplace_back(shadow.sampler(k));
    }
    EXPECT_EQ(samplers(), named);
    EXPECT_EQ(named.size(), std::size_t(textures[i]));
    const std::uint64_t bytes[] = {4, 16, 24, 28, 6}, of_parts[] = {0, 0, 0, 0, 4 * (2 + 1) + 1};
    EXPECT_EQ(shadow.bytes(), (16 * bytes[i] + of_parts[i]) * descs[i].size * descs[i].size / 16);
    shadow.destroy();
  }
}

TEST_F(ShadowPrograms, TheFirstFrameBuildsWhatLaterOnesUse) {
  HairModel caster;
  ASSERT_EQ(caster.upload(renderer_, *DrawnAsset(card_contents(std::array{card_above(0.5f, 0.5)}))), Status::kOk);
  const HeadDraw rest = at_rest();
  const HairInstance head{rest.head, rest.palette, 0};
  const ShadowCrowd crowd{&caster, {&head, 1}, nullptr};
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    ASSERT_EQ(shadow.create(renderer_, calls_->loader(), desc), Status::kOk);
    ASSERT_EQ(shadow.prepare(caster), Status::kOk);
    calls_->forget();
    for (int frame = 0; frame < 3; ++frame) {
      ASSERT_EQ(shadow.begin(lamp(), kBall), Status::kOk);
      ASSERT_EQ(shadow.draw({&crowd, 1}), Status::kOk);
    }
    EXPECT_EQ(calls_->links, 0) << "prepared before";
    EXPECT_EQ(calls_->objects, 0);
    EXPECT_EQ(calls_->storage, 0);
    if (desc.technique == &kDeepShadow) {
      EXPECT_EQ(calls_->draws % (3 * 5), 0) << "four peels and the rest, in as many parts as have hair";
      EXPECT_LE(calls_->draws, 3 * 5 * 16);
    } else {
      EXPECT_EQ(calls_->draws, desc.technique == &kDeepOpacityShadow ? 6 : 3) << "one pass, or two; none is solid";
    }
    shadow.destroy();
  }
  caster.destroy();
}

/// A driver that draws into no half floats.
struct BytesOnly {
  static inline GLenum format = 0;
  static inline GlLoader real;

  static void tex_storage(GLenum target, GLsizei levels, GLenum internal, GLsizei width, GLsizei height) {
    format = internal;
    glTexStorage2D(target, levels, internal, width, height);
  }
  static GLenum status(GLenum target) {
    return format == GL_RGBA16F ? GLenum{GL_FRAMEBUFFER_UNSUPPORTED} : glCheckFramebufferStatus(target);
  }
  static void* find(const char* name, void*) {
    if (std::strcmp(name, "glTexStorage2D") == 0) return reinterpret_cast<void*>(tex_storage);
    if (std::strcmp(name, "glCheckFramebufferStatus") == 0) return reinterpret_cast<void*>(status);
    return real.get_proc(name, real.user);
  }
};

TEST_F(ShadowPrograms, LayersOfBytesServeWhereHalfFloatsCannotBeDrawn) {
  receiver_.destroy();
  BytesOnly::real = context_->loader();
  ASSERT_EQ(renderer_.create({BytesOnly::find, nullptr}, kSmallBlocks), Status::kOk);
  ASSERT_EQ(receiver_.upload(renderer_, *DrawnAsset(card_contents(std::array{DrawnCard{}}))), Status::kOk);
  for (const std::uint32_t layers : {4u, 8u}) {
    HairShadow shadow;
    ASSERT_EQ(shadow.create(renderer_, {BytesOnly::find, nullptr},
                            {.technique = &kDeepOpacityShadow, .size = 256, .layers = layers, .depth = 3}),
              Status::kOk);
    EXPECT_EQ(shadow.bytes(), 256u * 256u * (layers == 4 ? 12 : 16));
    for (const double alpha : {0.2, 0.5, 0.8}) {
      cast(shadow, std::array{card_above(0.5f, alpha)});
      EXPECT_NEAR(light_at_middle(shadow), 1 - alpha, 0.03) << layers << " layers";
    }
    cast(shadow, std::array{card_above(0.3f, 0.5), card_above(0.5f, 0.4), card_above(0.7f, 0.3)});
    EXPECT_NEAR(light_at_middle(shadow), 0.5 * 0.6 * 0.7, 0.03) << layers << " layers";
    shadow.destroy();
  }
}

TEST_F(ShadowPrograms, AMissingFunctionIsNamed) {
  struct Without {
    static void* find(const char* name, void* user) {
      if (std::strcmp(name, "glPolygonOffset") == 0) return nullptr;
      const auto& real = *static_cast<const GlLoader*>(user);
      return real.get_proc(name, real.user);
    }
  };
  GlLoader real = context_->loader();
  HairShadow shadow;
  EXPECT_EQ(shadow.create(renderer_, {Without::find, &real}), Status::kDriver);
  EXPECT_NE(std::string(renderer_.failure()).find("glPolygonOffset"), std::string::npos);
  EXPECT_FALSE(shadow.is_created());
}

}  // namespace coif::shadow_programs_test
