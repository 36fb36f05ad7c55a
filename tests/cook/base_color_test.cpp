#include "cook/texture/base_color.h"
#include "cook/built_models.h"
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::base_color_test {

constexpr Rgba kRed{200, 30, 20, 255};
constexpr Rgba kGreen{30, 180, 40, 255};

SourceModel model_beside(const ImageFolder& folder, const std::string& name) {
  SourceModel model;
  model.path = folder.source(name).string();
  return model;
}

/// A hair's colour, and what was said of it.
struct SaidColor : BaseColor, Findings {};

SaidColor base_color_in(const SourceModel& model, HairMesh& hair, const Recipe& recipe) {
  Findings findings;
  auto color = find_base_color(model, hair, recipe, {}, findings);
  EXPECT_TRUE(color) << (color ? "" : color.error().message);
  return {color ? std::move(*color) : BaseColor{}, findings};
}

SaidColor base_color_of(const SourceModel& model, const Recipe& recipe = default_recipe()) {
  HairMesh hair = whole_hair(model);
  return base_color_in(model, hair, recipe);
}

/// The one warning; else what is wrong.
std::string only_warning(const SaidColor& color) {
  return color.warnings.size() == 1 ? color.warnings[0] : std::to_string(color.warnings.size()) + " warnings";
}

bool has_color(const BaseColor& color, const Rgba& wanted) {
  return color.image && texel_at(*color.image, {0.5f, 0.5f}) == wanted;
}

TEST(BaseColor, ATextureWhereTheFileSaysIsTakenWithoutAWord) {
  const ImageFolder folder;
  folder.write_flat("maps/strands.png", kRed);
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "maps/strands.png";
  const SaidColor color = base_color_of(model);
  EXPECT_TRUE(has_color(color, kRed));
  EXPECT_TRUE(color.warnings.empty()) << color.warnings[0];
  EXPECT_EQ(color.files, std::vector{folder.path() / "maps/strands.png"});
}

TEST(BaseColor, ATextureFoundElsewhereIsTakenWithAWarning) {
  const ImageFolder folder;
  folder.write_flat("Textures/Strands.png", kRed);
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "D:\\art\\strands.psd";
  const SaidColor color = base_color_of(model);
  EXPECT_TRUE(has_color(color, kRed));
  EXPECT_EQ(only_warning(color), "material 'strands': texture 'D:\\art\\strands.psd' taken from Textures/Strands.png");
}

TEST(BaseColor, WhatWasAskedOfTheFolderIsToldWithItsAnswer) {
  const ImageFolder folder;
  folder.write_flat("strands.png", kRed);
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  ASSERT_EQ(color.questions.size(), 1u);
  EXPECT_EQ(color.questions[0].kind, TextureQuestion::Kind::kFind);
  EXPECT_EQ(color.questions[0].answer, std::vector<std::string>{"strands.png"});
  const TextureFolder textures(model.path);
  EXPECT_EQ(answer_to(color.questions[0], textures), color.questions[0].answer);

  Recipe recipe = default_recipe();
  recipe.base_color_texture = (folder.path() / "strands.png").string();
  EXPECT_TRUE(base_color_of(model, recipe).questions.empty()) << "the recipe leaves nothing to ask";
}

TEST(BaseColor, ATextureInVainIsAskedForAndEveryImageIsListed) {
  const ImageFolder folder;
  folder.write_flat("sofa.png");
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  ASSERT_EQ(color.questions.size(), 2u);
  EXPECT_TRUE(color.questions[0].answer.empty());
  EXPECT_EQ(color.questions[1].kind, TextureQuestion::Kind::kImages);
  EXPECT_EQ(color.questions[1].answer, std::vector<std::string>{"sofa.png"});
}

TEST(BaseColor, AMissingTextureIsAWarningThatListsWhatIsThere) {
  const ImageFolder folder;
  folder.write_flat("a.png");
  folder.write_flat("b.png");
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("'strands.png': no such file"), std::string::npos) << only_warning(color);
  EXPECT_NE(only_warning(color).find("a.png, b.png"), std::string::npos);
}

TEST(BaseColor, AnImageThatCannotBeReadIsAWarning) {
  const ImageFolder folder;
  folder.write("strands.png", std::vector<std::uint8_t>{'n', 'o'});
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("cannot read the image"), std::string::npos) << only_warning(color);
}

