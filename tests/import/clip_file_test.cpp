#include "import/clip_file.h"

#include "import/model_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>

namespace coif::importer::test::clip_file_test {

namespace fs = std::filesystem;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;
using Kind = ToolError::Kind;

const std::vector<float> kTimes{0, 0.5f, 1};
const std::vector<float> kWay{0, 0, 0, 1, 0, 0, 1, 2, 0};

double turn_of(double seconds) { return 0.8 * seconds; }

class ClipFileTest : public testing::Test {
 protected:
  static ClipDocument nod() { return ClipDocument().animate(0, "rotation", kTimes, turns_about_x(kTimes, turn_of)); }

  tl::expected<ClipFile, ToolError> read(const ClipDocument& clip, std::string_view node = "") {
    return read_clip(folder_.write("clip.gltf", clip.text()), node);
  }
  void expect_refused(const ClipDocument& clip, const std::string& text, std::string_view node = "") {
    const auto read_back = read(clip, node);
    ASSERT_FALSE(read_back) << text;
    EXPECT_EQ(read_back.error().kind, Kind::kBadInput) << read_back.error().message;
    EXPECT_TRUE(read_back.error().message.starts_with((folder_.path() / "clip.gltf").string() + ": "));
    EXPECT_NE(read_back.error().message.find(text), std::string::npos) << read_back.error().message;
  }
  static void expect_turn(const Quaterniond& rotation, double radians, const Vector3d& axis = Vector3d::UnitX()) {
    EXPECT_LT(rotation.angularDistance(Quaterniond(AngleAxisd(radians, axis))), 1e-6);
  }

