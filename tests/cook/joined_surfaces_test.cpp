#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/recipe/recipe.h"
#include "cook/texture/base_color.h"

#include <coif/asset_records.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::joined_surfaces_test {

// Hair of several materials that look different, in one image.

constexpr Rgba kRed{200, 30, 20, 255};
constexpr Rgba kBlue{20, 30, 200, 128};

class JoinedSurfaces : public testing::Test {
 protected:
  importer::SourceMaterial& add(const char* name, const Image& image, const Eigen::Vector2f& high = {1, 1}) {
    model_.path = "wig.glb";
    model_.images.push_back({name, encoded(image, FileFormat::kPng)});
    importer::SourceMaterial& material = add_surface(model_, name, {0.1f, 0.1f}, high);
    material.base_texture.image = std::uint32_t(model_.images.size() - 1);
    return material;
  }

  BaseColor joined() {
    before_ = hair_ = whole_hair(model_);
    findings_ = {};
    const auto color = find_base_color(model_, hair_, default_recipe(), {}, findings_);
    EXPECT_TRUE(color) << (color ? "" : color.error().message);
    return color ? *color : BaseColor{};
  }

  /// The image's texel in the middle of a triangle.
  Rgba shown(const Image& image, const HairMesh& hair, std::size_t triangle) const {
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    for (std::size_t k = 0; k < 3; ++k) uv += hair.uvs[hair.triangles[3 * triangle + k]] / 3;
    return texel_at(image, uv);
  }

  importer::SourceModel model_;
  HairMesh before_, hair_;
  Findings findings_;
};

TEST_F(JoinedSurfaces, EachTriangleShowsItsOwnImage) {
  const auto gradient = [](std::uint8_t blue) {
    return painted(40, 24, [=](std::uint32_t x, std::uint32_t y) {
      return Rgba{std::uint8_t(x * 6), std::uint8_t(y * 10), blue, 255};
    });
  };
  const Image images[] = {gradient(0), gradient(255)};
  add("left", images[0], {0.9f, 0.7f});
  add("right", images[1]);
  const BaseColor color = joined();
  ASSERT_TRUE(color.atlas);
  EXPECT_TRUE(findings_.warnings.empty());
  for (std::size_t t = 0; t < hair_.triangle_count(); ++t) {
    const Rgba wanted = shown(images[before_.mesh_of_triangle[t]], before_, t);
    EXPECT_LE(difference(shown(*color.image, hair_, t), wanted), 10) << t << ": more than a texel off";
  }
  for (const Eigen::Vector2f& uv : hair_.uvs) {
    EXPECT_TRUE((uv.array() >= 0).all() && (uv.array() <= 1).all());
  }
}

TEST_F(JoinedSurfaces, AColorWithoutAnImageBecomesATile) {
  add("strands", flat(16, 16, kRed));
  add_surface(model_, "band").base_color = {1.0f, 0.2158605f, 0, 1};  // Linear; 128 as sRGB.
  const BaseColor color = joined();
  ASSERT_TRUE(color.atlas);
  EXPECT_EQ(color.factor, Eigen::Vector4f::Ones()) << "factors are in the tiles";
  const std::size_t last = hair_.triangle_count() - 1;
  EXPECT_EQ(shown(*color.image, hair_, 0), kRed);
  EXPECT_EQ(shown(*color.image, hair_, last), (Rgba{255, 128, 0, 255}));
}

TEST_F(JoinedSurfaces, EachIsLitByItsOwnNormalMapOrByNone) {
  const auto lean_of = [this](const Image& image, std::size_t triangle) {
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    for (std::size_t k = 0; k < 3; ++k) uv += hair_.uvs[hair_.triangles[3 * triangle + k]] / 3;
    const std::size_t texel = repeated(uv.y(), image.height) * image.width + repeated(uv.x(), image.width);
    const auto value = [&](std::size_t c) { return two_sided(float(image.texels[2 * texel + c]) / 255); };
    return Eigen::Vector2f(value(0), value(1));
  };
  importer::SourceMaterial& leaning = add("strands", flat(16, 16, kRed));
  model_.images.push_back({"normals", encoded(flat(64, 64, {204, 128, 230, 255}), FileFormat::kPng)});
  leaning.normal_texture.image = std::uint32_t(model_.images.size() - 1);
  add("band", flat(16, 16, kBlue));
  const BaseColor color = joined();
  ASSERT_TRUE(color.atlas && color.normals);
  EXPECT_EQ(color.normals->width, color.image->width);
  EXPECT_GE(color.atlas->tiles[0].width, 50u) << "as large as the finer of its two images";
  EXPECT_LT((lean_of(*color.normals, 0) - Eigen::Vector2f(0.6f, 0)).norm(), 0.02f);
  EXPECT_EQ(lean_of(*color.normals, hair_.triangle_count() - 1), Eigen::Vector2f(0, 0));
}

TEST_F(JoinedSurfaces, APartWhoseTextureIsLostLooksLikeTheRest) {
  add("strands", painted(16, 16, [](std::uint32_t x, std::uint32_t) {
        return x < 8 ? kRed : Rgba{255, 255, 255, 10};  // as good as clear
      }));
  add_surface(model_, "core").base_texture.path = "lost.tga";
  const BaseColor color = joined();
  ASSERT_TRUE(color.atlas);
  EXPECT_LE(difference(shown(*color.image, hair_, hair_.triangle_count() - 1), kRed), 1);
}