TEST(BaseColor, EmbeddedImagesAreDecoded) {
  for (const FileFormat format : {FileFormat::kPng, FileFormat::kJpeg}) {
    SourceModel model;
    model.path = "wig.glb";
    model.images.push_back({"strands", encoded(flat(8, 8, kRed), format)});
    add_surface(model, "strands").base_texture.image = 0;
    const SaidColor color = base_color_of(model);
    ASSERT_TRUE(color.image);
    EXPECT_LE(difference(texel_at(*color.image, {0.5f, 0.5f}), kRed), 4);
    EXPECT_TRUE(color.warnings.empty());
    EXPECT_TRUE(color.files.empty());
  }
}

TEST(BaseColor, ABrokenEmbeddedImageIsAWarningThatNamesIt) {
  SourceModel model;
  model.path = "wig.glb";
  model.images.push_back({"strands", {1, 2, 3}});
  add_surface(model, "hair").base_texture.image = 0;
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("embedded image 'strands'"), std::string::npos) << only_warning(color);
}

TEST(BaseColor, OneImageWhoseNameFitsIsTakenWithAWarning) {
  // Called like the source, the material, or hair; the skin beside it is not meant.
  for (const char* image : {"long2_texture.png", "Strands.tga", "hair.png"}) {
    const ImageFolder folder;
    folder.write_flat(image, kRed);
    folder.write_flat("skin.png");
    folder.write_flat("hair_normal.png");
    SourceModel model = model_beside(folder, "long2.obj");
    add_surface(model, "strands").base_color = {0.6f, 0.6f, 0.6f, 1};
    const SaidColor color = base_color_of(model);
    EXPECT_TRUE(has_color(color, kRed)) << image;
    EXPECT_EQ(color.factor, Eigen::Vector4f::Ones()) << "grey of the exporter, not of the artist";
    EXPECT_NE(only_warning(color).find(std::string(image) + " is taken"), std::string::npos) << only_warning(color);
  }
}

TEST(BaseColor, SeveralImagesThatFitAreListedAndNoneIsTaken) {
  const ImageFolder folder;
  folder.write_flat("hair_red.png");
  folder.write_flat("tex/hair_blond.png");
  SourceModel model = model_beside(folder, "wig.obj");
  add_surface(model, "strands");
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("hair_red.png, tex/hair_blond.png"), std::string::npos) << only_warning(color);
  EXPECT_NE(only_warning(color).find(R"("textures": {"base_color": "hair_red.png"})"), std::string::npos);
}

TEST(BaseColor, AGltfWithoutATextureMeansIt) {
  const ImageFolder folder;
  folder.write_flat("hair.png");
  SourceModel model = model_beside(folder, "wig.glb");
  add_surface(model, "hair").base_color = {0.5f, 0.2f, 0.1f, 1};
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_TRUE(color.warnings.empty());
  EXPECT_EQ(color.factor, Eigen::Vector4f(0.5f, 0.2f, 0.1f, 1));
}

TEST(BaseColor, TheImageOfTheRecipeComesFirstAndMustBeThere) {
  const ImageFolder folder;
  folder.write_flat("strands.png", kRed);
  folder.write_flat("mine.png", kGreen);
  SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  Recipe recipe = default_recipe();
  recipe.base_color_texture = (folder.path() / "mine.png").string();
  EXPECT_TRUE(has_color(base_color_of(model, recipe), kGreen));
  recipe.base_color_texture = "absent.png";
  HairMesh hair = whole_hair(model);
  const auto color = find_base_color(model, hair, recipe, {}, unheard());
  ASSERT_FALSE(color);
  EXPECT_NE(color.error().message.find("\"textures.base_color\""), std::string::npos);
}

// Hair of several materials that look different, in one image.

constexpr Rgba kBlue{20, 30, 200, 128};

class JoinedSurfaces : public testing::Test {
 protected:
  SourceMaterial& add(const char* name, const Image& image, const Eigen::Vector2f& high = {1, 1}) {
    model_.path = "wig.glb";
    model_.images.push_back({name, encoded(image, FileFormat::kPng)});
    SourceMaterial& material = add_surface(model_, name, {0.1f, 0.1f}, high);
    material.base_texture.image = std::uint32_t(model_.images.size() - 1);
    return material;
  }

