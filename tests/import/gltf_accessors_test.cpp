// The same strip, stored in every way that glTF and its extensions allow, is the same strip.

#include "import/gltf_builder.h"
#include "import/imported_model.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace coif::importer::gltf_accessors_test {

using test::GltfBuilder;
using test::import_or_fail;
using test::kStripNormals;
using test::kStripPositions;
using test::kStripUvs;
using test::Storage;
using test::TemporaryFolder;

std::string name_of(const Storage& storage) {
  return fmt::format("component {}{}, {} bytes between, {}{}", storage.component,
                     storage.normalized ? " normalized" : "", storage.padding, storage.sparse ? "sparse" : "in a view",
                     storage.meshopt ? ", compressed" : "");
}

/// Each component type, normalized and not, tight and apart, sparse and compressed.
std::vector<Storage> every_storage() {
  std::vector<Storage> all;
  for (const int component : {5120, 5121, 5122, 5123, 5126}) {
    for (const bool normalized : {false, true}) {
      if (component == 5126 && normalized) continue;
      for (const std::size_t padding : {0u, 5u}) {
        for (const bool sparse : {false, true}) {
          if (!sparse || padding == 0) all.push_back({component, normalized, padding, sparse, false});
        }
      }
    }
  }
  return all;
}

/// What compressing tools ask for: elements of a multiple of four bytes.
Storage compressed(int component, bool normalized, std::size_t width) {
  const std::size_t size = component == 5126 ? 4 : component <= 5121 ? 1 : 2;
  return {component, normalized, (4 - size * width % 4) % 4, false, true};
}

class GltfAccessors : public testing::Test {
 protected:
  SourceMesh mesh_of(const GltfBuilder& file) { return import_or_fail(file.write(folder_)).meshes.at(0); }
  TemporaryFolder folder_;
};

TEST_F(GltfAccessors, PositionsMeanTheSameHoweverTheyAreStored) {
  std::vector<Storage> ways = every_storage();
  for (const int component : {5122, 5126}) ways.push_back(compressed(component, component != 5126, 3));
  for (const Storage& storage : ways) {
    SCOPED_TRACE(name_of(storage));
    GltfBuilder file;
    // Fractions of the node's scale, as packing tools write them.
    const float scale = storage.normalized ? 2.0f : 1.0f;
    std::vector<float> numbers = kStripPositions;
    for (float& number : numbers) number /= scale;
    file.attribute("POSITION", numbers, "VEC3", storage);
    file.document["nodes"][0]["scale"] = {scale, scale, scale};
    const SourceMesh mesh = mesh_of(file);
    ASSERT_EQ(mesh.positions.size(), 4u);
    for (std::size_t v = 0; v < 4; ++v) {
      const Eigen::Vector3f meant(&kStripPositions[3 * v]);
      EXPECT_LT((mesh.positions[v] - meant).norm(), storage.component <= 5121 && storage.normalized ? 2e-2f : 1e-4f);
    }
  }
}

TEST_F(GltfAccessors, NormalsUvsAndColoursMeanTheSameHoweverTheyAreStored) {
  for (const Storage& storage : every_storage()) {
    SCOPED_TRACE(name_of(storage));
    GltfBuilder file;
    const std::vector<float> colors{0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    file.attribute("NORMAL", kStripNormals, "VEC3", storage).attribute("TEXCOORD_0", kStripUvs, "VEC2", storage);
    file.attribute("COLOR_0", colors, "VEC4", storage);
    const SourceMesh mesh = mesh_of(file);
    ASSERT_EQ(mesh.uvs.size(), 4u);
    ASSERT_EQ(mesh.colors.size(), 4u);
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_TRUE(mesh.normals[v].isApprox(Eigen::Vector3f::UnitZ(), 1e-6f));
      EXPECT_LT((mesh.uvs[v] - Eigen::Vector2f(&kStripUvs[2 * v])).norm(), 1e-6f);
      EXPECT_LT((mesh.colors[v] - Eigen::Vector4f(&colors[4 * v])).norm(), 1e-6f);
    }
  }
}

