// What a glTF's scene, materials and extensions say of its meshes.

#include "base/encodings.h"
#include "import/gltf_builder.h"
#include "import/imported_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

namespace coif::importer::gltf_scene_test {

using nlohmann::json;
using test::GltfBuilder;
using test::import_or_fail;
using test::kStripPositions;
using test::kStripUvs;
using test::Storage;
using test::TemporaryFolder;

bool tells(const Diagnostics& warnings, const std::string& text) {
  return std::ranges::any_of(
      warnings, [&](const Diagnostic& warning) { return warning.message.find(text) != std::string::npos; });
}

class GltfScene : public testing::Test {
 protected:
  SourceModel model_of(const GltfBuilder& file) { return import_or_fail(file.write(folder_)); }
  TemporaryFolder folder_;
};

TEST_F(GltfScene, ATextureTransformMovesTheUvs) {
  GltfBuilder file;
  file.textured({{"index", 0},
                 {"extensions",
                  {{"KHR_texture_transform",
                    {{"offset", {0.25, 0.5}}, {"scale", {0.5, 0.25}}, {"rotation", std::numbers::pi / 2}}}}}});
  file.document["extensionsUsed"] = file.document["extensionsRequired"] = {"KHR_texture_transform"};
  const SourceModel model = model_of(file);
  for (std::size_t v = 0; v < 4; ++v) {
    // A quarter turn against the clock in an image whose V grows downwards takes (u, v) to (v, -u).
    const Eigen::Vector2f meant(0.25f + 0.25f * kStripUvs[2 * v + 1], 0.5f - 0.5f * kStripUvs[2 * v]);
    EXPECT_LT((model.meshes[0].uvs[v] - meant).norm(), 1e-6f) << v;
  }
}

TEST_F(GltfScene, ATextureTransformMovesQuantizedUvsOfACompressedView) {
  GltfBuilder file;
  file.attribute("TEXCOORD_0", kStripUvs, "VEC2", {.component = 5123, .normalized = true, .meshopt = true});
  file.textured(
      {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.25, 0.5}}, {"scale", {16, 0.5}}}}}}});
  file.document["extensionsUsed"] = file.document["extensionsRequired"] = {
      "KHR_texture_transform", "KHR_mesh_quantization", "EXT_meshopt_compression"};
  const SourceModel model = model_of(file);
  for (std::size_t v = 0; v < 4; ++v) {
    const Eigen::Vector2f meant(0.25f + 16 * kStripUvs[2 * v], 0.5f + 0.5f * kStripUvs[2 * v + 1]);
    EXPECT_LT((model.meshes[0].uvs[v] - meant).norm(), 1e-6f) << v;
  }
  EXPECT_TRUE(model.warnings.empty()) << test::warnings_of(model);
}

TEST_F(GltfScene, WhereTheNodeOfAQuantizedMeshStandsSaysNothing) {
  const auto node_of = [&](const Storage& storage, bool is_skinned) {
    GltfBuilder file;
    if (is_skinned) file.document["nodes"][0]["skin"] = 0;
    file.attribute("POSITION", kStripPositions, "VEC3", storage);
    const SourceModel model = model_of(file);
    return model.nodes.at(model.meshes.at(0).node);
  };
  EXPECT_FALSE(node_of({}, false).undoes_quantization);
  EXPECT_TRUE(node_of({.component = 5122}, false).undoes_quantization);
  EXPECT_TRUE(node_of({.component = 5121, .normalized = true}, false).undoes_quantization);
  EXPECT_FALSE(node_of({.component = 5122}, true).undoes_quantization) << "which does not move it";
}

TEST_F(GltfScene, MaterialsOfWhichNothingWouldBeSeenAreTold) {
  const auto read_with = [&](const json& factor, bool is_textured, bool shines) {
    GltfBuilder file;
    file.textured({{"index", 0}});
    json& material = file.document["materials"][0];
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorFactor"] = factor;
    if (!is_textured) material["pbrMetallicRoughness"].erase("baseColorTexture");
    if (shines) material["emissiveTexture"] = {{"index", 0}};
    return model_of(file);
  };
  EXPECT_TRUE(tells(read_with({0, 0, 0, 1}, true, true).warnings, "nothing is seen of its texture 'hair.png'"));
  EXPECT_TRUE(read_with({0, 0, 0, 1}, false, false).warnings.empty()) << "black hair";
  EXPECT_TRUE(read_with({1, 1, 1, 1}, false, true).warnings.empty()) << "white hair that glows";
  const SourceModel model = read_with({0, 0, 0, 1}, false, true);
  EXPECT_TRUE(tells(model.warnings, "its texture 'hair.png' shines"));
  EXPECT_EQ(model.materials.at(0).base_texture.path, "hair.png");
  EXPECT_EQ(model.materials.at(0).base_color, Eigen::Vector4f::Ones());
}

