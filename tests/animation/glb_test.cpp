#include "animation/glb_reader.h"
#include "animation/recording.h"
#include "import/import.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace coif::animation::glb_test {

class Glb : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(asset().is_open());
    auto recording = record(asset(), {.motion = motion::Motion::kTumble, .fps = 30, .seconds = 2});
    ASSERT_TRUE(recording);
    recording_ = *recording;
    file_ = to_glb(asset(), recording_);
    ASSERT_TRUE(glb_.read(file_));
  }
  [[nodiscard]] const Asset& asset() const { return open_.asset(); }
  [[nodiscard]] nlohmann::json attribute(const char* name) const {
    return glb_.document()["meshes"][0]["primitives"][0]["attributes"][name];
  }

  OpenAsset open_{small_asset()};
  Recording recording_;
  std::vector<std::byte> file_;
  GlbReader glb_;
};

Eigen::Affine3d world_from_head(const HeadPose& pose) {
  Eigen::Affine3d transform(Eigen::Translation3d(pose.position[0], pose.position[1], pose.position[2]));
  const Quat& q = pose.rotation;
  transform.rotate(Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>());
  return transform;
}

Eigen::Affine3d skinning_matrix(const Mat34& m) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) transform(row, column) = double(m.m[row][column]);
  }
  return transform;
}

TEST_F(Glb, MovesEveryJointAsThePaletteDoes) {
  const std::size_t bones = asset().bones().size();
  const auto& skin = glb_.document()["skins"][0];
  const std::vector<float> inverse_bind = glb_.floats(skin["inverseBindMatrices"]);
  ASSERT_EQ(inverse_bind.size(), 16 * bones);
  for (std::size_t frame = 0; frame < recording_.frames.size(); frame += 7) {
    for (std::size_t bone = 0; bone < bones; ++bone) {
      const Eigen::Affine3d bind(Eigen::Map<const Eigen::Matrix4f>(&inverse_bind[16 * bone]).cast<double>());
      const Eigen::Affine3d shown = glb_.world_from_node(skin["joints"][bone], frame) * bind;
      const RecordedFrame& recorded = recording_.frames[frame];
      const Eigen::Affine3d wanted = world_from_head(recorded.head) * skinning_matrix(recorded.palette[bone]);
      EXPECT_LT((shown.matrix() - wanted.matrix()).cwiseAbs().maxCoeff(), 1e-4)
          << "frame " << frame << " bone " << bone;
    }
  }
}

TEST_F(Glb, KeepsWeightsThatAddUpToOneAndUnusedJointsAtZero) {
  const auto weights = glb_.bytes(attribute("WEIGHTS_0"));
  const auto joints = glb_.bytes(attribute("JOINTS_0"));
  ASSERT_EQ(weights.size(), 4 * asset().vertices().size());
  ASSERT_EQ(joints.size(), weights.size());
  for (std::size_t v = 0; v < weights.size(); v += 4) {
    EXPECT_EQ(weights[v] + weights[v + 1] + weights[v + 2] + weights[v + 3], 255);
    for (std::size_t k = v; k < v + 4; ++k) EXPECT_TRUE(weights[k] > 0 || joints[k] == 0) << k;
  }
}

TEST_F(Glb, DeclaresTheBoundsOfPositionsAndTimes) {
  const auto& accessors = glb_.document()["accessors"];
  const auto& positions = accessors[attribute("POSITION").get<std::size_t>()];
  const std::vector<float> values = glb_.floats(attribute("POSITION"));
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_GE(values[i], positions["min"][i % 3].get<float>());
    EXPECT_LE(values[i], positions["max"][i % 3].get<float>());
  }
  const auto& times = accessors[glb_.document()["animations"][0]["samplers"][0]["input"].get<std::size_t>()];
  EXPECT_EQ(times["min"][0], 0.0f);
  EXPECT_EQ(times["max"][0], 2.0f);
  EXPECT_EQ(times["count"], recording_.frames.size());
}

