#include "cook/select/select_hair.h"
#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/skeleton.h"
#include "cook/select/hair_evidence.h"

#include <gtest/gtest.h>
#include <cmath>

namespace coif::cook::select_hair_test {

Told<HairChoice> choice_of(const importer::SourceModel& model) {
  return told([&](Findings& findings) {
    auto choice = choose_hair(model, default_recipe(), findings);
    EXPECT_TRUE(choice) << (choice ? "" : choice.error().message);
    return choice ? *choice : HairChoice{};
  });
}

std::size_t taken(const Told<HairChoice>& choice, std::size_t mesh) {
  return std::size_t(std::ranges::count(choice.made.taken.at(mesh), true));
}

Told<tl::expected<HairMesh, ToolError>> selected(const importer::SourceModel& model,
                                                 const Recipe& recipe = default_recipe()) {
  return told([&](Findings& findings) { return select_hair(model, recipe, findings); });
}

/// The wig in one mesh with a face and a body below, nothing of which is called hair except bones.
importer::SourceModel merged_body() {
  importer::SourceModel model = make_wig();
  importer::SourceMesh& mesh = model.meshes[0];
  mesh.name = "Body";
  append_piece(mesh, make_cap(6, 4, 6.2f, 0.09f), 1);
  append_piece(mesh, make_strip({.root = {0, 1.4f, 0}, .along = {0, -1, 0}}), 0);
  return model;
}

TEST(ChooseHair, AMaterialCalledHairSaysSo) {
  importer::SourceModel model = merged_body();
  for (importer::SourceNode& node : model.nodes) node.name = node.name == "Head" ? "Head" : "bone";
  importer::SourceMesh strip = make_strip({});
  strip.name = "Object_7";
  strip.material = 0;
  model.materials.emplace_back();
  model.materials[0].name = "mat_Hair_01";
  model.meshes.push_back(strip);
  const auto choice = choice_of(model);
  EXPECT_EQ(taken(choice, 0), 0u);
  EXPECT_EQ(taken(choice, 1), 8u);
  ASSERT_EQ(choice.notes.size(), 1u);
  EXPECT_EQ(choice.notes[0], "hair: mesh 'Object_7' (8 triangles): its material is called 'mat_Hair_01'");
}

TEST(ChooseHair, ATextureCalledHairSaysSoButNotItsFolder) {
  importer::SourceModel model = merged_body();
  for (importer::SourceNode& node : model.nodes) node.name = node.name == "Head" ? "Head" : "bone";
  model.meshes.push_back(make_strip({}));
  model.meshes.push_back(make_strip({}));
  model.materials.resize(2);
  for (std::uint32_t m = 0; m < 2; ++m) {
    model.meshes[m + 1].name = "Object";
    model.meshes[m + 1].material = m;
  }
  model.materials[0].base_texture.path = "D:\\art\\tex\\hair_d.png";
  model.materials[1].base_texture.path = "D:\\art\\hair_and_body\\skin.png";
  const auto choice = choice_of(model);
  EXPECT_EQ(taken(choice, 1), 8u);
  EXPECT_EQ(taken(choice, 2), 0u);
}

TEST(ChooseHair, APartOfTheHairMeshWithAnotherMaterialIsAnAdornment) {
  importer::SourceModel model = make_wig();
  model.meshes.push_back(make_strip({}));  // also called hair, on the same node
  model.meshes[1].node = model.meshes[0].node;
  model.materials.resize(2);
  model.materials[0].name = "hair";
  model.materials[1].name = "metal";
  model.meshes[0].material = 0;
  model.meshes[1].material = 1;
  const auto choice = choice_of(model);
  EXPECT_EQ(taken(choice, 0), 10u);
  EXPECT_EQ(taken(choice, 1), 0u);
}

TEST(ChooseHair, MergedHairIsCutOutByBonesCalledHair) {
  const importer::SourceModel model = merged_body();
  const auto choice = choice_of(model);
  EXPECT_EQ(taken(choice, 0), 10u) << "neither the face nor the body";
  EXPECT_NE(choice.notes.at(0).find("pieces that hair bones move"), std::string::npos);
}

TEST(ChooseHair, ATouchOfAHairBoneDoesNotMakeAFaceHair) {
  importer::SourceModel model = merged_body();
  importer::SourceMesh& mesh = model.meshes[0];
  const std::size_t face_vertex = 13;  // the strip has twelve vertices
  mesh.influences.at(mesh.influence_begin.at(face_vertex)).node = 3;
  EXPECT_EQ(taken(choice_of(model), 0), 10u);
}

TEST(ChooseHair, SpringsBelowTheHeadAreHairBonesWhateverTheirNames) {
  importer::SourceModel model = merged_body();
  model.nodes[3].name = "J_Sec_01";
  model.nodes[4].name = "J_Sec_02";
  EXPECT_NE(taken(choice_of(model), 0), 10u) << "nothing says so yet";
  model.springs.push_back({"", {{.node = 3}, {.node = 4}}, importer::kNoIndex, {}});
  EXPECT_EQ(taken(choice_of(model), 0), 10u);
}

TEST(ChooseHair, TransparentPiecesOnTheHeadAreHairButNotLashes) {
  importer::SourceModel model = merged_body();
  for (importer::SourceNode& node : model.nodes) node.name = node.name == "Head" ? "Head" : "bone";
  const std::uint32_t lid = add_node(model, "REyeBlinkTop", 1, {0.03, 1.62, 0.09});
  importer::SourceMesh cards = make_strip({});
  cards.name = "opacity_mesh";
  cards.material = 0;
  cards.influence_begin = {0};
  for (std::size_t v = 0; v < cards.positions.size(); ++v) {
    cards.influences.push_back({1, 1.0f});
    cards.influence_begin.push_back(std::uint32_t(v + 1));
  }
  append_piece(cards, make_strip({.root = {0.03f, 1.62f, 0.1f}, .along = {0.02f, 0, 0}}), lid);
  append_piece(cards, make_strip({.root = {0, 0.3f, 0}, .along = {0, -0.2f, 0}}), 0);  // a skirt's lace
  model.meshes.push_back(cards);
  model.materials.emplace_back();
  model.materials[0].alpha_use = importer::AlphaUse::kBlend;
  const auto choice = choice_of(model);
  EXPECT_EQ(taken(choice, 0), 0u);
  EXPECT_EQ(taken(choice, 1), 8u);
}

TEST(ChooseHair, AFileOfNothingButAHairstyleIsAllHairWithoutAWarning) {
  importer::SourceModel model;
  model.path = "style.obj";
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  model.meshes.push_back(make_strip({}));
  model.meshes[0].name = "defaultobject";
  const auto choice = choice_of(model);
  EXPECT_EQ(taken(choice, 0), 8u);
  EXPECT_TRUE(choice.warnings.empty());
}

TEST(ChooseHair, ABodyOfWhichNothingIsHairIsTakenWholeWithAWarning) {
  importer::SourceModel model = merged_body();
  for (importer::SourceNode& node : model.nodes) node.name = node.name == "Head" ? "Head" : "bone";
  EXPECT_EQ(choice_of(model).warnings.size(), 1u);
}

TEST(Carriers, BonesOfTheFaceCarryNoChain) {
  importer::SourceModel model = merged_body();
  model.meshes[0].name = "hair";
  for (std::size_t n : {2u, 3u, 4u, 5u}) model.nodes[n].name = n < 4 ? "MJaw" : "MBottomLip";
  const HairMesh hair = whole_hair(model);
  const auto head = find_head_bone(model, hair, "");
  EXPECT_TRUE(build_skeleton(model, hair, *head, default_recipe(), unheard())->chains.empty());
}

/// The wig with a body: a second mesh that no hair bone moves.
importer::SourceModel wig_with_body() {
  importer::SourceModel model = make_wig();
  importer::SourceMesh body = make_strip({.root = {0, 1.4f, 0}, .along = {0, -1, 0}, .rows = 6});
  body.name = "body";
  body.node = 0;
  model.meshes.push_back(body);
  return model;
}

TEST(SelectHair, TakesWhatIsCalledHairAndSaysWhatItLeft) {
  const auto hair = selected(wig_with_body());
  ASSERT_TRUE(hair.made);
  EXPECT_EQ(hair.made->triangle_count(), 10u);
  ASSERT_EQ(hair.left_out.size(), 1u);
  EXPECT_EQ(hair.left_out[0].text(), "mesh 'body' (12 triangles): not hair");
}

TEST(SelectHair, TakesEverythingWhereNothingIsCalledHair) {
  importer::SourceModel model = wig_with_body();
  model.meshes[0].name = "thing";
  for (importer::SourceNode& node : model.nodes) node.name = "node";
  EXPECT_EQ(selected(model).made->triangle_count(), 22u);
}

TEST(SelectHair, CutsHairOutOfAMergedMeshByItsBones) {
  importer::SourceModel model = make_wig();
  append_piece(model.meshes[0], make_strip({.root = {1, 1, 1}}), 1);
  Recipe recipe = default_recipe();
  recipe.hair_bones = {"hair_*"};
  const auto hair = selected(model, recipe);
  ASSERT_TRUE(hair.made);
  EXPECT_EQ(hair.made->triangle_count(), 10u) << "the piece keeps its root, which follows the scalp";
  EXPECT_EQ(hair.left_out[0].text(), "mesh 'hair', 8 triangles: of pieces that are not hair");
}

TEST(SelectHair, APatternThatMatchesNothingNamesWhatThereIs) {
  Recipe recipe = default_recipe();
  recipe.hair_meshes = {"wig*"};
  const auto hair = selected(wig_with_body(), recipe);
  ASSERT_FALSE(hair.made);
  EXPECT_EQ(hair.made.error().message,
            "wig.glb: recipe key \"hair.meshes\": nothing is called 'wig*'; there are: body, hair");
  EXPECT_EQ(hair.made.error().kind, ToolError::Kind::kBadInput);
}

TEST(SelectHair, TrianglesWithoutAreaAreLeftOut) {
  importer::SourceModel model = make_wig();
  model.meshes[0].triangles.insert(model.meshes[0].triangles.end(), {0, 0, 1, 2, 2, 2});
  const auto hair = selected(model);
  EXPECT_EQ(hair.made->triangle_count(), 10u);
  EXPECT_EQ(hair.left_out[0].text(), "mesh 'hair', 2 triangles: without area");
}

TEST(SelectHair, AModelWithoutAreaSaysSo) {
  importer::SourceModel model = make_wig();
  for (Eigen::Vector3f& p : model.meshes[0].positions) p = {0, 1, 0};
  const auto hair = selected(model);
  ASSERT_FALSE(hair.made);
  EXPECT_EQ(hair.made.error().message,
            "wig.glb: all 10 triangles are without area; scale the model up or export it again");
}

TEST(SelectHair, MeshesWithAndWithoutTextureCoordinatesJoin) {
  importer::SourceModel model = make_wig();
  importer::SourceMesh bare = make_strip({.root = {0.2f, 1.6f, 0}});
  bare.uvs.clear();
  bare.node = 1;
  model.meshes.push_back(bare);
  const auto hair = selected(model);
  ASSERT_TRUE(hair.made);
  EXPECT_EQ(hair.made->triangle_count(), 18u);
  EXPECT_EQ(hair.made->uvs.size(), hair.made->positions.size());
}

TEST(ChooseHair, ABodyOfWhichNothingIsKnownToBeHairIsNeverTaken) {
  importer::SourceModel model = make_wig();
  for (importer::SourceNode& node : model.nodes) node.name = node.name == "Head" ? "Head" : "bone";
  model.nodes.back().name = "LeftFoot";
  for (importer::SourceInfluence& influence : model.meshes[0].influences)
    influence.node = std::uint32_t(model.nodes.size() - 1);
  model.meshes[0].name = "Body";
  model.materials.resize(1);
  model.materials[0].name = "Skin";
  model.meshes[0].material = 0;
  const auto hair = select_hair(model, default_recipe(), unheard());
  ASSERT_FALSE(hair);
  EXPECT_EQ(hair.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(hair.error().message.find("{\"hair\": {\"meshes\": [\"Body\"]}}; there are: mesh 'Body' (material 'Skin')"),
            std::string::npos)
      << hair.error().message;
}

/// A hemisphere of `radius` around (0, 1.6, 0), or all of the ball.
importer::SourceMesh shell(const std::string& name, float radius, bool whole) {
  importer::SourceMesh mesh;
  mesh.name = name;
  constexpr std::uint32_t kColumns = 24, kRows = 10;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    const float down = (whole ? 3.1f : 1.5f) * float(row) / kRows;
    for (std::uint32_t c = 0; c <= kColumns; ++c) {
      const float turn = 6.2832f * float(c) / kColumns;
      mesh.positions.emplace_back(radius * std::sin(down) * std::sin(turn), 1.6f + radius * std::cos(down),
                                  radius * std::sin(down) * std::cos(turn));
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t c = 0; c < kColumns; ++c) {
      const std::uint32_t v = row * (kColumns + 1) + c;
      mesh.triangles.insert(mesh.triangles.end(),
                            {v, v + kColumns + 1, v + 1, v + 1, v + kColumns + 1, v + kColumns + 2});
    }
  }
  return mesh;
}

TEST(ChooseHair, ACapUnderTheHairIsHairAndTheHeadIsNot) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  model.meshes = {shell("hair", 0.1f, false), shell("calotta", 0.095f, false), shell("face", 0.09f, true)};
  importer::SourceMesh eyes = shell("eyes", 0.02f, true);
  for (Eigen::Vector3f& p : eyes.positions) p += Eigen::Vector3f(0, 0.02f, 0.07f);
  model.meshes.push_back(eyes);
  Findings findings;
  const auto choice = choose_hair(model, default_recipe(), findings);
  ASSERT_TRUE(choice);
  EXPECT_FALSE(choice->taken[0].empty());
  EXPECT_FALSE(choice->taken[1].empty()) << "close under the hair";
  EXPECT_TRUE(choice->taken[2].empty()) << "the lower half is bare";
  EXPECT_TRUE(choice->taken[3].empty()) << "small";
  ASSERT_EQ(findings.notes.size(), 2u);
  EXPECT_NE(findings.notes[1].find("it lies under the hair, on the scalp"), std::string::npos) << findings.notes[1];
  model.meshes[1].name = "hair_net";
  EXPECT_TRUE(choose_hair(model, default_recipe(), unheard())->taken[1].empty()) << "what is worn is no cap";
}