TEST_F(GltfScene, WhatIsAllTransparentIsTakenForOpaqueAndOtherThingsAreNot) {
  const auto read_with = [&](float other_alpha, bool is_textured) {
    GltfBuilder file;
    file.textured({{"index", 0}});
    json& materials = file.document["materials"];
    materials[0]["alphaMode"] = "MASK";
    materials[0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 0.125, 0};
    if (!is_textured) materials[0]["pbrMetallicRoughness"].erase("baseColorTexture");
    materials.push_back(materials[0]);
    materials[1]["pbrMetallicRoughness"]["baseColorFactor"][3] = other_alpha;
    return model_of(file);
  };
  const SourceModel all = read_with(0, false);
  EXPECT_TRUE(tells(all.warnings, "every material is wholly transparent"));
  EXPECT_FALSE(tells(all.warnings, "nothing of it is seen")) << "one word is enough";
  EXPECT_EQ(all.materials.at(0).base_color, Eigen::Vector4f(0.5f, 0.25f, 0.125f, 1));
  EXPECT_EQ(all.materials.at(0).alpha_use, AlphaUse::kOpaque);
  EXPECT_EQ(read_with(0, true).materials.at(0).alpha_use, AlphaUse::kMask) << "the texture has an alpha of its own";
  const SourceModel one = read_with(1, false);
  EXPECT_TRUE(tells(one.warnings, "nothing of it is seen"));
  EXPECT_EQ(one.materials.at(0).base_color.w(), 0);
}

TEST_F(GltfScene, TheBaseTextureNamesItsSetOfUvs) {
  std::vector<float> other = kStripUvs;
  for (float& number : other) number = 0.25f + number / 2;
  for (const bool by_transform : {false, true}) {
    GltfBuilder file;
    file.attribute("TEXCOORD_1", other, "VEC2");
    const json in_transform = {
        {"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}};
    file.textured(by_transform ? in_transform : json{{"index", 0}, {"texCoord", 1}});
    EXPECT_LT((model_of(file).meshes[0].uvs[0] - Eigen::Vector2f(&other[0])).norm(), 1e-6f);
  }
  GltfBuilder lost;
  lost.textured({{"index", 0}, {"texCoord", 3}});
  const SourceModel model = model_of(lost);
  EXPECT_TRUE(model.meshes[0].uvs.empty());
  EXPECT_TRUE(tells(model.warnings, "UV set 3"));
}

TEST_F(GltfScene, SamplersSayWhatATextureShowsOutside) {
  GltfBuilder file;
  file.textured({{"index", 0}}, {{"wrapS", 33071}, {"wrapT", 33648}});
  const SourceTexture texture = model_of(file).materials.at(0).base_texture;
  EXPECT_EQ(texture.wrap[0], TextureWrap::kClamp);
  EXPECT_EQ(texture.wrap[1], TextureWrap::kMirror);
  EXPECT_EQ(texture.path, "hair.png");
}

TEST_F(GltfScene, EachInstanceIsAMesh) {
  GltfBuilder file;
  const std::vector<float> places{0, 0, 0, 5, 0, 0, 0, 0, 7}, sizes{1, 1, 1, 2, 2, 2, 1, 1, 1};
  const std::size_t translation = file.add(places, "VEC3"), scale = file.add(sizes, "VEC3");
  file.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translation},
                                                                                      {"SCALE", scale}};
  file.document["nodes"][0]["translation"] = {0, 10, 0};
  file.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const SourceModel model = model_of(file);
  ASSERT_EQ(model.meshes.size(), 3u);
  EXPECT_TRUE(model.meshes[1].positions[3].isApprox(Eigen::Vector3f(7, 14, 0), 1e-6f));
  EXPECT_TRUE(model.meshes[2].positions[3].isApprox(Eigen::Vector3f(1, 12, 7), 1e-6f));
}