TEST_F(Glb, KeepsRotationsUnitAndOnOneSide) {
  const auto& animation = glb_.document()["animations"][0];
  std::size_t tracks = 0;
  for (const auto& channel : animation["channels"]) {
    if (channel["target"]["path"] != "rotation") continue;
    ++tracks;
    const auto keys = glb_.floats(animation["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
    ASSERT_EQ(keys.size(), 4 * recording_.frames.size());
    Eigen::Vector4f last = Eigen::Vector4f::Map(&keys[0]);
    for (std::size_t i = 0; i < keys.size(); i += 4) {
      const Eigen::Vector4f key = Eigen::Vector4f::Map(&keys[i]);
      EXPECT_NEAR(key.norm(), 1.0f, 1e-5f);
      EXPECT_GE(key.dot(last), 0.0f);
      last = key;
    }
  }
  EXPECT_EQ(tracks, 1 + asset().skeleton().simulated_count);
}

TEST_F(Glb, AlignsEveryView) {
  ASSERT_FALSE(glb_.document()["bufferViews"].empty());
  for (const auto& view : glb_.document()["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
}

TEST_F(Glb, EmbedsTheTextureThatItIsGiven) {
  const std::vector<std::uint8_t> png = {0x89, 'P', 'N', 'G', 1, 2, 3};
  GlbReader textured;
  ASSERT_TRUE(textured.read(to_glb(asset(), recording_, png)));
  const auto& image = textured.document()["images"][0];
  EXPECT_EQ(image["mimeType"], "image/png");
  const auto stored = textured.view(image["bufferView"]);
  ASSERT_EQ(stored.size(), png.size());
  for (std::size_t i = 0; i < png.size(); ++i) EXPECT_EQ(std::to_integer<std::uint8_t>(stored[i]), png[i]);
  EXPECT_TRUE(textured.document()["materials"][0]["pbrMetallicRoughness"].contains("baseColorTexture"));
}

TEST_F(Glb, ComesBackThroughTheImporter) {
  const auto path = std::filesystem::path(testing::TempDir()) / "coif_recording.glb";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file_.data()), std::streamsize(file_.size()));
  const auto model = importer::import_model(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model->meshes.size(), 1u);
  EXPECT_EQ(model->meshes[0].triangles.size(), asset().lod_indices(0).size());
  EXPECT_FALSE(model->meshes[0].influences.empty());
  for (const char* name : {"Head", "scalp", "hair_1", "hair_2", "fringe"}) {
    EXPECT_TRUE(std::any_of(model->nodes.begin(), model->nodes.end(), [name](const importer::SourceNode& node) {
      return node.name == name;
    })) << name;
  }
}

TEST(GlbOfManyBones, NamesJointsBeyondAByte) {
  AssetContents contents = small_asset();
  const auto last = std::uint16_t(contents.bones.size() + 400);
  contents.bones.resize(2);
  contents.bones.resize(last + 1u, contents.bones[1]);
  contents.bone_names.clear();
  contents.chains.clear();
  contents.dynamics.clear();
  contents.limits.clear();
  contents.links.clear();
  clear_group("body", contents);
  contents.lods.clear();
  contents.lod_bones.clear();
  for (PatchRecord& patch : contents.patches) patch.bone = 0;
  for (SkinRecord& skin : contents.skin) skin = {{last, 0, 0, 0}, {200, 55, 0, 0}};
  const OpenAsset open(contents);
  ASSERT_TRUE(open.asset().is_open());
  const auto recording = record(open.asset(), {.motion = motion::Motion::kNod, .seconds = 0.1});
  ASSERT_TRUE(recording);
  GlbReader glb;
  ASSERT_TRUE(glb.read(to_glb(open.asset(), *recording)));
  const auto& attributes = glb.document()["meshes"][0]["primitives"][0]["attributes"];
  const auto& joints = glb.document()["accessors"][attributes["JOINTS_0"].get<std::size_t>()];
  EXPECT_EQ(joints["componentType"], 5123) << "unsigned short";
  const auto stored = glb.view(joints["bufferView"]);
  ASSERT_EQ(stored.size(), 8 * contents.vertices.size());
  EXPECT_EQ(std::to_integer<int>(stored[0]) + 256 * std::to_integer<int>(stored[1]), last);
  EXPECT_EQ(glb.document()["skins"][0]["joints"].size(), contents.bones.size());
}

TEST(GlbWithoutMesh, StillHasTheMovingBones) {
  const OpenAsset open(without_mesh(small_asset()));
  ASSERT_TRUE(open.asset().is_open());
  const auto recording = record(open.asset(), {.motion = motion::Motion::kNod, .seconds = 1});
  ASSERT_TRUE(recording);
  GlbReader glb;
  ASSERT_TRUE(glb.read(to_glb(open.asset(), *recording)));
  EXPECT_FALSE(glb.document().contains("meshes"));
  EXPECT_EQ(glb.document()["nodes"].size(), open.asset().bones().size());
  EXPECT_FALSE(glb.document()["animations"][0]["channels"].empty());
}

TEST(GlbWithoutFrames, IsEmpty) {
  const OpenAsset open(small_asset());
  EXPECT_TRUE(to_glb(open.asset(), Recording{}).empty());
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

Recording one_frame(const Asset& asset, const HeadPose& head, const Vec3& end) {
  Recording recording;
  recording.frames.push_back(
      {0.25, head, std::vector<Mat34>(asset.bones().size()), std::vector<Vec3>(asset.bones().size(), end)});
  return recording;
}

TEST(Csv, HasOneRowPerFrameAndBone) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  const auto recording = record(file.asset(), {.motion = motion::Motion::kRun, .fps = 30, .seconds = 1});
  ASSERT_TRUE(recording);
  const auto lines = lines_of(to_csv(file.asset(), *recording));
  ASSERT_EQ(lines.size(), 1 + 31 * file.asset().bones().size());
  EXPECT_EQ(lines[0], "frame,seconds,bone,name,x,y,z,world_x,world_y,world_z");
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_EQ(fields_of(lines[i]).size(), 10u) << lines[i];
}

TEST(Csv, GivesWorldPositionsUnderTheHeadsPose) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  HeadPose head;  // a half turn about Y, then moved: (1, 2, 3) -> (-1, 2, -3) -> (9, 2, -3)
  head.position[0] = 10;
  head.rotation = {0, 1, 0, 0};
  const auto lines = lines_of(to_csv(file.asset(), one_frame(file.asset(), head, {1, 2, 3})));
  ASSERT_GT(lines.size(), 3u);
  EXPECT_EQ(lines[3], "0,0.250000,2,hair_1,1.000000,2.000000,3.000000,9.000000,2.000000,-3.000000");
}

TEST(Csv, QuotesNamesThatWouldBreakARow) {
  AssetContents contents = small_asset();
  contents.bone_names[2] = "left, \"long\"";
  const OpenAsset file(contents);
  ASSERT_TRUE(file.asset().is_open());
  const std::string text = to_csv(file.asset(), one_frame(file.asset(), {}, {}));
  EXPECT_NE(text.find(",2,\"left, \"\"long\"\"\",0.0"), std::string::npos) << text;
}

}  // namespace coif::animation::glb_test