TEST_F(GltfAccessors, ColoursWithoutAlphaAreOpaque) {
  GltfBuilder file;
  const std::vector<float> colors{0.25f, 0.5f, 1, 0, 0, 0, 1, 1, 1, 0.5f, 0.5f, 0.5f};
  file.attribute("COLOR_0", colors, "VEC3", {.component = 5123, .normalized = true});
  const SourceMesh mesh = mesh_of(file);
  EXPECT_LT((mesh.colors.at(0) - Eigen::Vector4f(0.25f, 0.5f, 1, 1)).norm(), 1e-4f);
}

TEST_F(GltfAccessors, WeightsOfAnyKindHoldTheSameVertices) {
  const std::vector<float> joints{0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  const std::vector<float> weights{0.6f, 0.4f, 0, 0, 0.2f, 0.8f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  for (const Storage& stored_weights :
       {Storage{5126}, Storage{5121, true}, Storage{5123, true}, Storage{5121, true, 4}, compressed(5121, true, 4)}) {
    for (const Storage& stored_joints : {Storage{5121}, Storage{5123}}) {
      SCOPED_TRACE(name_of(stored_weights));
      GltfBuilder file;
      file.attribute("JOINTS_0", joints, "VEC4", stored_joints).attribute("WEIGHTS_0", weights, "VEC4", stored_weights);
      // Both joints have one name, which says nothing: the skin's list does.
      file.document["nodes"] = {
          {{"name", "strip"}, {"mesh", 0}, {"skin", 0}}, {{"name", "bone"}, {"children", {2}}}, {{"name", "bone"}}};
      file.document["scenes"][0]["nodes"] = {0, 1};
      file.document["skins"] = {{{"joints", {1, 2}}}};
      const SourceModel model = import_or_fail(file.write(folder_));
      const SourceMesh& mesh = model.meshes.at(0);
      ASSERT_EQ(mesh.influence_begin, (std::vector<std::uint32_t>{0, 2, 4, 5, 6}));
      EXPECT_NEAR(mesh.influences[0].weight, 0.6f, 3e-3f);
      EXPECT_NEAR(mesh.influences[2].weight, 0.8f, 3e-3f);
      EXPECT_EQ(mesh.influences[0].node + 1, mesh.influences[1].node) << "root, then its child of the same name";
      EXPECT_EQ(mesh.influences[2].node, mesh.influences[1].node);
      EXPECT_TRUE(model.warnings.empty()) << model.warnings.front().message;
    }
  }
}

TEST_F(GltfAccessors, OfSkinsWithMoreThanFourBonesAVertexAllCount) {
  GltfBuilder file;
  const std::vector<float> first(16, 0), second{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  std::vector<float> half(16, 0);
  for (std::size_t v = 0; v < 4; ++v) half[4 * v] = 0.5f;
  file.attribute("JOINTS_0", first, "VEC4", {.component = 5121}).attribute("WEIGHTS_0", half, "VEC4");
  file.attribute("JOINTS_1", second, "VEC4", {.component = 5121}).attribute("WEIGHTS_1", half, "VEC4");
  file.document["nodes"] = {
      {{"name", "strip"}, {"mesh", 0}, {"skin", 0}}, {{"name", "a"}, {"children", {2}}}, {{"name", "b"}}};
  file.document["scenes"][0]["nodes"] = {0, 1};
  file.document["skins"] = {{{"joints", {1, 2}}}};
  EXPECT_EQ(mesh_of(file).influences.size(), 8u);
}

TEST_F(GltfAccessors, WhatIsCutOffOrOfUnlikeLengthIsRefusedByName) {
  const auto message_of = [&](auto change) {
    GltfBuilder file;
    change(file);
    const auto model = import_model(file.write(folder_));
    return model ? std::string("read") : model.error().message;
  };
  EXPECT_NE(message_of([](GltfBuilder& f) {
              f.document["accessors"][0]["count"] = 5;
            }).find("POSITION: accessor 0 is cut off"),
            std::string::npos);
  EXPECT_NE(message_of([](GltfBuilder& f) {
              f.document["accessors"][2]["count"] = 3;
            }).find("TEXCOORD_0: there are 3 of them, and 4 positions"),
            std::string::npos);
  EXPECT_NE(message_of([](GltfBuilder& f) {
              f.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {
                  {"buffer", 0}, {"byteLength", 8}, {"byteStride", 12}, {"count", 4}, {"mode", "ATTRIBUTES"}};
            }).find("EXT_meshopt_compression"),
            std::string::npos);
}

}  // namespace coif::importer::gltf_accessors_test
