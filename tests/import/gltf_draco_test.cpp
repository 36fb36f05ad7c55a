// Meshes that KHR_draco_mesh_compression holds, packed here by Draco's own encoder.

#include "import/gltf_builder.h"
#include "import/imported_model.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

namespace coif::importer::gltf_draco_test {

using test::GltfBuilder;
using test::import_or_fail;
using test::kStripPositions;
using test::kStripUvs;
using test::TemporaryFolder;

struct Packed {
  std::string bytes;
  int position = 0, uv = 0, joints = 0, weights = 0;  // unique ids
};

Packed pack() {
  constexpr int kCorners[2][3] = {{0, 1, 2}, {2, 1, 3}};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int ids[4] = {builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32),
                      builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32),
                      builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8),
                      builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8)};
  for (int f = 0; f < 2; ++f) {
    const auto set = [&](int id, auto of_vertex) {
      auto a = of_vertex(kCorners[f][0]), b = of_vertex(kCorners[f][1]), c = of_vertex(kCorners[f][2]);
      builder.SetAttributeValuesForFace(id, draco::FaceIndex(std::uint32_t(f)), a.data(), b.data(), c.data());
    };
    set(ids[0], [](int v) {
      return std::array{kStripPositions[3 * v], kStripPositions[3 * v + 1], kStripPositions[3 * v + 2]};
    });
    set(ids[1], [](int v) { return std::array{kStripUvs[2 * v], kStripUvs[2 * v + 1]}; });
    set(ids[2], [](int v) { return std::array<std::uint8_t, 4>{std::uint8_t(v < 2 ? 0 : 1), 0, 0, 0}; });
    set(ids[3], [](int) { return std::array<std::uint8_t, 4>{255, 0, 0, 0}; });
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  Packed out;
  const auto unique = [&](int id) { return int(mesh->attribute(id)->unique_id()); };
  out.position = unique(ids[0]), out.uv = unique(ids[1]), out.joints = unique(ids[2]), out.weights = unique(ids[3]);
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  out.bytes.assign(buffer.data(), buffer.size());
  return out;
}

GltfBuilder packed_file(const Packed& packed) {
  GltfBuilder file;
  const std::vector<float> zeros(16, 0), ones(16, 1);
  file.attribute("JOINTS_0", zeros, "VEC4", {.component = 5121})
      .attribute("WEIGHTS_0", ones, "VEC4", {.component = 5121, .normalized = true});
  for (auto& accessor : file.document["accessors"]) accessor.erase("bufferView");
  file.buffer.clear();
  file.document["bufferViews"] = nlohmann::json::array();
  file.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", file.add_view(packed.bytes)},
                                                                  {"attributes",
                                                                   {{"POSITION", packed.position},
                                                                    {"TEXCOORD_0", packed.uv},
                                                                    {"JOINTS_0", packed.joints},
                                                                    {"WEIGHTS_0", packed.weights}}}};
  file.primitive()["attributes"].erase("NORMAL");
  file.document["nodes"] = {
      {{"name", "strip"}, {"mesh", 0}, {"skin", 0}}, {{"name", "a"}, {"children", {2}}}, {{"name", "b"}}};
  file.document["scenes"][0]["nodes"] = {0, 1};
  file.document["skins"] = {{{"joints", {1, 2}}}};
  return file;
}

class GltfDraco : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(GltfDraco, EveryAttributeComesOutAsItWentIn) {
  const SourceModel model = import_or_fail(packed_file(pack()).write(folder_));
  const SourceMesh& mesh = model.meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 6u);
  for (std::size_t v = 0; v < 4; ++v) {
    // Draco orders vertices as it likes; V of the strip grows against its Y.
    EXPECT_FLOAT_EQ(mesh.uvs[v].y(), 1 - mesh.positions[v].y() / 2);
    EXPECT_EQ(model.nodes[mesh.influences[v].node].name, mesh.positions[v].y() < 1 ? "a" : "b");
    EXPECT_FLOAT_EQ(mesh.influences[v].weight, 1);
  }
}

TEST_F(GltfDraco, DamageIsAnErrorThatNamesIt) {
  Packed packed = pack();
  for (std::size_t cut = 0; cut < packed.bytes.size(); cut += 7) {
    Packed damaged = packed;
    damaged.bytes.resize(cut);
    const auto model = import_model(packed_file(damaged).write(folder_));
    ASSERT_FALSE(model) << cut;
    EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput) << model.error().message;
  }
}

}  // namespace coif::importer::gltf_draco_test
