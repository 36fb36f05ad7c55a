#include "cook/texture/base_color.h"
#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::base_color_test {

constexpr Rgba kRed{200, 30, 20, 255};
constexpr Rgba kGreen{30, 180, 40, 255};

importer::SourceModel model_beside(const ImageFolder& folder, const std::string& name) {
  importer::SourceModel model;
  model.path = folder.source(name).string();
  return model;
}

/// A hair's colour, and what was said of it.
struct SaidColor : BaseColor, Findings {};

SaidColor base_color_of(const importer::SourceModel& model, const Recipe& recipe = default_recipe()) {
  HairMesh hair = whole_hair(model);
  Findings findings;
  auto color = find_base_color(model, hair, recipe, {}, findings);
  EXPECT_TRUE(color) << (color ? "" : color.error().message);
  return {color ? std::move(*color) : BaseColor{}, findings};
}

/// The one warning; else what is wrong.
std::string only_warning(const SaidColor& color) {
  return color.warnings.size() == 1 ? color.warnings[0].message : std::to_string(color.warnings.size()) + " warnings";
}

bool has_color(const BaseColor& color, const Rgba& wanted) {
  return color.image && texel_at(*color.image, {0.5f, 0.5f}) == wanted;
}

TEST(BaseColor, ATextureWhereTheFileSaysIsTakenWithoutAWord) {
  const ImageFolder folder;
  folder.write_flat("maps/strands.png", kRed);
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "maps/strands.png";
  const SaidColor color = base_color_of(model);
  EXPECT_TRUE(has_color(color, kRed));
  EXPECT_TRUE(color.warnings.empty()) << color.warnings[0].message;
  EXPECT_EQ(color.files, std::vector{folder.path() / "maps/strands.png"});
}

TEST(BaseColor, ATextureFoundElsewhereIsTakenWithAWarning) {
  const ImageFolder folder;
  folder.write_flat("Textures/Strands.png", kRed);
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "D:\\art\\strands.psd";
  const SaidColor color = base_color_of(model);
  EXPECT_TRUE(has_color(color, kRed));
  EXPECT_EQ(only_warning(color), "material 'strands': texture 'D:\\art\\strands.psd' taken from Textures/Strands.png");
}

TEST(BaseColor, WhatWasAskedOfTheFolderIsToldWithItsAnswer) {
  const ImageFolder folder;
  folder.write_flat("strands.png", kRed);
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  ASSERT_EQ(color.questions.size(), 1u);
  EXPECT_EQ(color.questions[0].kind, TextureQuestion::Kind::kFind);
  EXPECT_EQ(color.questions[0].answer, std::vector<std::string>{"strands.png"});
  const TextureFolder textures(model.path);
  EXPECT_EQ(answer_to(color.questions[0], textures), color.questions[0].answer);

  Recipe recipe = default_recipe();
  recipe.base_color_texture.file = (folder.path() / "strands.png").string();
  EXPECT_TRUE(base_color_of(model, recipe).questions.empty()) << "the recipe leaves nothing to ask";
}

TEST(BaseColor, AnOpacityTextureOfItsOwnIsMissedOnce) {
  const ImageFolder folder;
  folder.write_flat("strands.png", kRed);
  importer::SourceModel model = model_beside(folder, "wig.obj");
  add_surface(model, "strands").base_texture.path = "strands.png";
  model.materials[0].opacity_texture.path = "strands_alpha.png";
  const SaidColor color = base_color_of(model);
  const auto count = std::ranges::count_if(color.warnings, [](const Diagnostic& warning) {
    return warning.message.find("opacity texture 'strands_alpha.png': no such file") != std::string::npos &&
           warning.message.find("\"textures\": {\"opacity\": ...}") != std::string::npos;
  });
  EXPECT_EQ(count, 1);
}

TEST(BaseColor, MapsThatAreNotDrawnAreTold) {
  const ImageFolder folder;
  folder.write_flat("strands.png", kRed);
  importer::SourceModel model = model_beside(folder, "wig.obj");
  add_surface(model, "strands").base_texture.path = "strands.png";
  model.materials[0].other_textures = {"occlusion map 'strands_ao.png'"};
  const SaidColor color = base_color_of(model);
  const auto told = [&](const char* what) { return std::ranges::count(color.left_out, what, &LeftOut::what); };
  EXPECT_EQ(told("material 'strands': occlusion map 'strands_ao.png'"), 1);
}