  SaidColor joined() {
    before_ = hair_ = whole_hair(model_);
    return base_color_in(model_, hair_, default_recipe());
  }

  /// The image's texel in the middle of a triangle.
  Rgba shown(const Image& image, const HairMesh& hair, std::size_t triangle) const {
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    for (std::size_t k = 0; k < 3; ++k) uv += hair.uvs[hair.triangles[3 * triangle + k]] / 3;
    return texel_at(image, uv);
  }

  SourceModel model_;
  HairMesh before_, hair_;
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
  const SaidColor color = joined();
  ASSERT_TRUE(color.atlas);
  EXPECT_TRUE(color.warnings.empty());
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
  const SaidColor color = joined();
  ASSERT_TRUE(color.atlas);
  EXPECT_EQ(color.factor, Eigen::Vector4f::Ones()) << "factors are in the tiles";
  const std::size_t last = hair_.triangle_count() - 1;
  EXPECT_EQ(shown(*color.image, hair_, 0), kRed);
  EXPECT_EQ(shown(*color.image, hair_, last), (Rgba{255, 128, 0, 255}));
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
  SourceMaterial& back = add_surface(model_, "back");
  back.base_texture.image = 0;
  const SaidColor color = joined();
  EXPECT_FALSE(color.atlas);
  EXPECT_EQ(color.image->texels, flat(16, 16, kRed).texels);
  EXPECT_EQ(hair_.uvs, before_.uvs);
}

TEST_F(JoinedSurfaces, ImagesThatRepeatOftenLeaveTheMainMaterialAndAWarning) {
  add("rare", flat(16, 16, kBlue), {0.5f, 9.0f});
  add("main", flat(16, 16, kRed));
  add_surface(model_, "main again").base_texture.image = 1;
  const SaidColor color = joined();
  EXPECT_FALSE(color.atlas);
  EXPECT_EQ(texel_at(*color.image, {0.5f, 0.5f}), kRed);
  ASSERT_EQ(color.warnings.size(), 1u);
  EXPECT_NE(color.warnings[0].find("repeat an image more than 2 times"), std::string::npos) << color.warnings[0];
  EXPECT_NE(color.warnings[0].find("('main')"), std::string::npos);
  EXPECT_EQ(hair_.uvs, before_.uvs);
}

TEST_F(JoinedSurfaces, OpaqueAndMaskedPartsStayWhatTheyAre) {
  add("band", flat(16, 16, kBlue)).alpha_use = AlphaUse::kOpaque;
  SourceMaterial& strands = add("strands", flat(16, 16, {9, 9, 9, 100}));
  strands.alpha_use = AlphaUse::kMask;
  strands.alpha_cutoff = 0.3f;
  const SaidColor color = joined();
  EXPECT_EQ(color.alpha_use, AlphaUse::kMask);
  EXPECT_FLOAT_EQ(color.alpha_cutoff, 0.3f);
  EXPECT_EQ(shown(*color.image, hair_, 0)[3], 255) << "opaque whatever its image holds";
  EXPECT_EQ(shown(*color.image, hair_, hair_.triangle_count() - 1)[3], 100);
}

TEST_F(JoinedSurfaces, MasksOfDifferentCutoffsAreCutEachByItsOwn) {
  const float cutoffs[] = {0.3f, 0.6f};
  for (const float cutoff : cutoffs) {
    SourceMaterial& material = add("strands", flat(16, 16, {9, 9, 9, 115}));  // Alpha 0.45.
    material.alpha_use = AlphaUse::kMask;
    material.alpha_cutoff = cutoff;
  }
  const SaidColor color = joined();
  EXPECT_EQ(color.alpha_use, AlphaUse::kMask);
  EXPECT_EQ(shown(*color.image, hair_, 0)[3], 255);
  EXPECT_EQ(shown(*color.image, hair_, hair_.triangle_count() - 1)[3], 0);
}

TEST_F(JoinedSurfaces, BlendedPartsMakeAllOfItMeasured) {
  add("strands", flat(16, 16, kBlue)).alpha_use = AlphaUse::kBlend;
  add("band", flat(16, 16, kRed)).alpha_use = AlphaUse::kOpaque;
  const SaidColor color = joined();
  EXPECT_EQ(color.alpha_use, AlphaUse::kUnknown);
  EXPECT_EQ(shown(*color.image, hair_, 0), kBlue);
}

}  // namespace coif::base_color_test
