#include "groom/read_groom.h"

#include "groom/groom_files.h"
#include "import/model_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>

namespace coif::groom::read_groom_test {

namespace fs = std::filesystem;

std::string fault_of(const fs::path& path) {
  const auto groom = read_groom(path);
  return groom ? "" : groom.error().message;
}

/// A glTF whose node 0 has lines of four vertices, a unit apart along X.
fs::path write_gltf(const importer::test::TemporaryFolder& folder, int mode, const std::vector<std::uint16_t>& indices,
                    const char* node = "") {
  test::Bytes buffer;
  buffer.add_all<float>({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}).add_all(indices);
  folder.write("lines.bin", buffer.bytes);
  return folder.write("lines.gltf",
                      fmt::format(R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}],
    "nodes": [{{"name": "curves", "mesh": 0{}}}],
    "meshes": [{{"primitives": [{{"mode": {}, "attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
    "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}},
                  {{"bufferView": 1, "componentType": 5123, "count": {}, "type": "SCALAR"}}],
    "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": {}}}],
    "buffers": [{{"uri": "lines.bin", "byteLength": {}}}]}})",
                                  node, mode, indices.size(), 2 * indices.size(), 48 + 2 * indices.size()));
}

TEST(ReadGroom, LinesOfGltfAreSegmentsStripsAndLoops) {
  const importer::test::TemporaryFolder folder;
  const auto segments = read_groom(write_gltf(folder, 1, {0, 1, 1, 2, 2, 3}));
  ASSERT_TRUE(segments) << segments.error().message;
  EXPECT_EQ(segments->begin, (std::vector<std::uint32_t>{0, 4}));
  EXPECT_EQ(segments->groups[0].name, "curves");
  const auto strip =
      read_groom(write_gltf(folder, 3, {0, 1, 2, 3}, R"(, "translation": [0, 1, 0], "scale": [2, 1, 1])"));
  ASSERT_TRUE(strip) << strip.error().message;
  EXPECT_EQ(strip->points.back(), Eigen::Vector3f(6, 1, 0));
  const auto loop = read_groom(write_gltf(folder, 2, {0, 1, 2, 3}));
  ASSERT_TRUE(loop) << loop.error().message;
  EXPECT_EQ(loop->points.back(), Eigen::Vector3f(0, 0, 0));
  EXPECT_NE(fault_of(write_gltf(folder, 1, {0, 9})).find("an index beyond the vertices"), std::string::npos);
  EXPECT_NE(fault_of(write_gltf(folder, 4, {0, 1, 2})).find("no strand that could be used"), std::string::npos);
}

TEST(ReadGroom, UnitAndAxisOfTheCallerGoBeforeTheFiles) {
  const importer::test::TemporaryFolder folder;
  const fs::path file = folder.write("a.tfx", test::small_tfx_4().bytes);
  importer::ImportSettings settings;
  settings.metres_per_unit = 0.01;
  settings.up_axis = importer::UpAxis::kZ;
  const auto groom = read_groom(file, settings);
  ASSERT_TRUE(groom) << groom.error().message;
  EXPECT_TRUE(groom->points[5].isApprox(Eigen::Vector3f(0.01f, 0.005f, -0.02f)));
  EXPECT_FLOAT_EQ(groom->widths[0], 0.0001f);
  EXPECT_EQ(groom->space.unit, importer::Statement::kGiven);
}

TEST(ReadGroom, NamesTheFileTheFaultAndTheCure) {
  const importer::test::TemporaryFolder folder;
  const fs::path cut = folder.write("cut.tfx", test::small_tfx_3().bytes.substr(0, 300));
  EXPECT_EQ(fault_of(cut),
            cut.string() + ": cannot be read as TressFX: cut off in the points: 4 of 72 bytes from byte 296 on");
  const fs::path other = folder.write("a.abc", "x");
  EXPECT_EQ(
      fault_of(other),
      other.string() + ": '.abc' holds no strands that can be read; export as one of .hair, .tfx, .obj, .gltf, .glb");
  EXPECT_NE(fault_of(folder.path() / "none.hair").find("No such file"), std::string::npos);
}

TEST(GroomStream, AnswersOfAnHonestProcessComeThroughAndOthersDoNot) {
  const importer::test::TemporaryFolder folder;
  const auto groom = read_groom(folder.write("a.hair", test::small_hair().bytes));
  ASSERT_TRUE(groom) << groom.error().message;
  const auto bytes = encode_groom(*groom);
  GroomOutcome outcome;
  ASSERT_TRUE(decode_groom(bytes, outcome));
  EXPECT_EQ(outcome->points, groom->points);
  EXPECT_EQ(outcome->colors, groom->colors);
  EXPECT_EQ(outcome->groups.size(), groom->groups.size());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    GroomOutcome cut;
    EXPECT_FALSE(decode_groom(std::span(bytes).first(at), cut)) << at;
    auto spoilt = bytes;
    spoilt[at] ^= 0x80;
    GroomOutcome other;
    if (decode_groom(spoilt, other) && other) {
      EXPECT_EQ(find_groom_fault(*other), "") << at;
    }
  }
}

/// Artists' files as they come. Skipped where the corpus is absent.
TEST(GroomCorpus, HasTheStrandsThatTheManifestCounts) {
  const fs::path assets = COIF_TEST_ASSETS;
  if (!fs::exists(assets / "MANIFEST.json")) GTEST_SKIP() << "no corpus of artists' files at " << assets;
  const auto manifest = nlohmann::json::parse(std::ifstream(assets / "MANIFEST.json"));
  std::size_t seen = 0, of_parts = 0;
  for (const auto& entry : manifest.items()) {
    if (!entry.value().is_array()) continue;
    for (const auto& file : entry.value()) {
      if (!file.is_object() || !file.contains("strands")) continue;
      const std::string name = file["file"];
      const auto groom = read_groom(assets / name);
      ASSERT_TRUE(groom) << groom.error().message;
      EXPECT_EQ(groom->strand_count(), file["strands"].get<std::size_t>()) << name;
      EXPECT_TRUE(groom->warnings.empty()) << name << ": " << groom->warnings.front().message;
      if (name.ends_with(".obj"))
        EXPECT_EQ(groom->groups.size(), 4u);
      else
        of_parts += groom->strand_count();
      ++seen;
    }
  }
  EXPECT_GE(seen, 5u);
  EXPECT_EQ(of_parts, 4714u);
}

}  // namespace coif::groom::read_groom_test