TEST(BaseColor, ATextureInVainIsAskedForAndEveryImageIsListed) {
  const ImageFolder folder;
  folder.write_flat("sofa.png");
  importer::SourceModel model = model_beside(folder, "wig.fbx");
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
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("'strands.png': no such file"), std::string::npos) << only_warning(color);
  EXPECT_NE(only_warning(color).find("a.png, b.png"), std::string::npos);
}

TEST(BaseColor, AnImageThatCannotBeReadIsAWarning) {
  const ImageFolder folder;
  folder.write("strands.png", std::vector<std::uint8_t>{'n', 'o'});
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("cannot read the image"), std::string::npos) << only_warning(color);
}

TEST(BaseColor, EmbeddedImagesAreDecoded) {
  for (const FileFormat format : {FileFormat::kPng, FileFormat::kJpeg}) {
    importer::SourceModel model;
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
  importer::SourceModel model;
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
    importer::SourceModel model = model_beside(folder, "long2.obj");
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
  importer::SourceModel model = model_beside(folder, "wig.obj");
  add_surface(model, "strands");
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_NE(only_warning(color).find("hair_red.png, tex/hair_blond.png"), std::string::npos) << only_warning(color);
  EXPECT_NE(only_warning(color).find(R"("textures": {"base_color": "hair_red.png"})"), std::string::npos);
}

TEST(BaseColor, OfSeveralImagesThatFitTheOneWithTheNameAsAWordIsTaken) {
  const ImageFolder folder;
  folder.write_flat("curly2_texture.png", kGreen);
  folder.write_flat("curly_texture.png", kRed);
  importer::SourceModel model = model_beside(folder, "curly.obj");
  add_surface(model, "strands");
  EXPECT_TRUE(has_color(base_color_of(model), kRed));
}

TEST(BaseColor, TheOnlyImageBesideASourceIsTakenWhateverItsNameUnlessItIsAnothersOrTells) {
  const ImageFolder folder;
  folder.write_flat("untitled.png", kRed);
  folder.write_flat("untitled_normal.png");
  importer::SourceModel model = model_beside(folder, "wig.obj");
  add_surface(model, "strands");
  const SaidColor color = base_color_of(model);
  EXPECT_TRUE(has_color(color, kRed));
  EXPECT_NE(only_warning(color).find("untitled.png is taken"), std::string::npos) << only_warning(color);
  importer::SourceMaterial face;
  face.base_texture.path = "untitled.png";
  model.materials.push_back(face);
  EXPECT_FALSE(base_color_of(model).image) << "a face's";
  model.materials.pop_back();
  folder.write_flat("second.png");
  EXPECT_FALSE(base_color_of(model).image) << "one of two";
}

TEST(BaseColor, TheNormalMapComesWithItWhereThereIsOneSurface) {
  const ImageFolder folder;
  folder.write_flat("hair.png", kRed);
  folder.write_flat("maps/hair_n.png", {128, 128, 255, 255});
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  importer::SourceMaterial& material = add_surface(model, "strands");
  material.base_texture.path = "hair.png";
  material.normal_texture.path = "C:\\maps\\hair_n.png";
  const SaidColor color = base_color_of(model);
  ASSERT_TRUE(color.normals);
  EXPECT_EQ(color.normals->channels, 2u);
  EXPECT_EQ(color.files.size(), 2u);
  model.materials[0].normal_texture.path = "lost.png";
  const SaidColor without = base_color_of(model);
  EXPECT_FALSE(without.normals);
  EXPECT_EQ(only_warning(without),
            "material 'strands': normal map 'lost.png': no such file beside the source; it is lit by its own form");
}

TEST(BaseColor, ARecipesNormalMapTakesTheSourcesPlace) {
  const ImageFolder folder;
  folder.write_flat("hair.png", kRed);
  folder.write_flat("hair_n.png", {204, 128, 230, 255});
  folder.write_flat("recipes/own_n.png", {128, 204, 230, 255});
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  importer::SourceMaterial& material = add_surface(model, "strands");
  material.base_texture.path = "hair.png";
  material.normal_texture.path = "hair_n.png";
  Recipe recipe = default_recipe();
  const CookSettings settings{.recipe_directory = folder.path() / "recipes"};
  const auto lean = [&](std::size_t channel) {
    HairMesh hair = whole_hair(model);
    Findings findings;
    const auto color = find_base_color(model, hair, recipe, settings, findings);
    return color && color->normals ? int(color->normals->texels[channel]) - 128 : 1000;
  };
  EXPECT_GT(lean(0), 60);
  recipe.normal_texture = "own_n.png";
  EXPECT_EQ(lean(0), 0);
  EXPECT_LT(lean(1), -60) << "green leads up where nothing shows the contrary";
  recipe.normal_green = NormalGreen::kDown;
  EXPECT_GT(lean(1), 60);
  recipe.normal_strength = 0.5;
  EXPECT_LT(lean(1), 50);
  recipe.normal_texture = "lost.png";
  HairMesh hair = whole_hair(model);
  Findings findings;
  const auto lost = find_base_color(model, hair, recipe, settings, findings);
  ASSERT_FALSE(lost);
  EXPECT_NE(lost.error().message.find("recipe key \"textures.normal\""), std::string::npos) << lost.error().message;
  recipe.normal_texture = "";
  recipe.normal_strength = 0;
  EXPECT_EQ(lean(0), 1000) << "none is used";
}

TEST(BaseColor, AMapThatNobodyWillSeeIsNotMissed) {
  const ImageFolder folder;
  folder.write_flat("hair.png", kRed);
  folder.write_flat("own_n.png", {128, 204, 230, 255});
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  importer::SourceMaterial& material = add_surface(model, "strands");
  material.base_texture.path = "hair.png";
  material.normal_texture.path = "lost.png";
  const auto warnings_with = [&](const Recipe& recipe) {
    HairMesh hair = whole_hair(model);
    Findings findings;
    EXPECT_TRUE(find_base_color(model, hair, recipe, {.recipe_directory = folder.path()}, findings));
    return findings.warnings.size();
  };
  Recipe recipe = default_recipe();
  EXPECT_EQ(warnings_with(recipe), 1u);
  recipe.normal_strength = 0;
  EXPECT_EQ(warnings_with(recipe), 0u);
  recipe.normal_strength = 1;
  recipe.normal_texture = "own_n.png";
  EXPECT_EQ(warnings_with(recipe), 0u);
}

TEST(BaseColor, WhatIsNoNormalMapIsNamedAndNotUsed) {
  const ImageFolder folder;
  folder.write_flat("hair.png", kRed);
  folder.write_flat("hair_n.png", kGreen);
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  importer::SourceMaterial& material = add_surface(model, "strands");
  material.name = "locks";
  material.base_texture.path = "hair.png";
  material.normal_texture.path = "hair_n.png";
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.normals);
  EXPECT_EQ(
      only_warning(color),
      "material 'locks': its normal map is not used: 100 % of its normals lead into the surface: it shows something "
      "else, or normals in the model's axes");
}

