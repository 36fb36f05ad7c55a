#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/recipe/recipe.h"
#include "cook/texture/base_color.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::opacity_test {

// Alpha from an image of its own.

constexpr Rgba kRed{200, 30, 20, 255};

class Opacity : public testing::Test {
 protected:
  Opacity() {
    model_.path = folder_.source("wig.obj").string();
    folder_.write_flat("rgb.png", kRed);
    add_surface(model_, "strands").base_texture.path = "rgb.png";
  }

  BaseColor cooked(const Recipe& recipe = default_recipe()) {
    HairMesh hair = whole_hair(model_);
    findings_ = {};
    const auto color = find_base_color(model_, hair, recipe, {.recipe_directory = folder_.path()}, findings_);
    EXPECT_TRUE(color) << (color ? "" : color.error().message);
    return color ? *color : BaseColor{};
  }

  /// RGBA in the middle of the cooked image.
  Rgba shown(const Recipe& recipe = default_recipe()) {
    const BaseColor color = cooked(recipe);
    EXPECT_TRUE(color.image);
    return color.image ? texel_at(*color.image, {0.5f, 0.5f}) : Rgba{};
  }

  Rgba by_recipe(TextureChannel channel, bool is_inverted = false) {
    Recipe recipe = default_recipe();
    recipe.opacity_texture = {"map.png", channel, is_inverted};
    return shown(recipe);
  }

  importer::SourceMaterial& material() { return model_.materials[0]; }

  ImageFolder folder_;
  importer::SourceModel model_;
  Findings findings_;
};

TEST_F(Opacity, AMapOfTheFileIsTheAlpha) {
  folder_.write_flat("map.png", {60, 60, 60, 255});
  material().opacity_texture.path = "map.png";
  EXPECT_EQ(shown(), (Rgba{200, 30, 20, 60}));
  EXPECT_TRUE(findings_.warnings.empty());
  const auto told = std::ranges::find_if(
      findings_.notes, [](const std::string& n) { return n.find("\"opacity\"") != std::string::npos; });
  EXPECT_NE(told, findings_.notes.end()) << "with the key that chooses another";
}

TEST_F(Opacity, ItIsLookedForInAlphaThenInLuminance) {
  folder_.write_flat("map.png", {255, 255, 255, 90});
  material().opacity_texture.path = "map.png";
  EXPECT_EQ(shown()[3], 90);
}

TEST_F(Opacity, TheFilesChannelAndDirectionHold) {
  folder_.write_flat("map.png", {10, 20, 30, 255});
  material().opacity_texture.path = "map.png";
  material().opacity_channel = TextureChannel::kGreen;
  EXPECT_EQ(shown()[3], 20);
  material().opacity_inverted = true;
  EXPECT_EQ(shown()[3], 235);
}

TEST_F(Opacity, ASmallMapIsInterpolatedOverALargeImage) {
  folder_.write("map.png", encoded(painted(2, 1,
                                           [](std::uint32_t x, std::uint32_t) {
                                             const std::uint8_t grey = x == 0 ? 0 : 255;
                                             return Rgba{grey, grey, grey, 255};
                                           }),
                                   FileFormat::kPng));
  folder_.write("rgb.png", encoded(flat(64, 64, kRed), FileFormat::kPng));
  material().opacity_texture.path = "map.png";
  const BaseColor color = cooked();
  EXPECT_EQ(color.image->width, 64u);
  const int middle = texel_at(*color.image, {0.5f, 0.5f})[3];
  EXPECT_NEAR(middle, 128, 12);
  EXPECT_EQ(texel_at(*color.image, {0.5f, 0.5f})[0], 200);
}

TEST_F(Opacity, WithoutABaseTextureItIsOverTheColor) {
  folder_.write_flat("map.png", {60, 60, 60, 255});
  material().base_texture.path.clear();
  material().base_color = {0.5f, 0.2f, 0.1f, 1};
  material().opacity_texture.path = "map.png";
  EXPECT_EQ(shown(), (Rgba{255, 255, 255, 60}));
  EXPECT_TRUE(cooked().factor.isApprox(Eigen::Vector4f(0.5f, 0.2f, 0.1f, 1)));
}

TEST_F(Opacity, TheRecipesMapReplacesTheFiles) {
  folder_.write_flat("map.png", {10, 20, 30, 200});
  material().opacity_texture.path = "lost.png";
  material().alpha_use = importer::AlphaUse::kOpaque;
  EXPECT_EQ(by_recipe(TextureChannel::kAuto)[3], 200);
  EXPECT_EQ(by_recipe(TextureChannel::kRed)[3], 10);
  EXPECT_EQ(by_recipe(TextureChannel::kBlue)[3], 30);
  EXPECT_EQ(by_recipe(TextureChannel::kAlpha, true)[3], 55);
  EXPECT_TRUE(findings_.warnings.empty()) << "what is replaced is not missed: " << findings_.warnings[0].message;
  Recipe recipe = default_recipe();
  recipe.opacity_texture.file = "map.png";
  EXPECT_NE(cooked(recipe).alpha_use, importer::AlphaUse::kOpaque) << "who names a map of alpha wants it seen";
  EXPECT_EQ(cooked(recipe).recipe_files, std::vector{folder_.path() / "map.png"});
}

TEST_F(Opacity, ARecipesMapThatIsLostIsAnErrorWithTheKey) {
  Recipe recipe = default_recipe();
  recipe.opacity_texture.file = "lost.png";
  HairMesh hair = whole_hair(model_);
  const auto color = find_base_color(model_, hair, recipe, {.recipe_directory = folder_.path()}, findings_);
  ASSERT_FALSE(color);
  EXPECT_EQ(color.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(color.error().message.find("\"textures.opacity\""), std::string::npos);
}

TEST_F(Opacity, ABaseColorOfTheRecipeMayBeOneChannel) {
  folder_.write_flat("map.png", {10, 20, 30, 200});
  Recipe recipe = default_recipe();
  recipe.base_color_texture = {"map.png", TextureChannel::kGreen, false};
  EXPECT_EQ(shown(recipe), (Rgba{20, 20, 20, 255}));
}

}  // namespace coif::cook::opacity_test
