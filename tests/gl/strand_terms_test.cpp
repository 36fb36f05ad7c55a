// What every shading model may have besides: glow, dark roots, strands of different lightness.

#include "gl/gl_test.h"

#include <GLES3/gl3.h>

#include <string>
#include <vector>

namespace coif::strand_terms_test {

constexpr ShadingModel kModels[] = {ShadingModel::kThesis, ShadingModel::kKajiyaKay, ShadingModel::kMarschner,
                                    ShadingModel::kVolume};

/// Grey, so that there is room above and below it.
MaterialRecord grey(ShadingModel model) {
  MaterialRecord m = plain_material();
  m.shading = model;
  m.tilt = 0.05f;
  m.roughness = 0.2f;
  m.scatter = 0.8f;
  for (int k = 0; k < 3; ++k) m.base_color[k] = m.ambient[k] = 0.4f;
  return m;
}

class StrandTerms : public GlTest {
 protected:
  /// The middle of a card, which has the eye on its edge where `is_edge`.
  int lightness(const MaterialRecord& material, const std::vector<Light>& lights, std::uint8_t shift = 128,
                bool is_edge = false) {
    DrawnCard card;
    card.half_size = 0.95f;
    card.shift_mask = {shift, 255};
    if (is_edge) card.normal = {1, 0, 0};
    AssetContents contents = card_contents(std::span(&card, 1));
    contents.material = {material};
    HeadDraw desc = at_rest();
    desc.lights = lights;
    clear();
    draw(contents, desc);
    return middle_pixel()[1];
  }

  static std::vector<Light> light_from(Vec3 towards, float color = 0.3f) {
    return {{Light::Kind::kDirectional, towards, {color, color, color}}};
  }
};

TEST_F(StrandTerms, GlowIsOfLightFromBehindAlone) {
  for (const ShadingModel model : kModels) {
    MaterialRecord plain = grey(model), glowing = plain;
    glowing.glow = 3;
    // Along its edge a volume lets much light through, without any glow.
    const float color = model == ShadingModel::kVolume ? 0.03f : 0.3f;
    const auto behind = light_from({0, 0, -1}, color), before = light_from({0, 0, 1}, color);
    EXPECT_GT(lightness(glowing, behind, 128, true), lightness(plain, behind, 128, true) + 5) << int(model);
    EXPECT_EQ(lightness(glowing, before), lightness(plain, before)) << int(model);
    EXPECT_EQ(lightness(glowing, behind), lightness(plain, behind)) << int(model) << ": not through the head";
  }
}

TEST_F(StrandTerms, RootsAreDarkerByTheirShade) {
  // Cards of made-up assets are roots all over.
  for (const ShadingModel model : kModels) {
    MaterialRecord material = grey(model);
    const int plain = lightness(material, {});
    material.root_shade = 0.5f;
    const int half = lightness(material, {});
    material.root_shade = 1;
    EXPECT_LT(half, plain - 20) << int(model);
    const int mirrored = model == ShadingModel::kVolume ? 24 : 0;  // by the fibres' surface, whatever is within
    EXPECT_LE(lightness(material, {}), mirrored) << int(model);
  }
}

TEST_F(StrandTerms, StrandsDifferByTheirShift) {
  for (const ShadingModel model : kModels) {
    MaterialRecord material = grey(model);
    // No highlight, which the shift would move: what differs is the strand's colour.
    for (float* color : {material.primary_color, material.secondary_color}) std::fill_n(color, 3, 0.0f);
    const int plain = lightness(material, {}, 128);
    if (model == ShadingModel::kVolume) {
      EXPECT_LT(lightness(material, {}, 30), plain - 8) << "a strand that lies deep";
      EXPECT_GT(lightness(material, {}, 220), plain + 8) << "and one that lies in front";
    } else {
      EXPECT_EQ(lightness(material, {}, 30), plain) << int(model);
      EXPECT_EQ(lightness(material, {}, 220), plain) << int(model);
    }
    material.variation = 0.5f;
    EXPECT_LT(lightness(material, {}, 30), plain - 15) << int(model);
    EXPECT_GT(lightness(material, {}, 220), plain + 10) << int(model);
    EXPECT_NEAR(lightness(material, {}, 128), plain, 1) << int(model);
  }
}

TEST_F(StrandTerms, AProgramWithoutThemHasNoLineOfThem) {
  lightness(grey(ShadingModel::kThesis), light_from({0, 0, 1}));
  bool defines = false;
  for (GLuint name = 1; name < 64; ++name) {
    if (glIsShader(name) != GL_TRUE) continue;
    std::vector<char> source(65536);
    GLsizei length = 0;
    glGetShaderSource(name, GLsizei(source.size()), &length, source.data());
    const std::string text(source.data(), std::size_t(length));
    defines = defines || text.find("#define COIF_STRAND_TERMS") != std::string::npos;
  }
  EXPECT_FALSE(defines);
}

}  // namespace coif::strand_terms_test