TEST_F(GltfScene, HiddenNodesAndAllBelowAreLeftOut) {
  GltfBuilder file;
  file.document["nodes"] = {
      {{"name", "shown"}, {"mesh", 0}},
      {{"name", "off"}, {"children", {2}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
      {{"name", "below"}, {"mesh", 0}}};
  file.document["scenes"][0]["nodes"] = {0, 1};
  const SourceModel model = model_of(file);
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "shown");
  EXPECT_TRUE(tells(model.warnings, "'below'"));
}

TEST_F(GltfScene, OfLevelsOfDetailTheFinestIsKept) {
  GltfBuilder file;
  const auto kept = [&](std::vector<std::string> names) {
    file.document["nodes"] = json::array();
    file.document["scenes"][0]["nodes"] = json::array();
    for (std::size_t i = 0; i < names.size(); ++i) {
      file.document["nodes"].push_back({{"name", names[i]}, {"mesh", 0}});
      file.document["scenes"][0]["nodes"].push_back(i);
    }
    std::vector<std::string> left;
    const SourceModel model = model_of(file);
    for (const SourceMesh& mesh : model.meshes) left.push_back(model.nodes[mesh.node].name);
    return left;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(kept({"Hair_LOD0", "Hair_LOD1", "Hair_LOD2", "Head"}), (Names{"Hair_LOD0", "Head"}));
  EXPECT_EQ(kept({"hair lod 2", "hair lod 1"}), (Names{"hair lod 1"}));
  EXPECT_EQ(kept({"LOD0_Hair", "LOD0_Fringe", "LOD1_Hair"}), (Names{"LOD0_Hair", "LOD0_Fringe"}));
  EXPECT_EQ(kept({"BodyLOD1", "HairLOD0", "HairLOD10"}), (Names{"BodyLOD1", "HairLOD0"}));
  EXPECT_EQ(kept({"melody1", "melody2"}), (Names{"melody1", "melody2"})) << "not a level";
  EXPECT_EQ(kept({"Hair_LOD1"}), (Names{"Hair_LOD1"})) << "all that there is";
  // The finest level often has no number.
  EXPECT_EQ(kept({"Fringe", "hair", "Hair_LOD1", "Hair_LOD2"}), (Names{"Fringe", "hair"}));
  EXPECT_EQ(kept({"Hair", "Hair_LOD0", "Hair_LOD1"}), (Names{"Hair"})) << "one shape in one place";
}

TEST_F(GltfScene, MorphTargetsThatAreOnAreApplied) {
  const std::vector<float> longer{0, 0, 0, 0, 0, 0, 0, -1, 0, 0, -1, 0};
  GltfBuilder file;
  file.primitive()["targets"] = {{{"POSITION", file.add_places(longer)}}};
  file.document["meshes"][0]["extras"]["targetNames"] = {"Longer"};
  file.document["meshes"][0]["weights"] = {0.5};
  const SourceModel by_mesh = model_of(file);
  EXPECT_FLOAT_EQ(by_mesh.meshes[0].positions[3].y(), 1.5f);
  EXPECT_TRUE(tells(by_mesh.warnings, "'Longer' at 0.5"));
  file.document["nodes"][0]["weights"] = {0};
  const SourceModel by_node = model_of(file);
  EXPECT_FLOAT_EQ(by_node.meshes[0].positions[3].y(), 2.0f) << "the node's weights stand before the mesh's";
  EXPECT_TRUE(by_node.warnings.empty());
}

TEST_F(GltfScene, TheCallerChoosesAVariant) {
  GltfBuilder file;
  file.document["materials"] = {{{"name", "brown"}}, {{"name", "blonde"}}};
  file.primitive()["material"] = 0;
  file.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {1}}}};
  file.document["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "winter"}}, {{"name", "summer"}}};
  const auto material_of = [&](const std::string& variant) {
    ImportSettings settings;
    settings.variant = variant;
    const auto model = import_model(file.write(folder_), settings);
    return model ? material_name(*model, model->meshes[0]) : model.error().message;
  };
  EXPECT_EQ(material_of(""), "brown");
  EXPECT_EQ(material_of("summer"), "blonde");
  EXPECT_EQ(material_of("winter"), "brown") << "the primitive has none for it";
  EXPECT_NE(material_of("autumn").find("no variant 'autumn'; there are 'winter', 'summer'"), std::string::npos)
      << material_of("autumn");
}

TEST_F(GltfScene, WhatIsRequiredAndNotReadIsRefusedByName) {
  GltfBuilder file;
  file.document["extensionsUsed"] = {"ACME_curved_space", "KHR_materials_clearcoat"};
  const SourceModel used = model_of(file);
  EXPECT_TRUE(tells(used.warnings, "'ACME_curved_space'"));
  EXPECT_FALSE(tells(used.warnings, "clearcoat")) << "light is the cook's";
  file.document["extensionsRequired"] = {"ACME_curved_space"};
  const auto refused = import_model(file.write(folder_));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ToolError::Kind::kUnsupported);
  EXPECT_NE(refused.error().message.find("'ACME_curved_space'"), std::string::npos);
  file.document["extensionsRequired"] = {"KHR_texture_basisu"};
  EXPECT_NE(import_model(file.write(folder_)).error().message.find("ktxdecompress"), std::string::npos);
}

