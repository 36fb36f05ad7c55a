#include "cook/recipe/recipe.h"
#include "cook/texture/base_color.h"

#include "cook/built_models.h"
#include "cook/image_files.h"

#include <gtest/gtest.h>

namespace coif::cook::texture_wrap_test {

// What a triangle shows after the cook, whose textures repeat, is what its file's sampler shows.

Rgba gradient(std::uint32_t x, std::uint32_t y) { return {std::uint8_t(8 * x), std::uint8_t(8 * y), 100, 255}; }

class TextureWraps : public testing::Test {
 protected:
  BaseColor cooked(importer::TextureWrap wrap, const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
    model_ = {};
    model_.path = "wig.glb";
    model_.images = {{"gradient", encoded(painted(32, 32, gradient), FileFormat::kPng)}};
    importer::SourceMaterial& material = add_surface(model_, "hair", low, high);
    material.base_texture.image = 0;
    material.base_texture.wrap[0] = material.base_texture.wrap[1] = wrap;
    before_ = hair_ = whole_hair(model_);
    findings_ = {};
    const auto color = find_base_color(model_, hair_, default_recipe(), {}, findings_);
    EXPECT_TRUE(color);
    return color ? *color : BaseColor{};
  }

  /// Compares many places of each triangle with what the sampler shows there.
  void expect_shown(const BaseColor& color, float (*sampled)(float)) const {
    ASSERT_TRUE(color.image);
    for (std::size_t t = 0; t < hair_.triangle_count(); ++t) {
      for (const auto& w : {Eigen::Vector3f(0.34f, 0.33f, 0.33f), Eigen::Vector3f(0.8f, 0.1f, 0.1f),
                            Eigen::Vector3f(0.1f, 0.8f, 0.1f), Eigen::Vector3f(0.1f, 0.1f, 0.8f)}) {
        Eigen::Vector2f was(0, 0), is(0, 0);
        for (std::size_t k = 0; k < 3; ++k) {
          const auto i = Eigen::Index(k);
          was += w[i] * before_.uvs[before_.triangles[3 * t + k]];
          is += w[i] * hair_.uvs[hair_.triangles[3 * t + k]];
        }
        const auto at = [&](float u) { return std::uint32_t(std::min(31.0f, sampled(u) * 32)); };
        EXPECT_LE(difference(texel_at(*color.image, is), gradient(at(was.x()), at(was.y()))), 10) << was.transpose();
      }
    }
  }

  importer::SourceModel model_;
  HairMesh before_, hair_;
  Findings findings_;
};

float clamped(float u) { return std::clamp(u, 0.0f, 1.0f); }
float mirrored(float u) {
  const float two = u - 2 * std::floor(u / 2);
  return two <= 1 ? two : 2 - two;
}

TEST_F(TextureWraps, ClampedImagesGoOnWithTheirEdge) {
  const BaseColor color = cooked(importer::TextureWrap::kClamp, {-0.3f, -0.1f}, {1.25f, 1.2f});
  EXPECT_TRUE(color.atlas) << "a tile as large as the coordinates reach";
  expect_shown(color, clamped);
  EXPECT_TRUE(findings_.warnings.empty());
}

TEST_F(TextureWraps, ClampedImagesThatNobodyLeavesStayAsTheyAre) {
  const BaseColor color = cooked(importer::TextureWrap::kClamp, {0, 0}, {1, 1});
  EXPECT_FALSE(color.atlas);
  EXPECT_EQ(color.image->width, 32u);
  expect_shown(color, clamped);
  for (const Eigen::Vector2f& uv : hair_.uvs) {
    EXPECT_GE(uv.minCoeff(), 0.5f / 32) << "filtering would reach over to the other side";
    EXPECT_LE(uv.maxCoeff(), 1 - 0.5f / 32);
  }
}

TEST_F(TextureWraps, WhatIsFartherOutThanATileCanBeIsTold) {
  (void)cooked(importer::TextureWrap::kClamp, {-3, 0}, {4, 1});
  ASSERT_EQ(findings_.warnings.size(), 1u);
  EXPECT_NE(findings_.warnings[0].message.find("clamped"), std::string::npos);
}

TEST_F(TextureWraps, MirroredImagesThatAreCrossedAreStoredWithTheirMirrorImage) {
  const BaseColor color = cooked(importer::TextureWrap::kMirror, {-0.7f, 0.2f}, {2.6f, 3.9f});
  EXPECT_EQ(color.image->width, 64u);
  expect_shown(color, mirrored);
}

TEST_F(TextureWraps, MirroredImagesThatNobodyCrossesAreFolded) {
  const BaseColor color = cooked(importer::TextureWrap::kMirror, {1, 0}, {2, 1});
  EXPECT_EQ(color.image->width, 32u);
  expect_shown(color, mirrored);
}

TEST_F(TextureWraps, RepeatingImagesAreLeftAlone) {
  const BaseColor color = cooked(importer::TextureWrap::kRepeat, {-0.3f, 0}, {1.5f, 2});
  EXPECT_FALSE(color.atlas);
  EXPECT_EQ(hair_.uvs, before_.uvs);
}

}  // namespace coif::cook::texture_wrap_test
