#include "cards/hair_source.h"

#include "cards/made_up_groom.h"
#include "cook/recipe/recipe.h"
#include "grow/round_bodies.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cards::strand_body_test {

using Eigen::Vector3f;
using importer::test::TemporaryFolder;

const Vector3f kHead(0, 1.6f, 0);

/// The head that strands_of_a_head() grow on, over a body on the floor.
importer::SourceModel body_with_head() {
  grow::test::MadeUpMesh mesh = grow::test::ellipsoid(kHead, Vector3f::Constant(0.1f));
  append(grow::test::ellipsoid({0, 1.1f, 0}, {0.2f, 0.35f, 0.12f}), mesh);
  return grow::test::model_of(std::move(mesh));
}

groom::Groom groom_in(float scale, bool z_up) {
  auto strands = test::strands_of_a_head(200);
  for (auto& strand : strands) {
    for (Vector3f& p : strand) {
      p += kHead;
      p = scale * (z_up ? Vector3f(p.x(), -p.z(), p.y()) : p);
    }
  }
  groom::Groom groom = test::groom_of(strands);
  groom.space.unit = importer::Statement::kUnsaid;
  groom.space.up = importer::Statement::kUnsaid;
  return groom;
}

float farthest_root(const groom::Groom& groom) {
  float farthest = 0;
  for (std::size_t i = 0; i < groom.strand_count(); ++i)
    farthest = std::max(farthest, std::abs((groom.strand(i)[0] - kHead).norm() - 0.1f));
  return farthest;
}

TEST(StrandBody, LeavesStrandsThatFit) {
  groom::Groom groom = groom_in(1, false);
  const groom::Groom before = groom;
  place_on_body(body_with_head(), groom);
  EXPECT_EQ(groom.points, before.points);
  EXPECT_TRUE(groom.warnings.empty());
}

TEST(StrandBody, FindsUnitAndAxisByTheRootsAndSaysSo) {
  for (const float scale : {100.0f, 1000.0f, 1.0f}) {
    for (const bool z_up : {false, true}) {
      if (scale == 1 && !z_up) continue;
      groom::Groom groom = groom_in(scale, z_up);
      place_on_body(body_with_head(), groom);
      EXPECT_LT(farthest_root(groom), 0.002f) << scale << z_up;
      ASSERT_EQ(groom.warnings.size(), 1u);
      EXPECT_NE(groom.warnings[0].message.find(
                    fmt::format("taken as of {:.4g} m per unit with {} up", 1 / scale, z_up ? 'Z' : 'Y')),
                std::string::npos)
          << groom.warnings[0].message;
      EXPECT_EQ(groom::find_groom_fault(groom), "");
    }
  }
}

TEST(StrandBody, KeepsWhatTheRecipeGivesAndSaysHowFarOffItIs) {
  groom::Groom groom = groom_in(100, false);
  groom.space.unit = groom.space.up = importer::Statement::kGiven;
  const groom::Groom before = groom;
  place_on_body(body_with_head(), groom);
  EXPECT_EQ(groom.points, before.points);
  ASSERT_EQ(groom.warnings.size(), 1u);
  EXPECT_TRUE(groom.warnings[0].message.starts_with("roots lie ")) << groom.warnings[0].message;
}

importer::SourceModel cards_alone() {
  importer::SourceModel cards =
      grow::test::model_of(grow::test::ellipsoid({0, 1.7f, 0}, {0.02f, 0.1f, 0.001f}), "hair");
  return cards;
}

TEST(StrandBody, CardsHangFromTheHeadThatIsNamed) {
  importer::SourceModel body = body_with_head();
  body.nodes.push_back({"Bip01 Head", 0, Eigen::Affine3d::Identity()});
  importer::SourceModel cards = cards_alone();
  add_body(body, cards);
  EXPECT_EQ(importer::find_model_fault(cards), "");
  ASSERT_EQ(cards.nodes.size(), 3u);
  EXPECT_EQ(cards.nodes[cards.meshes[0].node].name, "hair");
  EXPECT_EQ(cards.nodes[2].parent, 1u);
  EXPECT_EQ(cards.head_node, 1u);
  EXPECT_EQ(cards.meshes.back().name, "body");
}

TEST(StrandBody, AHeadWithoutABoneGetsOne) {
  importer::SourceModel cards = cards_alone();
  add_body(body_with_head(), cards);
  EXPECT_EQ(importer::find_model_fault(cards), "");
  ASSERT_NE(cards.head_node, importer::kNoIndex);
  const importer::SourceMesh& skin = cards.meshes.back();
  std::size_t on_head = 0;
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    const bool follows = skin.influences[skin.influence_begin[v]].node == cards.head_node;
    on_head += follows ? 1 : 0;
    if (follows) {
      EXPECT_LT((skin.positions[v] - kHead).norm(), 0.11f);
    }
  }
  EXPECT_GT(on_head, 600u);
  EXPECT_TRUE(cards.warnings.empty());
}

