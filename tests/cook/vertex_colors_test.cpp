#include "cook/texture/vertex_colors.h"
#include "cook/recipe/recipe.h"

#include "base/srgb.h"
#include "cook/built_models.h"
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::vertex_colors_test {

constexpr Rgba kWhite{255, 255, 255, 255};

std::uint8_t stored(double linear) { return std::uint8_t(std::lround(encode_srgb(linear) * 255)); }

class VertexColors : public testing::Test {
 protected:
  VertexColors() { model_.path = "wig.glb"; }

  /// A surface over the whole of a white image, or of none, whose vertices have the color of where they stand in the
  /// texture.
  importer::SourceMaterial& add(const char* name, bool has_image,
                                const std::function<Eigen::Vector4f(const Eigen::Vector2f&)>& color) {
    importer::SourceMaterial& material = add_surface(model_, name);
    if (has_image) {
      model_.images = {{"white", encoded(flat(64, 64, kWhite), FileFormat::kPng)}};
      material.base_texture.image = 0;
    }
    importer::SourceMesh& mesh = model_.meshes.back();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      mesh.colors.push_back(
          color(mesh.uvs.empty() ? Eigen::Vector2f(0, float(v) / float(mesh.positions.size() - 1)) : mesh.uvs[v]));
    }
    return material;
  }

  BaseColor cooked(const Recipe& recipe = default_recipe()) {
    hair_ = whole_hair(model_);
    findings_ = {};
    auto color = find_base_color(model_, hair_, recipe, {}, findings_);
    EXPECT_TRUE(color) << (color ? "" : color.error().message);
    if (!color) return {};
    if (!hair_.uvs.empty()) keep_vertex_colors(texture_limit(recipe), *color, hair_, findings_);
    return std::move(*color);
  }

  /// The image's texel in the middle of a triangle.
  [[nodiscard]] Rgba shown(const Image& image, std::size_t triangle) const {
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    for (std::size_t k = 0; k < 3; ++k) uv += hair_.uvs[hair_.triangles[3 * triangle + k]] / 3;
    return texel_at(image, uv);
  }

  importer::SourceModel model_;
  HairMesh hair_;
  Findings findings_;
};

TEST_F(VertexColors, OneColorOfAllIsTheFactorAndCostsNoTexel) {
  add("hair", true, [](const auto&) { return Eigen::Vector4f(0.5f, 0.25f, 0.125f, 0.75f); });
  const BaseColor color = cooked();
  EXPECT_TRUE(color.factor.isApprox(Eigen::Vector4f(0.5f, 0.25f, 0.125f, 0.75f)));
  ASSERT_TRUE(color.image);
  EXPECT_EQ(texel_at(*color.image, {0.5f, 0.5f}), kWhite);
  EXPECT_FALSE(color.atlas);
  EXPECT_TRUE(hair_.colors.empty());
}

TEST_F(VertexColors, AGradientMultipliesTheTexelsAsLight) {
  add("hair", true, [](const Eigen::Vector2f& uv) { return Eigen::Vector4f(uv.y(), 0.5f, 1 - uv.y(), 1 - uv.y()); });
  const BaseColor color = cooked();
  ASSERT_TRUE(color.image);
  EXPECT_FALSE(color.atlas);
  for (const float v : {0.25f, 0.5f, 0.75f}) {
    const Rgba wanted{stored(double(v)), stored(0.5), stored(1 - double(v)), std::uint8_t(std::lround(255 * (1 - v)))};
    EXPECT_LE(difference(texel_at(*color.image, {0.5f, v}), wanted), 4) << v;
  }
  EXPECT_TRUE(hair_.colors.empty());
  EXPECT_TRUE(findings_.warnings.empty()) << findings_.warnings[0].message;
}

TEST_F(VertexColors, WithoutATextureTheyAreTheColor) {
  add("hair", false, [](const Eigen::Vector2f& uv) { return Eigen::Vector4f(uv.y(), 0.1f, 0.1f, 1); });
  const BaseColor color = cooked();
  ASSERT_TRUE(color.image);
  EXPECT_LE(difference(texel_at(*color.image, {0.5f, 0.5f}), {stored(0.5), stored(0.1), stored(0.1), 255}), 6);
}