TEST(BaseColor, AGltfWithoutATextureMeansIt) {
  const ImageFolder folder;
  folder.write_flat("hair.png");
  importer::SourceModel model = model_beside(folder, "wig.glb");
  add_surface(model, "hair").base_color = {0.5f, 0.2f, 0.1f, 1};
  const SaidColor color = base_color_of(model);
  EXPECT_FALSE(color.image);
  EXPECT_TRUE(color.warnings.empty());
  EXPECT_EQ(color.factor, Eigen::Vector4f(0.5f, 0.2f, 0.1f, 1));
}

TEST(BaseColor, HairIsNotDyedWhereTheRecipeNamesItsColour) {
  const ImageFolder folder;
  importer::SourceModel model = model_beside(folder, "wig.obj");
  add_surface(model, "hair").base_color = {0.95f, 0.95f, 0.93f, 1};
  Recipe recipe = default_recipe();
  EXPECT_EQ(base_color_of(model, recipe).factor.head<3>(), Eigen::Vector3f(0.13f, 0.07f, 0.035f)) << "a middle brown";
  recipe.base_color = {0.9, 0.1, 0.1, 1};
  EXPECT_EQ(base_color_of(model, recipe).factor.head<3>(), Eigen::Vector3f(0.95f, 0.95f, 0.93f));
}

TEST(BaseColor, TheImageOfTheRecipeComesFirstAndMustBeThere) {
  const ImageFolder folder;
  folder.write_flat("strands.png", kRed);
  folder.write_flat("mine.png", kGreen);
  importer::SourceModel model = model_beside(folder, "wig.fbx");
  add_surface(model, "strands").base_texture.path = "strands.png";
  Recipe recipe = default_recipe();
  recipe.base_color_texture.file = (folder.path() / "mine.png").string();
  EXPECT_TRUE(has_color(base_color_of(model, recipe), kGreen));
  recipe.base_color_texture.file = "absent.png";
  HairMesh hair = whole_hair(model);
  const auto color = find_base_color(model, hair, recipe, {}, unheard());
  ASSERT_FALSE(color);
  EXPECT_NE(color.error().message.find("\"textures.base_color\""), std::string::npos);
}

}  // namespace coif::cook::base_color_test
