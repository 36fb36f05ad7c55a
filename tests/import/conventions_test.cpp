// Units, axes, winding, UVs, skinning: every convention on a model small enough to know the answer.

#include "import/import.h"
#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace coif::importer::conventions_test {

using Eigen::Vector2f;
using Eigen::Vector3f;
using test::fbx_int;
using test::import_or_fail;
using test::measure;
using test::small_dae;
using test::small_fbx;
using test::SmallGltf;
using test::TemporaryFolder;
using test::with_unit;
using test::with_up_axis;

std::string fbx_axes(int right, int right_sign, int up, int up_sign, int front, int front_sign) {
  return fbx_int("CoordAxis", right) + fbx_int("CoordAxisSign", right_sign) + fbx_int("UpAxis", up) +
         fbx_int("UpAxisSign", up_sign) + fbx_int("FrontAxis", front) + fbx_int("FrontAxisSign", front_sign);
}

std::string fbx_unit(const std::string& centimetres) {
  return "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," + centimetres + "\n";
}

class Conventions : public testing::Test {
 protected:
  /// Where the vertex is imported that the file places at (0, 2, 3).
  Vector3f tip_of_fbx(const std::string& settings, const ImportSettings& import_settings = {}) {
    return import_or_fail(folder_.write("m.fbx", small_fbx(settings)), import_settings).meshes[0].positions[2];
  }
  Vector3f tip_of_dae(const std::string& unit, const std::string& up, const ImportSettings& settings = {}) {
    return import_or_fail(folder_.write("m.dae", small_dae(unit, up)), settings).meshes[0].positions[2];
  }
  TemporaryFolder folder_;
};

TEST_F(Conventions, FbxUnitIsCentimetresTimesItsFactor) {
  EXPECT_TRUE(tip_of_fbx(fbx_unit("1")).isApprox(Vector3f(0, 0.02f, 0.03f)));
  EXPECT_TRUE(tip_of_fbx(fbx_unit("100")).isApprox(Vector3f(0, 2, 3)));
  EXPECT_TRUE(tip_of_fbx(fbx_unit("2.54")).isApprox(Vector3f(0, 0.0508f, 0.0762f)));
  EXPECT_TRUE(tip_of_fbx("").isApprox(Vector3f(0, 0.02f, 0.03f)));
}

TEST_F(Conventions, FbxUnitThatIsNoLengthIsReported) {
  const SourceModel model = import_or_fail(folder_.write("m.fbx", small_fbx(fbx_unit("-1"))));
  EXPECT_TRUE(model.meshes[0].positions[2].isApprox(Vector3f(0, 0.02f, 0.03f)));
  ASSERT_FALSE(model.warnings.empty());
  EXPECT_NE(model.warnings[0].message.find("UnitScaleFactor"), std::string::npos);
}

TEST_F(Conventions, FbxAxesBecomeYUpFacingZ) {
  const std::string metres = fbx_unit("100");
  EXPECT_TRUE(tip_of_fbx(metres + fbx_axes(0, 1, 1, 1, 2, 1)).isApprox(Vector3f(0, 2, 3)));
  EXPECT_TRUE(tip_of_fbx(metres + fbx_axes(0, 1, 2, 1, 1, -1)).isApprox(Vector3f(0, 3, -2)));  // 3ds Max, Blender
  EXPECT_TRUE(tip_of_fbx(metres + fbx_axes(0, -1, 1, -1, 2, 1)).isApprox(Vector3f(0, -2, 3)));
}

TEST_F(Conventions, SettingsOverrideUnitAndAxisOfTheFile) {
  const std::string z_up_metres = fbx_unit("100") + fbx_axes(0, 1, 2, 1, 1, -1);
  EXPECT_TRUE(tip_of_fbx(z_up_metres, with_unit(0.5)).isApprox(Vector3f(0, 1.5f, -1)));
  EXPECT_TRUE(tip_of_fbx(z_up_metres, with_up_axis(UpAxis::kY)).isApprox(Vector3f(0, 2, 3)));
  EXPECT_TRUE(tip_of_dae("0.01", "Z_UP", with_unit(0.5)).isApprox(Vector3f(0, 1.5f, -1)));
  EXPECT_TRUE(tip_of_dae("1", "Z_UP", with_up_axis(UpAxis::kY)).isApprox(Vector3f(0, 2, 3)));
  EXPECT_TRUE(tip_of_dae("1", "Y_UP", with_up_axis(UpAxis::kZ)).isApprox(Vector3f(0, 3, -2)));
}