TEST_F(GltfScene, AFileSavedInAPoseSaysSo) {
  const std::vector<float> joints{0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
      all{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  GltfBuilder file;
  file.attribute("JOINTS_0", joints, "VEC4", {.component = 5121}).attribute("WEIGHTS_0", all, "VEC4");
  file.document["nodes"] = {
      {{"name", "strip"}, {"mesh", 0}, {"skin", 0}}, {{"name", "root"}, {"children", {2}}}, {{"name", "lock"}}};
  file.document["scenes"][0]["nodes"] = {0, 1};
  file.document["skins"] = {{{"joints", {1, 2}}}};
  EXPECT_EQ(model_of(file).meshes[0].posed_node, kNoIndex);
  file.document["nodes"][1]["translation"] = {0, 3, 0};
  EXPECT_EQ(model_of(file).meshes[0].posed_node, kNoIndex) << "all of it stands elsewhere";
  file.document["nodes"][2]["rotation"] = {0.5, 0, 0, 0.8660254};
  const SourceModel posed = model_of(file);
  ASSERT_NE(posed.meshes[0].posed_node, kNoIndex);
  EXPECT_EQ(posed.nodes[posed.meshes[0].posed_node].name, "lock");
  EXPECT_NEAR(posed.meshes[0].posed_degrees, 60, 0.1);
}

TEST_F(GltfScene, ANamelessNodeOfAPackingToolIsNotTheMeshsName) {
  GltfBuilder file;
  file.document["meshes"][0].erase("name");
  file.document["nodes"] = {{{"name", "Hair"}, {"children", {1}}, {"translation", {0, 4, 0}}},
                            {{"mesh", 0}, {"scale", {2, 2, 2}}}};
  const SourceModel model = model_of(file);
  EXPECT_EQ(model.meshes[0].name, "Hair");
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "Hair");
  EXPECT_TRUE(model.meshes[0].positions[3].isApprox(Eigen::Vector3f(2, 8, 0), 1e-6f));
}

TEST_F(GltfScene, BuffersAreFoundByTheirDecodedNameAndOnlyInTheFolder) {
  GltfBuilder file;
  folder_.write("long hair.bin", file.buffer);
  const auto beside = [&](const std::string& uri) {
    json document = file.document;
    document["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", uri}}};
    return import_model(folder_.write("m.gltf", document.dump()));
  };
  const auto model = beside("long%20hair.bin");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->side_files, (std::vector<std::string>{(folder_.path() / "long hair.bin").string()}));
  EXPECT_NE(beside("gone.bin").error().message.find("there is no such file; put it beside"), std::string::npos);
  for (const char* const uri : {"../secret.bin", "/etc/passwd", "%2e%2e/secret.bin"}) {
    const auto refused = beside(uri);
    ASSERT_FALSE(refused) << uri;
    EXPECT_NE(refused.error().message.find("not in this file's folder"), std::string::npos) << refused.error().message;
  }
}

TEST_F(GltfScene, DataUrisMayBeEscaped) {
  GltfBuilder file;
  const auto within = [&](const std::string& uri) {
    json document = file.document;
    document["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", uri}}};
    return import_model(folder_.write("m.gltf", document.dump()));
  };
  const std::string in_base64 = base64({reinterpret_cast<const std::uint8_t*>(file.buffer.data()), file.buffer.size()});
  std::string escaped, bytes;
  for (const char letter : in_base64) escaped += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  for (const char byte : file.buffer) bytes += fmt::format("%{:02x}", static_cast<unsigned char>(byte));
  const std::string head = "data:application/octet-stream";
  const auto plain = within(head + ";base64," + in_base64);
  ASSERT_TRUE(plain) << plain.error().message;
  for (const std::string& uri : {head + ";base64," + escaped, head + "," + bytes}) {
    const auto model = within(uri);
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->meshes[0].positions, plain->meshes[0].positions);
  }
  for (const std::string& uri : {head + ";base64,?" + in_base64, head}) {
    const auto refused = within(uri);
    ASSERT_FALSE(refused) << uri;
    EXPECT_NE(refused.error().message.find("a damaged data: URI"), std::string::npos) << refused.error().message;
  }
}

TEST_F(GltfScene, VersionsThatAreNotReadAreToldWithTheirCure) {
  GltfBuilder file;
  file.document["asset"]["version"] = "1.0";
  EXPECT_NE(import_model(file.write(folder_)).error().message.find("gltf-pipeline"), std::string::npos);
}

}  // namespace coif::importer::gltf_scene_test