  TemporaryFolder folder_;
};

TEST_F(ClipFileTest, ABufferThatIsNamedOtherwiseIsTold) {
  const ClipDocument clip = nod();
  folder_.write("Nod.bin", clip.buffer());
  const auto read_back = read_clip(folder_.write("c.gltf", clip.text_beside("maps\\\\nod.BIN")), "");
  ASSERT_TRUE(read_back) << read_back.error().message;
  ASSERT_EQ(read_back->notes.size(), 1u);
  EXPECT_NE(read_back->notes[0].find("'Nod.bin' is taken for it"), std::string::npos) << read_back->notes[0];
}

TEST_F(ClipFileTest, ReadsTheOnlyAnimatedNodeFromEveryContainer) {
  const ClipDocument clip = nod();
  const fs::path inside = folder_.write("a.gltf", clip.text()), binary = folder_.write("b.GLB", clip.glb());
  folder_.write("my clip.bin", clip.buffer());
  const fs::path beside = folder_.write("c.gltf", clip.text_beside("my%20clip.bin"));
  for (const fs::path& path : {inside, binary, beside}) {
    const auto read_back = read_clip(path, "");
    ASSERT_TRUE(read_back) << read_back.error().message;
    EXPECT_EQ(read_back->node, "head");
    EXPECT_TRUE(read_back->notes.empty());
    ASSERT_EQ(read_back->keys.size(), 3u);
    for (const NodeKey& key : read_back->keys) expect_turn(key.rotation, turn_of(key.seconds));
  }
}

TEST_F(ClipFileTest, KeysOfAllChannelsAndParentsMeetInTheWorld) {
  ClipDocument clip = nod();
  clip.document["nodes"].push_back(
      {{"name", "body"}, {"children", {0}}, {"translation", {0, 1, 0}}, {"scale", {2, 2, 2}}});
  clip.document["nodes"][0]["translation"] = {0, 0, 0.5};
  const float right = float(std::sqrt(0.5));
  clip.animate(1, "rotation", {0.25f, 0.75f}, {0, 0, 0, 1, 0, right, 0, right});
  const auto read_back = read(clip, "head");
  ASSERT_TRUE(read_back) << read_back.error().message;
  ASSERT_EQ(read_back->keys.size(), 5u);
  const NodeKey &first = read_back->keys.front(), &middle = read_back->keys[2], &last = read_back->keys.back();
  EXPECT_LT((first.position - Vector3d(0, 1, 1)).norm(), 1e-6);
  EXPECT_LT((last.position - Vector3d(1, 1, 0)).norm(), 1e-6) << "Z of the body points along X after a quarter turn";
  const auto body = [](double radians) { return Quaterniond(AngleAxisd(radians, Vector3d::UnitY())); };
  const auto head = [](double seconds) { return Quaterniond(AngleAxisd(turn_of(seconds), Vector3d::UnitX())); };
  EXPECT_EQ(middle.seconds, 0.5);
  EXPECT_LT(middle.rotation.angularDistance(body(std::numbers::pi / 4) * head(0.5)), 1e-6);
  EXPECT_LT(last.rotation.angularDistance(body(std::numbers::pi / 2) * head(1)), 1e-6);
}

TEST_F(ClipFileTest, RotationsCountFromTheNodesRest) {
  ClipDocument clip;  // a bone that lies along -Z at rest
  const auto askew = [](double seconds) { return std::numbers::pi / 2 + turn_of(seconds); };
  const auto rest = turns_about_x({0}, askew);
  clip.document["nodes"][0]["rotation"] = rest;
  clip.animate(0, "rotation", kTimes, turns_about_x(kTimes, askew));
  const auto read_back = read(clip);
  ASSERT_TRUE(read_back) << read_back.error().message;
  for (const NodeKey& key : read_back->keys) expect_turn(key.rotation, turn_of(key.seconds));
}

TEST_F(ClipFileTest, SplinesAndStepsAreReadAsLinesWithANote) {
  std::vector<float> spline;
  for (std::size_t i = 0; i < kWay.size(); i += 3) {
    spline.insert(spline.end(), {99, 99, 99, kWay[i], kWay[i + 1], kWay[i + 2], -99, -99, -99});
  }
  const auto steps = read(ClipDocument().animate(0, "translation", kTimes, kWay, "STEP"));
  const auto splines = read(ClipDocument().animate(0, "translation", kTimes, spline, "CUBICSPLINE"));
  for (const auto& read_back : {steps, splines}) {
    ASSERT_TRUE(read_back) << read_back.error().message;
    ASSERT_EQ(read_back->keys.size(), 3u);
    EXPECT_LT((read_back->keys[2].position - Vector3d(1, 2, 0)).norm(), 1e-6);
    ASSERT_EQ(read_back->notes.size(), 1u);
    EXPECT_NE(read_back->notes[0].find("translation of node 'head'"), std::string::npos) << read_back->notes[0];
  }
}

TEST_F(ClipFileTest, RotationsMayBeNormalizedIntegers) {
  // Two shorts in a float's place: (0, 0, 0, 1) and a half turn about X.
  const std::vector<std::int16_t> turns{0, 0, 0, 32767, 32767, 0, 0, 0};
  std::vector<float> packed(4);
  std::memcpy(packed.data(), turns.data(), sizeof turns[0] * turns.size());
  ClipDocument clip = ClipDocument().animate(0, "rotation", {0, 1}, packed);
  clip.document["accessors"][1].update({{"componentType", 5122}, {"normalized", true}, {"count", 2}});
  const auto read_back = read(clip);
  ASSERT_TRUE(read_back) << read_back.error().message;
  ASSERT_EQ(read_back->keys.size(), 2u);
  expect_turn(read_back->keys[0].rotation, 0);
  expect_turn(read_back->keys[1].rotation, std::numbers::pi);
}

TEST_F(ClipFileTest, KeysThatDifferByRoundingAreOne) {
  ClipDocument clip = nod();
  clip.animate(0, "translation", {0, 0.50001f, 1}, kWay);
  const auto read_back = read(clip);
  ASSERT_TRUE(read_back) << read_back.error().message;
  EXPECT_EQ(read_back->keys.size(), 3u);
}

TEST_F(ClipFileTest, OfTwoAnimationsTheFirstIsUsedWithANote) {
  ClipDocument clip = nod();
  json second = clip.document["animations"][0];
  second["name"] = "other";
  clip.document["animations"].push_back(second);
  const auto read_back = read(clip);
  ASSERT_TRUE(read_back) << read_back.error().message;
  ASSERT_EQ(read_back->notes.size(), 1u);
  EXPECT_NE(read_back->notes[0].find("'other' moves 'head' too"), std::string::npos) << read_back->notes[0];
}

TEST_F(ClipFileTest, RefusesAChoiceOfNodeThatIsNone) {
  expect_refused(ClipDocument(), "no animation moves a node");
  expect_refused(nod(), "no node 'tail'; animated are 'head'", "tail");
  ClipDocument clip = nod();
  clip.document["nodes"].push_back({{"name", "arm"}});
  expect_refused(clip, "node 'arm' does not move", "arm");
  clip.animate(1, "translation", kTimes, kWay);
  expect_refused(clip, "2 nodes are animated: 'head', 'arm'; name the head's, as in CLIP:NODE");
  clip.document["nodes"][1]["name"] = "head";
  expect_refused(clip, "2 nodes are called 'head'", "head");
}

TEST_F(ClipFileTest, RefusesKeysThatAreNoneWithTheirPlace) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const auto moved = [](const std::vector<float>& times, const std::vector<float>& way) {
    return ClipDocument().animate(0, "translation", times, way);
  };
  const std::string where = "animation 'clip', translation of node 'head': ";
  expect_refused(moved({0, nan, 1}, kWay), where + "key times: accessor 0 is not finite in element 1");
  expect_refused(moved({0, 1, infinity}, kWay), where + "key times: accessor 0 is not finite in element 2");
  expect_refused(moved(kTimes, {0, 0, 0, 0, nan, 0, 0, 0, 0}), where + "values: accessor 1 is not finite in element 1");
  expect_refused(moved({0, 1, 1}, kWay), where + "key times: has key 1 at 1 s and the next at 1 s");
  expect_refused(moved({0, 1, 0.5f}, kWay), where + "key times: has key 1 at 1 s and the next at 0.5 s");
  expect_refused(moved({-1, 0, 1}, kWay), where + "key times: begins at -1 s, before 0");
  expect_refused(moved({0, 1}, kWay), where + "3 values for 2 key times");
  expect_refused(ClipDocument().animate(0, "rotation", {0}, {0, 0, 0, 0}), "a rotation of length 0");
  expect_refused(ClipDocument().animate(0, "scale", kTimes, kWay), "scaled to nothing");
}