TEST(ChooseHair, ACapIsWithinATenthOfTheHairsWidth) {
  for (const auto& [radius, is_cap] : {std::pair{0.09f, true}, {0.081f, true}, {0.0795f, false}, {0.07f, false}}) {
    importer::SourceModel model;
    add_node(model, "root", importer::kNoIndex, {0, 0, 0});
    model.meshes = {shell("hair", 0.1f, false), shell("calotta", radius, false)};
    const auto choice = choose_hair(model, default_recipe(), unheard());
    ASSERT_TRUE(choice);
    EXPECT_EQ(!choice->taken[1].empty(), is_cap) << radius;
  }
}

TEST(ChooseHair, HairWithoutDepthHasNoCap) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  model.meshes = {make_strip({.root = {0, 1.6f, 0}, .rows = 8}), make_strip({.root = {0, 1.6f, 0}, .rows = 4})};
  model.meshes[1].name = "calotta";
  const auto choice = choose_hair(model, default_recipe(), unheard());
  ASSERT_TRUE(choice);
  EXPECT_TRUE(choice->taken[1].empty());
}

TEST(GuessHeadNode, AMeshCalledHeadIsNoBoneUnlessTheSkeletonGoesOn) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  const std::uint32_t head = add_node(model, "head", 0, {0, 1.6, 0});
  model.meshes.push_back(make_strip({}));
  model.meshes[0].node = head;
  EXPECT_EQ(guess_head_node(model), importer::kNoIndex);
  add_node(model, "hair", head, {0, 1.7, 0});
  EXPECT_EQ(guess_head_node(model), head);
}