TEST_F(Conventions, ColladaUnitAndAxisAreAppliedOnce) {
  EXPECT_TRUE(tip_of_dae("1", "Y_UP").isApprox(Vector3f(0, 2, 3)));
  EXPECT_TRUE(tip_of_dae("0.01", "Y_UP").isApprox(Vector3f(0, 0.02f, 0.03f)));
  EXPECT_TRUE(tip_of_dae("1", "Z_UP").isApprox(Vector3f(0, 3, -2)));
  EXPECT_TRUE(tip_of_dae("1", "X_UP").isApprox(Vector3f(-2, 0, 3)));
}

TEST_F(Conventions, SettingsTurnEveryAxisUp) {
  const auto path = SmallGltf().write(folder_, "m.gltf");
  EXPECT_TRUE(import_or_fail(path, with_up_axis(UpAxis::kX)).meshes[0].positions[1].isApprox(Vector3f(0, 1, 0)));
  EXPECT_TRUE(import_or_fail(path, with_up_axis(UpAxis::kY)).meshes[0].positions[2].isApprox(Vector3f(0, 1, 0)));
  EXPECT_TRUE(import_or_fail(path, with_up_axis(UpAxis::kZ)).meshes[0].normals[0].isApprox(Vector3f(0, 1, 0)));
}

/// A wig 0.2 m deep and half a metre long, in units of `per_metre` to the metre.
std::string obj_wig(double per_metre) {
  std::string text;
  for (const auto& [x, y, z] : {std::tuple{-0.1, 1.2, -0.1}, {0.1, 1.7, -0.1}, {0.0, 1.7, 0.1}}) {
    text += "v " + std::to_string(x * per_metre) + " " + std::to_string(y * per_metre) + " " +
            std::to_string(z * per_metre) + "\n";
  }
  return text + "f 1 2 3\n";
}

TEST_F(Conventions, ObjIsTakenInMetresAndSaysNothingOfItsUnit) {
  for (const double per_metre : {1.0, 100.0}) {
    const SourceModel model = import_or_fail(folder_.write("a.obj", obj_wig(per_metre)));
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_NEAR(model.meshes.at(0).positions.at(0).y() / per_metre, 1.2, 1e-5);
    EXPECT_EQ(model.space.unit, Statement::kUnsaid);
    EXPECT_EQ(model.space.up, Statement::kUnsaid);
  }
}

TEST_F(Conventions, ADeclaredUnitIsTheCallers) {
  const SourceModel model = import_or_fail(folder_.write("a.obj", obj_wig(10)), with_unit(2.0));
  EXPECT_NEAR(model.meshes.at(0).positions.at(0).y(), 24.0f, 1e-4);
  EXPECT_EQ(model.space.unit, Statement::kGiven);
  EXPECT_EQ(model.space.metres_per_unit, 2);
  EXPECT_EQ(model.space.up, Statement::kUnsaid);
}