TEST_F(ClipFileTest, RefusesAccessorsBeyondTheirBytes) {
  const auto spoiled = [](const char* list, std::size_t index, const json& changes) {
    ClipDocument clip = nod();
    clip.document[list][index].update(changes);
    return clip;
  };
  expect_refused(spoiled("accessors", 1, {{"count", 4}}), "accessor 1 is cut off: 3 of 4 elements");
  expect_refused(spoiled("accessors", 1, {{"count", 100'000'000}}), "accessor 1 has no count of 1 to");
  expect_refused(spoiled("accessors", 0, {{"count", 0}}), "accessor 0 has no count of 1 to 100000");
  expect_refused(spoiled("accessors", 0, {{"count", -3}}), "accessor 0 has no count");
  expect_refused(spoiled("accessors", 0, {{"byteOffset", 13}}), "accessor 0 begins at byte 13 of a bufferView of 12");
  expect_refused(spoiled("accessors", 0, {{"byteOffset", 1e300}}), "accessor 0 has a byteOffset that is none");
  expect_refused(spoiled("accessors", 0, {{"bufferView", 7}}), "accessor 0 is in no bufferView of the 2");
  expect_refused(spoiled("accessors", 0, {{"type", "VEC3"}}), "accessor 0 is not of type SCALAR");
  expect_refused(spoiled("accessors", 0, {{"componentType", 5123}}), "neither floats nor normalized integers");
  expect_refused(spoiled("accessors", 0, {{"sparse", json::object()}}), "is sparse");
  expect_refused(spoiled("bufferViews", 1, {{"byteLength", 49}}), "ends at byte 61 of a buffer of 60");
  expect_refused(spoiled("bufferViews", 1, {{"byteOffset", 1 << 30}}), "of a buffer of 60");
  expect_refused(spoiled("bufferViews", 1, {{"byteStride", 8}}), "elements of 16 bytes that lie 8 apart");
  expect_refused(spoiled("bufferViews", 1, {{"byteStride", 20}}), "accessor 1 is cut off");
  expect_refused(spoiled("bufferViews", 1, {{"buffer", 1}}), "buffer 1 is not one of 1");
  expect_refused(spoiled("buffers", 0, {{"byteLength", 1000}}), "buffer 0 is cut off: 60 of 1000 bytes");
}