TEST(StrandBody, HairOfTheBodysOwnIsLeftOut) {
  importer::SourceModel body = body_with_head();
  importer::SourceMesh wig = body.meshes[0];
  wig.name = "Hair_01";
  body.meshes.push_back(wig);
  importer::SourceModel cards = cards_alone();
  add_body(body, cards);
  EXPECT_EQ(cards.meshes.size(), 2u);
  ASSERT_EQ(cards.warnings.size(), 1u);
  EXPECT_NE(cards.warnings[0].message.find("1 of its meshes are called hair"), std::string::npos)
      << cards.warnings[0].message;
}

std::string obj_text(bool with_mesh, const char* mesh_name, std::size_t strands = 60) {
  std::string text;
  int vertex = 0;
  if (with_mesh) {
    const grow::test::MadeUpMesh mesh = grow::test::ellipsoid(Vector3f::Zero(), Vector3f::Constant(0.1f));
    text += fmt::format("o {}\n", mesh_name);
    for (const Vector3f& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
      text += fmt::format("f {} {} {}\n", mesh.triangles[i] + 1, mesh.triangles[i + 1] + 1, mesh.triangles[i + 2] + 1);
    vertex = int(mesh.positions.size());
  }
  text += "o strands\n";
  for (const auto& strand : test::strands_of_a_head(strands)) {
    for (const Vector3f& p : strand) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    text += "l";
    for (std::size_t k = 0; k < strand.size(); ++k) text += fmt::format(" {}", ++vertex);
    text += "\n";
  }
  return text;
}

cook::Recipe small_cards() {
  cook::Recipe recipe = cook::default_recipe();
  recipe.cards_triangles = 60;
  recipe.cards_texels = 8192;
  return recipe;
}

TEST(HairSource, LinesBesideAMeshAreItsHair) {
  const TemporaryFolder folder;
  const auto model = read_hair_source(folder.write("both.obj", obj_text(true, "face")), small_cards(), {});
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->materials[model->meshes[0].material].name, "cards");
  EXPECT_EQ(model->meshes.back().name, "body");
  EXPECT_NE(model->head_node, importer::kNoIndex);
  const auto strips = read_hair_source(folder.write("strips.obj", obj_text(true, "hair")), small_cards(), {});
  ASSERT_TRUE(strips);
  EXPECT_EQ(strips->meshes.size(), 1u);
  const auto edges = read_hair_source(folder.write("edges.obj", obj_text(true, "face", 5)), small_cards(), {});
  ASSERT_TRUE(edges);
  EXPECT_EQ(edges->meshes.size(), 1u) << "a few edges that somebody left behind";
}

TEST(HairSource, ABodyOfItsOwnFileComesBesideTheRecipe) {
  const TemporaryFolder folder;
  folder.write("face.obj", obj_text(true, "face"));
  cook::Recipe recipe = small_cards();
  recipe.cards_body = "face.obj";
  const auto strands = folder.write("lines.obj", obj_text(false, ""));
  const auto model = read_hair_source(strands, recipe, {{}, folder.path(), 2});
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes.back().name, "body");
  recipe.cards_body = "absent.obj";
  const auto absent = read_hair_source(strands, recipe, {{}, folder.path(), 2});
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().kind, ToolError::Kind::kFileAccess);
  EXPECT_NE(absent.error().message.find("absent.obj: cannot open"), std::string::npos) << absent.error().message;
}

TEST(HairSource, ARecipeGrowsHairOnTheSamplesBust) {
  cook::Recipe recipe = small_cards();
  recipe.grow_strands = 300;
  const auto model = read_hair_source("made_up.recipe.json", recipe, {});
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(importer::find_model_fault(*model), "");
  EXPECT_EQ(model->materials[model->meshes[0].material].name, "cards");
  EXPECT_EQ(model->meshes.back().name, "body");
  EXPECT_NE(model->head_node, importer::kNoIndex);
}

TEST(HairSource, ItsValuesAreThoseThatChangeTheModel) {
  cook::Recipe recipe = cook::default_recipe();
  const std::string before = source_values(recipe);
  recipe.gravity_scale = 0.5;
  EXPECT_EQ(source_values(recipe), before);
  recipe.grow_seed = 7;
  EXPECT_NE(source_values(recipe), before);
}

}  // namespace coif::cards::strand_body_test