TEST_F(JoinedSurfaces, OneNormalMapServesMaterialsThatDifferInNothingElse) {
  model_.images.push_back({"normals", encoded(flat(8, 8, {204, 128, 230, 255}), FileFormat::kPng)});
  add("front", flat(16, 16, kRed));
  importer::SourceMaterial& back = add_surface(model_, "back");
  back.base_texture.image = 1;
  back.normal_texture.image = 0;
  const BaseColor color = joined();
  EXPECT_FALSE(color.atlas);
  EXPECT_TRUE(color.normals);
}

TEST_F(JoinedSurfaces, AnAtlasIsScaledIntoTheLimitAndNotHalved) {
  for (const std::uint32_t limit : {64u, 128u, 200u, 256u}) {
    model_ = {};
    add("strands", flat(256, 256, kRed), {1, 1});
    add("band", flat(100, 30, kBlue), {1, 1});
    hair_ = whole_hair(model_);
    Recipe recipe = default_recipe();
    recipe.texture_max_size = limit;
    const auto color = find_base_color(model_, hair_, recipe, {}, unheard());
    ASSERT_TRUE(color && color->atlas) << limit;
    const std::uint32_t side = std::max(color->image->width, color->image->height);
    EXPECT_LE(side, limit);
    EXPECT_GT(side, limit / 2) << "as large as halving would leave it";
    EXPECT_EQ(shown(*color->image, hair_, 0), kRed) << limit;
    EXPECT_EQ(shown(*color->image, hair_, hair_.triangle_count() - 1), kBlue) << limit;
  }
}

TEST_F(JoinedSurfaces, ALimitBelowTheGuttersStillGivesAnAtlas) {
  add("strands", flat(64, 64, kRed));
  add("band", flat(64, 64, kBlue));
  hair_ = whole_hair(model_);
  Recipe recipe = default_recipe();
  recipe.texture_max_size = 1;
  const auto color = find_base_color(model_, hair_, recipe, {}, unheard());
  ASSERT_TRUE(color);
  EXPECT_TRUE(color->atlas);
}

TEST_F(JoinedSurfaces, MaterialsThatLookTheSameNeedNoAtlas) {
  add("front", flat(16, 16, kRed));
  importer::SourceMaterial& back = add_surface(model_, "back");
  back.base_texture.image = 0;
  const BaseColor color = joined();
  EXPECT_FALSE(color.atlas);
  EXPECT_EQ(color.image->texels, flat(16, 16, kRed).texels);
  EXPECT_EQ(hair_.uvs, before_.uvs);
}

TEST_F(JoinedSurfaces, ImagesThatRepeatOftenLeaveTheMainMaterialAndAWarning) {
  add("rare", flat(16, 16, kBlue), {0.5f, 9.0f});
  add("main", flat(16, 16, kRed));
  add_surface(model_, "main again").base_texture.image = 1;
  const BaseColor color = joined();
  EXPECT_FALSE(color.atlas);
  EXPECT_EQ(texel_at(*color.image, {0.5f, 0.5f}), kRed);
  ASSERT_EQ(findings_.warnings.size(), 1u);
  EXPECT_NE(findings_.warnings[0].message.find("repeat an image more than 2 times"), std::string::npos)
      << findings_.warnings[0].message;
  EXPECT_NE(findings_.warnings[0].message.find("('main')"), std::string::npos);
  EXPECT_EQ(hair_.uvs, before_.uvs);
}

TEST_F(JoinedSurfaces, OpaqueAndMaskedPartsStayWhatTheyAre) {
  add("band", flat(16, 16, kBlue)).alpha_use = importer::AlphaUse::kOpaque;
  importer::SourceMaterial& strands = add("strands", flat(16, 16, {9, 9, 9, 100}));
  strands.alpha_use = importer::AlphaUse::kMask;
  strands.alpha_cutoff = 0.3f;
  const BaseColor color = joined();
  EXPECT_EQ(color.alpha_use, importer::AlphaUse::kMask);
  EXPECT_FLOAT_EQ(color.alpha_cutoff, 0.3f);
  EXPECT_EQ(shown(*color.image, hair_, 0)[3], 255) << "opaque whatever its image holds";
  EXPECT_EQ(shown(*color.image, hair_, hair_.triangle_count() - 1)[3], 100);
}

TEST_F(JoinedSurfaces, MasksOfDifferentCutoffsAreCutEachByItsOwn) {
  const float cutoffs[] = {0.3f, 0.6f};
  for (const float cutoff : cutoffs) {
    importer::SourceMaterial& material = add("strands", flat(16, 16, {9, 9, 9, 115}));  // Alpha 0.45.
    material.alpha_use = importer::AlphaUse::kMask;
    material.alpha_cutoff = cutoff;
  }
  const BaseColor color = joined();
  EXPECT_EQ(color.alpha_use, importer::AlphaUse::kMask);
  EXPECT_EQ(shown(*color.image, hair_, 0)[3], 255);
  EXPECT_EQ(shown(*color.image, hair_, hair_.triangle_count() - 1)[3], 0);
}

TEST_F(JoinedSurfaces, BlendedPartsMakeAllOfItMeasured) {
  add("strands", flat(16, 16, kBlue)).alpha_use = importer::AlphaUse::kBlend;
  add("band", flat(16, 16, kRed)).alpha_use = importer::AlphaUse::kOpaque;
  const BaseColor color = joined();
  EXPECT_EQ(color.alpha_use, importer::AlphaUse::kUnknown);
  EXPECT_EQ(shown(*color.image, hair_, 0), kBlue);
}

}  // namespace coif::cook::joined_surfaces_test