/// `copies` strips at one place, each of eight triangles.
importer::SourceModel strips_in_one_place(int copies) {
  importer::SourceModel model = make_wig();
  const importer::SourceMesh strip = model.meshes[0];
  for (int i = 1; i < copies; ++i) append_piece(model.meshes[0], strip, 1);
  return model;
}

TEST(SelectHair, AFileOfCopiesIsDamaged) {
  const auto twice = selected(strips_in_one_place(2));
  EXPECT_TRUE(twice.made) << (twice.made ? "" : twice.made.error().message);
  const auto damaged = selected(strips_in_one_place(100));
  ASSERT_FALSE(damaged.made);
  EXPECT_EQ(damaged.made.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(damaged.made.error().message.find("lie where others lie"), std::string::npos)
      << damaged.made.error().message;
  EXPECT_NE(damaged.made.error().message.find("export it again"), std::string::npos);
}

TEST(SelectHair, HairOfKilometresIsDamaged) {
  importer::SourceModel model = make_wig();
  const auto scaled_to = [&](float metres) {
    importer::SourceModel scaled = model;
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& at : scaled.meshes[0].positions) box.extend(at);
    for (Eigen::Vector3f& at : scaled.meshes[0].positions) at *= metres / box.sizes().norm();
    return selected(scaled);
  };
  EXPECT_TRUE(scaled_to(900).made) << "a unit may be wrong by a thousand";
  const auto damaged = scaled_to(2700);
  ASSERT_FALSE(damaged.made);
  EXPECT_EQ(damaged.made.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(damaged.made.error().message.find("the hair is 2.7 km from end to end"), std::string::npos)
      << damaged.made.error().message;
  EXPECT_NE(damaged.made.error().message.find("source.metres_per_unit"), std::string::npos);
}

}  // namespace coif::cook::select_hair_test