TEST_F(ClipFileTest, RefusesEveryTruncationOfABinaryFile) {
  const std::string whole = nod().glb();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read_back = read_clip(folder_.write("cut.glb", whole.substr(0, size)), "");
    ASSERT_FALSE(read_back) << size << " of " << whole.size() << " bytes";
    ASSERT_EQ(read_back.error().kind, Kind::kBadInput) << read_back.error().message;
  }
  EXPECT_TRUE(read_clip(folder_.write("whole.glb", whole), ""));
}

TEST_F(ClipFileTest, KeepsItsPromisesWhateverByteIsChanged) {
  const std::string whole = nod().animate(0, "translation", {0, 0.5f}, {0, 0, 0, 1, 1, 1}).glb();
  constexpr char kChanges[] = {'\x01', '\x10', '\x80', '\xFF'};
  std::size_t read = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = char(changed[at] ^ kChanges[at % 4]);
    const auto clip = read_clip(folder_.write("changed.glb", changed), "");
    if (!clip) continue;
    ++read;
    ASSERT_FALSE(clip->keys.empty());
    double last = -1;
    for (const NodeKey& key : clip->keys) {
      ASSERT_GT(key.seconds - last, 0.99e-4) << "byte " << at;
      ASSERT_TRUE(key.position.allFinite()) << "byte " << at;
      ASSERT_NEAR(key.rotation.norm(), 1, 1e-9) << "byte " << at;
      last = key.seconds;
    }
  }
  EXPECT_GT(read, 100u);
}

TEST_F(ClipFileTest, ReadsNoFilesOutsideItsFolder) {
  for (const char* uri : {"../clip.bin", "/dev/zero", "a/../../clip.bin", "file:///etc/passwd", "%2e%2e/clip.bin"}) {
    const auto read_back = read_clip(folder_.write("clip.gltf", nod().text_beside(uri)), "");
    ASSERT_FALSE(read_back) << uri;
    EXPECT_NE(read_back.error().message.find("not in this file's folder"), std::string::npos)
        << read_back.error().message;
  }
}

TEST_F(ClipFileTest, LoopsOfParentsEnd) {
  ClipDocument clip = nod();
  clip.document["nodes"][0]["children"] = {0};
  expect_refused(clip, "or its own parent");
}

TEST_F(ClipFileTest, OtherFormatsAndAbsentFilesAreRefusedAsSuch) {
  const auto other = read_clip(folder_.write("clip.fbx", "Kaydara"), "");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().kind, Kind::kUnsupported);
  EXPECT_NE(other.error().message.find("convert it to glTF"), std::string::npos);
  const auto absent = read_clip(folder_.path() / "none.glb", "");
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().kind, Kind::kFileAccess);
  const auto text = read_clip(folder_.write("text.gltf", "{\"nodes\": 3, \"animations\": [{\"channels\": [4]}]}"), "");
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().kind, Kind::kBadInput);
}

}  // namespace coif::importer::test::clip_file_test