TEST_F(Conventions, WhatAFileSaysOfItsSpaceIsKept) {
  const auto fbx = [&](const std::string& settings) {
    return import_or_fail(folder_.write("m.fbx", small_fbx(settings))).space;
  };
  EXPECT_EQ(fbx(fbx_unit("1")).unit, Statement::kUsual);
  EXPECT_EQ(fbx(fbx_unit("1")).metres_per_unit, 0.01);
  EXPECT_EQ(fbx(fbx_unit("2.54")).unit, Statement::kDeclared);
  EXPECT_EQ(fbx(fbx_unit("2.54") + fbx_axes(0, 1, 2, 1, 1, -1)).up_axis, 'z');
  const auto dae = [&](const char* unit, const char* up) {
    return import_or_fail(folder_.write("m.dae", small_dae(unit, up))).space;
  };
  EXPECT_EQ(dae("1", "Y_UP").unit, Statement::kUsual);
  EXPECT_EQ(dae("0.01", "Z_UP").unit, Statement::kDeclared);
  EXPECT_NEAR(dae("0.01", "Z_UP").metres_per_unit, 0.01, 1e-9);
  EXPECT_EQ(dae("0.01", "Z_UP").up_axis, 'z');
  const SourceSpace gltf = import_or_fail(SmallGltf().write(folder_, "m.gltf")).space;
  EXPECT_EQ(gltf.unit, Statement::kDeclared);
  EXPECT_EQ(gltf.metres_per_unit, 1);
  EXPECT_EQ(gltf.up_axis, 'y');
}

TEST_F(Conventions, VGrowsDownwardsFromEveryFormat) {
  const SourceModel gltf = import_or_fail(SmallGltf().write(folder_, "m.gltf"));
  EXPECT_TRUE(gltf.meshes[0].uvs[2].isApprox(Vector2f(0, 0.25f)));  // glTF's V grows downwards: unchanged
  const SourceModel obj =
      import_or_fail(folder_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvt 1 1\nvt 0 0.75\nf 1/1 2/2 3/3\n"));
  EXPECT_TRUE(obj.meshes[0].uvs[2].isApprox(Vector2f(0, 0.25f)));  // OBJ's V grows upwards: turned
}

TEST_F(Conventions, MirroredNodeKeepsTheSurfaceRightSideOut) {
  SmallGltf file;
  file.nodes = R"([{"name": "strip", "mesh": 0, "scale": [-2, 1, 1]}])";
  const SourceMesh mesh = import_or_fail(file.write(folder_, "m.gltf")).meshes.at(0);
  ASSERT_EQ(mesh.triangles.size(), 3u);
  const auto corner = [&](std::size_t k) { return mesh.positions[mesh.triangles[k]]; };
  const Vector3f wound = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  EXPECT_TRUE(mesh.normals[0].isApprox(Vector3f(0, 0, 1)));
  EXPECT_GT(wound.dot(mesh.normals[0]), 0.0f);
  EXPECT_FLOAT_EQ(wound.norm(), 2.0f);
}

TEST_F(Conventions, NormalsStayPerpendicularUnderUnevenScale) {
  SmallGltf file;
  const float s = 0.70710678f;
  file.positions = {0, 0, 0, 1, -1, 0, 0, 0, 1};
  file.normals = {s, s, 0, s, s, 0, s, s, 0};
  file.nodes = R"([{"name": "strip", "mesh": 0, "scale": [1, 3, 1]}])";
  const SourceMesh mesh = import_or_fail(file.write(folder_, "m.gltf")).meshes.at(0);
  EXPECT_NEAR(mesh.normals[0].dot(mesh.positions[1] - mesh.positions[0]), 0.0f, 1e-6f);
}

TEST_F(Conventions, InstancesAreCopiedToTheirPlaces) {
  SmallGltf file;
  file.nodes = R"([{"name": "left", "mesh": 0}, {"name": "right", "mesh": 0, "translation": [5, 0, 0]}])";
  file.roots = "[0, 1]";
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"));
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "left");
  EXPECT_EQ(model.nodes[model.meshes[1].node].name, "right");
  EXPECT_FLOAT_EQ(model.meshes[1].positions[0].x() - model.meshes[0].positions[0].x(), 5.0f);
}