TEST_F(VertexColors, StripsThatShowTheSameTexelsInOtherColorsGetTheirOwn) {
  for (const float red : {0.1f, 0.5f, 0.9f}) {
    add("hair", true, [&](const Eigen::Vector2f& uv) { return Eigen::Vector4f(red, uv.y(), 0.2f, 1); });
    model_.meshes.back().material = 0;
  }
  const BaseColor color = cooked();
  ASSERT_TRUE(color.image && color.atlas);
  EXPECT_EQ(color.atlas->tiles.size(), 3u);
  EXPECT_TRUE(findings_.warnings.empty()) << findings_.warnings[0].message;
  EXPECT_TRUE(std::ranges::any_of(findings_.notes,
                                  [](const std::string& n) { return n.find("stored 3 times") != std::string::npos; }));
  const std::size_t each = hair_.triangle_count() / 3;
  const double reds[] = {0.1, 0.5, 0.9};
  for (std::size_t t = 0; t < hair_.triangle_count(); ++t) {
    EXPECT_NEAR(shown(*color.image, t)[0], stored(reds[t / each]), 2) << t;
  }
}

TEST_F(VertexColors, CopiesThatMustBeSmallerAreAWarning) {
  for (const float red : {0.1f, 0.5f, 0.9f}) {
    add("hair", true, [&](const Eigen::Vector2f& uv) { return Eigen::Vector4f(red, uv.y(), 0.2f, 1); });
    model_.meshes.back().material = 0;
  }
  Recipe recipe = default_recipe();
  recipe.texture_max_size = 64;
  (void)cooked(recipe);
  ASSERT_EQ(findings_.warnings.size(), 1u);
  EXPECT_NE(findings_.warnings[0].message.find("stored 3 times, at 58 % of its size"), std::string::npos)
      << findings_.warnings[0].message;
}

TEST_F(VertexColors, StripsThatAgreeShareTheirTexels) {
  for (int strip = 0; strip < 3; ++strip) {
    add("hair", true, [](const Eigen::Vector2f& uv) { return Eigen::Vector4f(0.5f, uv.y(), 0.2f, 1); });
    model_.meshes.back().material = 0;
  }
  const BaseColor color = cooked();
  EXPECT_FALSE(color.atlas);
  EXPECT_TRUE(findings_.warnings.empty());
}

TEST_F(VertexColors, AllBlackOrAllClearOnesAreNumbersUnlessTheRecipeInsists) {
  for (const Eigen::Vector4f& nothing : {Eigen::Vector4f(0, 0, 0, 1), Eigen::Vector4f(1, 1, 1, 0)}) {
    model_.meshes.clear();
    model_.materials.clear();
    add("hair", true, [&](const auto&) { return nothing; });
    EXPECT_EQ(cooked().factor, Eigen::Vector4f::Ones());
    ASSERT_EQ(findings_.warnings.size(), 1u);
    EXPECT_NE(findings_.warnings[0].message.find("\"textures.vertex_colors\""), std::string::npos);
    Recipe recipe = default_recipe();
    recipe.vertex_colors = coif::cook::VertexColors::kMultiply;
    EXPECT_EQ(cooked(recipe).factor, nothing);
  }
}

TEST_F(VertexColors, TheRecipeDoesWithoutThem) {
  add("hair", true, [](const auto&) { return Eigen::Vector4f(0.5f, 0.25f, 0.125f, 0.75f); });
  Recipe recipe = default_recipe();
  recipe.vertex_colors = coif::cook::VertexColors::kIgnore;
  EXPECT_EQ(cooked(recipe).factor, Eigen::Vector4f::Ones());
  EXPECT_TRUE(findings_.warnings.empty());
}

TEST_F(VertexColors, WithoutTextureCoordinatesAnImageOfTheColorsShowsThem) {
  add("hair", false, [](const Eigen::Vector2f& uv) { return Eigen::Vector4f(uv.y(), 0.3f, 0.1f, 1 - 0.5f * uv.y()); });
  model_.meshes.back().uvs.clear();
  (void)cooked();
  const std::vector<Eigen::Vector4f> given = hair_.colors;
  ASSERT_EQ(given.size(), model_.meshes.back().colors.size())
      << "left for later, since coordinates of colours are no places of strands";
  BaseColor color;
  keep_vertex_colors(1024, color, hair_, findings_);
  ASSERT_TRUE(color.image && color.is_of_vertex_colors);
  const Image& image = *color.image;
  ASSERT_EQ(hair_.uvs.size(), given.size());
  EXPECT_LE(image.width, 64u);
  for (std::size_t v = 0; v < given.size(); ++v) {
    const Rgba wanted{stored(double(given[v].x())), stored(double(given[v].y())), stored(double(given[v].z())),
                      std::uint8_t(std::lround(255 * given[v].w()))};
    EXPECT_LE(difference(texel_at(image, hair_.uvs[v]), wanted), 8) << v;
  }
  EXPECT_TRUE(findings_.warnings.empty()) << findings_.warnings[0].message;
}

}  // namespace coif::cook::vertex_colors_test
