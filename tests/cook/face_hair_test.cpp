#include "cook/recipe/recipe.h"
#include "cook/strands/choose_patches.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::face_hair_test {

using Eigen::Vector3d;
using Eigen::Vector3f;

FittedHead head_with(bool faces_backwards = false) {
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii = {0.075, 0.11, 0.095};
  head.faces_backwards = faces_backwards;
  return head;
}

/// A brow: `wide` by `high` metres, its middle at (x, y) of the face.
importer::SourceMesh brow(float x, float y, float wide = 0.05f, float high = 0.015f, float z = 0.09f) {
  return make_strip({.root = {x, y + high / 2, z}, .along = {0, -high, 0}, .across = {wide, 0, 0}, .rows = 1});
}

/// One mesh; each piece a patch.
HairStrips patches_of(const std::vector<importer::SourceMesh>& pieces) {
  importer::SourceMesh mesh;
  PatchSet patches;
  for (const importer::SourceMesh& piece : pieces) {
    append_piece(mesh, piece, 0);
    patches.patch_of.insert(patches.patch_of.end(), piece.triangles.size() / 3, patches.count++);
  }
  HairMesh hair = hair_from(mesh);
  hair.mesh_of_triangle.assign(hair.triangle_count(), 0);
  return strips_from(std::move(hair), std::move(patches));
}

importer::SourceModel model_called(const std::string& mesh, const std::string& material) {
  importer::SourceModel model;
  model.path = "person.glb";
  model.materials.resize(1);
  model.materials[0].name = material;
  model.meshes.resize(1);
  model.meshes[0].name = mesh;
  model.meshes[0].material = 0;
  return model;
}

std::vector<std::uint32_t> brows_among(const std::vector<importer::SourceMesh>& pieces,
                                       const FittedHead& head = head_with()) {
  return find_face_hair(model_called("hair", "strands"), patches_of(pieces), head).brows;
}

using Patches = std::vector<std::uint32_t>;
const importer::SourceMesh kFringe = make_strip({.root = {0, 1.72f, 0.03f}, .along = {0, -0.1f, 0.06f}});

TEST(FaceHair, APairBeforeTheEyesIsBrows) {
  EXPECT_EQ(brows_among({kFringe, brow(-0.035f, 1.63f), brow(0.035f, 1.63f)}), (Patches{1, 2}));
  EXPECT_EQ(brows_among({brow(0.035f, 1.63f, 0.05f, 0.015f, -0.09f), brow(-0.035f, 1.63f, 0.05f, 0.015f, -0.09f)},
                        head_with(true)),
            (Patches{0, 1}))
      << "a model that looks along -Z";
}

TEST(FaceHair, WhatLiesOtherwiseIsNone) {
  EXPECT_EQ(brows_among({brow(-0.035f, 1.63f), kFringe}), Patches{}) << "one alone";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.63f), brow(0.035f, 1.66f)}), Patches{}) << "not at one height";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.63f), brow(0.035f, 1.63f, 0.03f)}), Patches{}) << "not of one size";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.63f, 0.02f, 0.09f), brow(0.035f, 1.63f, 0.02f, 0.09f)}), Patches{}) << "locks";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.71f), brow(0.035f, 1.71f)}), Patches{}) << "on the top";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.55f), brow(0.035f, 1.55f)}), Patches{}) << "at the mouth";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.63f, 0.05f, 0.015f, -0.09f), brow(0.035f, 1.63f, 0.05f, 0.015f, -0.09f)}),
            Patches{})
      << "behind";
  EXPECT_EQ(brows_among({brow(-0.035f, 1.63f, 0.05f, 0.015f, 0.16f), brow(0.035f, 1.63f, 0.05f, 0.015f, 0.16f)}),
            Patches{})
      << "far before the face";
}

TEST(FaceHair, NamesTell) {
  const HairStrips hair = patches_of({kFringe});
  EXPECT_EQ(find_face_hair(model_called("Eyebrows_L", "hair"), hair, head_with()).brows, Patches{0});
  EXPECT_EQ(find_face_hair(model_called("head", "lashes"), hair, head_with()).brows, Patches{0});
  EXPECT_EQ(find_face_hair(model_called("Moustache01", "hair"), hair, head_with()).beard, Patches{0});
  EXPECT_EQ(find_face_hair(model_called("hair", "mat_beard"), hair, head_with()).beard, Patches{0});
}

TEST(FaceHair, StaysOrGoesAsTheRecipeSays) {
  const std::vector<importer::SourceMesh> pieces{kFringe, brow(-0.035f, 1.63f), brow(0.035f, 1.63f)};
  const importer::SourceModel model = model_called("hair", "strands");
  Recipe recipe = default_recipe();
  HairStrips hair = patches_of(pieces);
  Findings findings;
  ASSERT_TRUE(choose_face_hair(model, recipe, head_with(), hair, findings));
  EXPECT_EQ(hair.patches.count, 3u);
  ASSERT_EQ(findings.notes.size(), 1u);
  EXPECT_EQ(findings.notes[0], "brows: patches 1 and 2; \"hair.brows\": false in the recipe leaves them out");
  recipe.hair_brows = false;
  ASSERT_TRUE(choose_face_hair(model, recipe, head_with(), hair, findings));
  EXPECT_EQ(hair.patches.count, 1u);
  EXPECT_EQ(hair.mesh.triangle_count(), kFringe.triangles.size() / 3);
  ASSERT_EQ(findings.left_out.size(), 1u);
  EXPECT_EQ(findings.left_out[0].what, "brows: patches 1 and 2");
  hair = patches_of({brow(-0.035f, 1.63f), brow(0.035f, 1.63f)});
  const auto nothing = choose_face_hair(model, recipe, head_with(), hair, findings);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(nothing.error().message.find("person.glb: all of the hair is brows"), std::string::npos);
}

}  // namespace coif::cook::face_hair_test