TEST_F(Conventions, SkinnedVerticesFollowTheirJointsWithWeightsOfSumOne) {
  SmallGltf file;
  file.nodes = R"([{"name": "strip", "mesh": 0, "skin": 0}, {"name": "a", "translation": [1, 0, 0]},
                   {"name": "b", "translation": [0, 4, 0]}])";
  file.roots = "[0, 1, 2]";
  file.skin_joints = "[1, 2]";
  file.joints = {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
  file.weights = {1, 0, 0, 0, 1, 0, 0, 0, 3, 1, 0, 0};  // the last one is not normalised
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"));
  const SourceMesh& mesh = model.meshes.at(0);
  EXPECT_TRUE(mesh.positions[0].isApprox(Vector3f(1, 0, 0)));
  EXPECT_TRUE(mesh.positions[1].isApprox(Vector3f(1, 4, 0)));
  EXPECT_TRUE(mesh.positions[2].isApprox(Vector3f(0.75f, 2, 0)));
  ASSERT_EQ(mesh.influence_begin.size(), 4u);
  const SourceInfluence heaviest = mesh.influences[mesh.influence_begin[2]];
  EXPECT_EQ(model.nodes[heaviest.node].name, "a");
  EXPECT_FLOAT_EQ(heaviest.weight, 0.75f);
}

TEST_F(Conventions, NodesComeParentsFirstInModelSpace) {
  SmallGltf file;
  file.nodes = R"([{"name": "tip", "mesh": 0, "translation": [0, 1, 0]},
                   {"name": "root", "children": [0], "translation": [0, 2, 0]}])";
  file.roots = "[1]";
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"), with_unit(0.5));
  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_EQ(model.nodes[0].name, "root");
  EXPECT_EQ(model.nodes[1].parent, 0u);
  EXPECT_NEAR(model.nodes[1].model_from_node.translation().y(), 1.5, 1e-6);
}

TEST_F(Conventions, MaterialsCarryColourTextureAndSides) {
  SmallGltf file;
  file.material = R"({"name": "hair", "doubleSided": true, "pbrMetallicRoughness":
      {"baseColorFactor": [0.5, 0.25, 0.125, 0.75], "baseColorTexture": {"index": 0}}})";
  file.images = R"("textures": [{"source": 0}], "images": [{"uri": "bob.png"}],)";
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"));
  const SourceMaterial& material = model.materials.at(model.meshes.at(0).material);
  EXPECT_EQ(material.name, "hair");
  EXPECT_TRUE(material.double_sided);
  EXPECT_TRUE(material.base_color.isApprox(Eigen::Vector4f(0.5f, 0.25f, 0.125f, 0.75f)));
  EXPECT_EQ(material.base_texture.path, "bob.png");
  EXPECT_EQ(material.base_texture.image, kNoIndex);
  EXPECT_FLOAT_EQ(material.roughness, 1) << "glTF's default";
}

TEST_F(Conventions, RoughnessComesFromGltfWithinItsRange) {
  const auto roughness_of = [&](const std::string& factor) {
    SmallGltf file;
    file.material = R"({"name": "skin", "pbrMetallicRoughness": {"roughnessFactor": )" + factor + "}}";
    return import_or_fail(file.write(folder_, "m.gltf")).materials.at(0).roughness;
  };
  EXPECT_FLOAT_EQ(roughness_of("0.25"), 0.25f);
  EXPECT_FLOAT_EQ(roughness_of("-3"), 0);
  EXPECT_FLOAT_EQ(roughness_of("7"), 1);
}

TEST_F(Conventions, AlphaModeAndCutoffComeFromTheFile) {
  const auto material_of = [&](const std::string& members) {
    SmallGltf file;
    file.material = R"({"name": "hair")" + members + "}";
    return import_or_fail(file.write(folder_, "m.gltf")).materials.at(0);
  };
  EXPECT_EQ(material_of(R"(, "alphaMode": "OPAQUE")").alpha_use, AlphaUse::kOpaque);
  EXPECT_EQ(material_of(R"(, "alphaMode": "BLEND")").alpha_use, AlphaUse::kBlend);
  EXPECT_EQ(material_of("").alpha_use, AlphaUse::kOpaque) << "glTF's default";
  EXPECT_EQ(material_of(R"(, "alphaMode": "SHINY")").alpha_use, AlphaUse::kUnknown);
  const SourceMaterial mask = material_of(R"(, "alphaMode": "MASK", "alphaCutoff": 0.25)");
  EXPECT_EQ(mask.alpha_use, AlphaUse::kMask);
  EXPECT_FLOAT_EQ(mask.alpha_cutoff, 0.25f);
  EXPECT_FLOAT_EQ(material_of(R"(, "alphaMode": "MASK")").alpha_cutoff, 0.5f);
  EXPECT_FLOAT_EQ(material_of(R"(, "alphaMode": "MASK", "alphaCutoff": 7)").alpha_cutoff, 1.0f);
}

TEST_F(Conventions, AlphaOfOtherFormatsIsKnownByItsTextureOnly) {
  folder_.write("m.mtl", "newmtl plain\nKd 1 1 1\nd 1\nnewmtl card\nKd 1 1 1\nmap_d hair.png\n");
  const SourceModel model = import_or_fail(
      folder_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl plain\nf 1 2 3\nusemtl card\nf 1 3 2\n"));
  ASSERT_EQ(model.meshes.size(), 2u);
  for (const SourceMesh& mesh : model.meshes) {
    const SourceMaterial& material = model.materials.at(mesh.material);
    EXPECT_EQ(material.alpha_use, material.name == "card" ? AlphaUse::kBlend : AlphaUse::kUnknown) << material.name;
  }
}

TEST_F(Conventions, AnOpacityTextureIsNamedUnlessItIsTheBaseTexture) {
  folder_.write("m.mtl",
                "newmtl own\nmap_Kd hair.png\nmap_d alpha.png\nnewmtl same\nmap_Kd hair.png\nmap_d hair.png\n");
  const SourceModel model = import_or_fail(
      folder_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl own\nf 1 2 3\nusemtl same\nf 1 3 2\n"));
  for (const SourceMesh& mesh : model.meshes) {
    const SourceMaterial& material = model.materials.at(mesh.material);
    EXPECT_EQ(material.opacity_texture.path, material.name == "own" ? "alpha.png" : "");
  }
}

TEST_F(Conventions, MapsOfWhatIsComputedAreNamed) {
  folder_.write("m.mtl", "newmtl own\nmap_Kd hair.png\nmap_Ks shine.png\nmap_Ka hair.png\nmap_Ke glow.png\n");
  const SourceModel model =
      import_or_fail(folder_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl own\nf 1 2 3\n"));
  EXPECT_EQ(model.materials.at(model.meshes.at(0).material).other_textures,
            (std::vector<std::string>{"specular map 'shine.png'", "emission map 'glow.png'"}))
      << "and not what is the base colour's own";
}

TEST_F(Conventions, NormalAndBumpMapsAreKnownByTheirNames) {
  folder_.write(
      "m.mtl",
      "newmtl bumped\nmap_Kd hair.png\nmap_Bump bump.png\nnewmtl mapped\nnorm normals.png\nnewmtl flat\nKd 1 1 1\n");
  const SourceModel model = import_or_fail(folder_.write("m.obj",
                                                         "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl bumped\nf 1 "
                                                         "2 3\nusemtl mapped\nf 1 3 2\nusemtl flat\nf 2 3 1\n"));
  for (const SourceMesh& mesh : model.meshes) {
    const SourceMaterial& material = model.materials.at(mesh.material);
    EXPECT_EQ(material.normal_texture.path, material.name == "bumped"   ? "bump.png"
                                            : material.name == "mapped" ? "normals.png"
                                                                        : "");
  }
}

constexpr const char* kCardOfMaterials = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl card\nf 1 3 2\n";

TEST_F(Conventions, MaterialsThatAreNotThereAreMissed) {
  const SourceModel lost = import_or_fail(folder_.write("m.obj", kCardOfMaterials));
  const auto says = [](const SourceModel& model, const char* what) {
    return std::ranges::any_of(model.warnings,
                               [&](const Diagnostic& w) { return w.message.find(what) != w.message.npos; });
  };
  EXPECT_TRUE(says(lost, "'m.mtl' is named for the materials and was not read")) << "by the name that the model has";
  EXPECT_TRUE(says(lost, "no such file beside the model"));
  folder_.write("m.mtl", "newmtl card\nKd 1 0 0\n");
  EXPECT_FALSE(says(import_or_fail(folder_.path() / "m.obj"), "named for the materials"));
  const SourceModel none = import_or_fail(folder_.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_FALSE(says(none, "named for the materials")) << "it names none";
}

TEST_F(Conventions, EveryMaterialLibraryThatIsNotReadIsNamed) {
  folder_.write("m.mtl", "newmtl card\nKd 1 0 0\n");
  const SourceModel model =
      import_or_fail(folder_.write("m.obj", std::string("mtllib a.mtl\nmtllib m.mtl\nmtllib b.mtl\n") +
                                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl card\nf 1 3 2\n"));
  const auto count = [&](const char* what) {
    return std::ranges::count_if(model.warnings,
                                 [&](const Diagnostic& w) { return w.message.find(what) != w.message.npos; });
  };
  EXPECT_EQ(count("'a.mtl' is named for the materials and was not read: there is no such file"), 1);
  EXPECT_EQ(count("'b.mtl' is named"), 1);
  EXPECT_EQ(count("'m.mtl' is named"), 0);
}

TEST_F(Conventions, MaterialsInADeclaredRootAreReadThere) {
  // As git-annex and Nix have it: each file in a folder of its own, somewhere else.
  const TemporaryFolder store;
  std::filesystem::create_directory(store.path() / "a1");
  const auto kept = store.write("a1/key.mtl", "newmtl card\nKd 1 0 0\n");
  std::filesystem::create_symlink(kept, folder_.path() / "m.mtl");
  const auto path = folder_.write("m.obj", kCardOfMaterials);
  ImportSettings settings;
  const auto has_card = [](const SourceModel& model) {
    return std::ranges::any_of(model.materials, [](const SourceMaterial& m) { return m.base_color.y() == 0; });  // red
  };
  const auto warns_of_link = [](const SourceModel& model) {
    return std::ranges::any_of(model.warnings,
                               [](const Diagnostic& w) { return w.message.find("--root allows") != w.message.npos; });
  };
  // Without a fence (Linux before 5.13) the link is followed.
  const SourceModel without = import_or_fail(path, settings);
  EXPECT_NE(has_card(without), warns_of_link(without));
  settings.roots = {store.path()};
  const SourceModel with = import_or_fail(path, settings);
  EXPECT_TRUE(has_card(with));
  EXPECT_FALSE(warns_of_link(with));
  EXPECT_EQ(with.roots, settings.roots);
  // A path that leads there by itself, too.
  const std::string up = kept.lexically_relative(folder_.path()).string();
  EXPECT_TRUE(has_card(import_or_fail(
      folder_.write("up.obj", "mtllib " + up + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl card\nf 1 3 2\n"), settings)));
}

TEST_F(Conventions, MaterialsBesideALinkedModelAreReadWhereTheyLie) {
  folder_.write("m.mtl", "newmtl card\nKd 1 0 0\n");
  const auto real = folder_.write("m.obj", kCardOfMaterials);
  const auto sandbox = folder_.path() / "sandbox";
  std::filesystem::create_directory(sandbox);
  std::filesystem::create_symlink(real, sandbox / "m.obj");
  std::filesystem::create_symlink(folder_.path() / "m.mtl", sandbox / "m.mtl");
  const SourceModel model = import_or_fail(sandbox / "m.obj");
  ASSERT_FALSE(model.materials.empty());
  EXPECT_TRUE(std::ranges::any_of(model.materials, [](const SourceMaterial& m) { return m.name == "card"; }));
  EXPECT_TRUE(std::ranges::none_of(model.warnings,
                                   [](const Diagnostic& w) { return w.message.find("materials") != w.message.npos; }));
}

TEST_F(Conventions, ImporterIsNamedWithItsVersion) {
  const SourceModel model = import_or_fail(SmallGltf().write(folder_, "m.gltf"));
  EXPECT_EQ(model.importer.rfind("assimp ", 0), 0u);
  EXPECT_GE(model.importer_version[0], 5);
}

}  // namespace coif::importer::conventions_test
