#include "import/reader_process.h"

#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace coif::importer::model_stream_test {

using Bytes = std::vector<std::uint8_t>;
using test::small_source_model;

TEST(ModelStream, ModelComesBackAsItWas) {
  ImportOutcome back;
  const Bytes bytes = encode_outcome(small_source_model());
  ASSERT_TRUE(decode_outcome(bytes, back));
  ASSERT_TRUE(back);
  EXPECT_EQ(encode_outcome(back), bytes);
  EXPECT_EQ(back->meshes[0].influences[2].weight, 0.75f);
  EXPECT_EQ(back->nodes[1].model_from_node.translation().y(), 1.0);
  EXPECT_EQ(back->materials[0].alpha_use, AlphaUse::kMask);
  EXPECT_EQ(back->materials[0].alpha_cutoff, 0.25f);
  EXPECT_EQ(back->materials[0].normal_strength, 0.5f);
  EXPECT_EQ(back->meshes[0].colors[2].y(), 0.5f);
  EXPECT_EQ(back->materials[0].base_texture.wrap[0], TextureWrap::kRepeat);
  EXPECT_EQ(back->materials[0].base_texture.wrap[1], TextureWrap::kMirror);
  EXPECT_EQ(back->materials[0].opacity_texture.path, "hair_a.png");
  EXPECT_EQ(back->materials[0].opacity_channel, TextureChannel::kGreen);
  EXPECT_TRUE(back->materials[0].opacity_inverted);
  EXPECT_EQ(back->springs[0].joints[0].length, 1.0);
  EXPECT_EQ(back->springs[0].colliders, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(back->colliders[1].radius, 0.5);
  EXPECT_EQ(back->head_node, 1u);
  EXPECT_EQ(back->facing, Facing::kBackwards);
  EXPECT_EQ(back->materials[0].other_textures, std::vector<std::string>{"gloss map"});
  EXPECT_EQ(messages_of(back->warnings), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(back->warnings[1].code, "S115");
  EXPECT_EQ(back->side_files, (std::vector<std::string>{"strip.bin"}));
}

TEST(ModelStream, WholeModelsKeepWhatNoReaderMakes) {
  SourceModel model = small_source_model();
  model.roots = {"/textures", "elsewhere"};
  model.made_from_strands = true;
  model.scalp_radius = 0.125;
  const SourceMesh& mesh = model.meshes[0];
  model.coarser.push_back({mesh,
                           {mesh.positions.size(), Eigen::Vector3f(0, -1, 0)},
                           std::vector<float>(mesh.positions.size(), 0.5f),
                           std::vector<std::uint32_t>(mesh.triangles.size() / 3, 0)});
  const Bytes bytes = encode_model(model);
  ImportOutcome back;
  ASSERT_TRUE(decode_model(bytes, back));
  ASSERT_TRUE(back);
  EXPECT_EQ(encode_model(back), bytes);
  EXPECT_EQ(encode_outcome(back), encode_outcome(model));
  EXPECT_EQ(back->roots, model.roots);
  EXPECT_TRUE(back->made_from_strands);
  EXPECT_EQ(back->scalp_radius, 0.125);
  ASSERT_EQ(back->coarser.size(), 1u);
  EXPECT_EQ(back->coarser[0].along[0].y(), -1);
  EXPECT_EQ(back->coarser[0].strip_of, model.coarser[0].strip_of);
  EXPECT_FALSE(decode_model(encode_outcome(model), back)) << "another form";
  EXPECT_FALSE(decode_outcome(bytes, back)) << "which readers are not believed in";
}

TEST(ModelStream, ErrorComesBackAsItWas) {
  ImportOutcome back;
  const ImportOutcome error = tl::unexpected(ToolError{ToolError::Kind::kBadInput, "x.obj: broken"});
  ASSERT_TRUE(decode_outcome(encode_outcome(error), back));
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().kind, ToolError::Kind::kBadInput);
  EXPECT_EQ(back.error().message, "x.obj: broken");
}

TEST(ModelStream, DecodeRefusesEveryTruncation) {
  for (const ImportOutcome& outcome :
       {ImportOutcome(small_source_model()), ImportOutcome(tl::unexpected(ToolError{ToolError::Kind::kUsage, "no"}))}) {
    const Bytes whole = encode_outcome(outcome);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      ImportOutcome back;
      EXPECT_FALSE(decode_outcome(cut, back)) << size << " of " << whole.size();
    }
  }
}

TEST(ModelStream, DecodeRefusesBytesAfterTheEnd) {
  Bytes bytes = encode_outcome(small_source_model());
  bytes.push_back(0);
  ImportOutcome back;
  EXPECT_FALSE(decode_outcome(bytes, back));
}

TEST(ModelStream, EveryFlippedBitGivesNothingOrAFaultlessModel) {
  const Bytes good = encode_outcome(small_source_model());
  std::size_t refused = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes bytes = good;
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 << bit));
      ImportOutcome back;
      if (!decode_outcome(bytes, back)) {
        ++refused;
      } else if (back) {
        EXPECT_EQ(find_model_fault(*back), "") << "byte " << at << " bit " << bit;
      }
    }
  }
  EXPECT_GT(refused, good.size());  // far more than the lengths and indices alone
}

TEST(ModelStream, DecodeRefusesCountsThatTheBytesCannotHold) {
  const Bytes good = encode_outcome(ImportOutcome(tl::unexpected(ToolError{ToolError::Kind::kUsage, "no"})));
  constexpr std::size_t kCountAt = 6;  // after magic, kind of outcome and kind of error
  for (const std::uint64_t count : {std::uint64_t{3}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    Bytes bytes = good;
    std::memcpy(bytes.data() + kCountAt, &count, sizeof count);
    ImportOutcome back;
    EXPECT_FALSE(decode_outcome(bytes, back)) << count;
  }
}

using Break = void (*)(SourceModel&);
class BrokenPromise : public testing::TestWithParam<Break> {};

TEST_P(BrokenPromise, IsFoundAndRefused) {
  SourceModel model = small_source_model();
  ASSERT_EQ(find_model_fault(model), "");
  GetParam()(model);
  EXPECT_NE(find_model_fault(model), "");
  ImportOutcome back;
  EXPECT_FALSE(decode_outcome(encode_outcome(model), back));
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Model, BrokenPromise,
    testing::Values<Break>(
        [](SourceModel& m) { m.nodes[1].parent = 1; },
        [](SourceModel& m) { m.nodes[0].model_from_node(0, 0) = std::numeric_limits<double>::infinity(); },
        [](SourceModel& m) { m.meshes.clear(); }, [](SourceModel& m) { m.meshes[0].node = 2; },
        [](SourceModel& m) { m.meshes[0].material = 1; }, [](SourceModel& m) { m.meshes[0].triangles[2] = 3; },
        [](SourceModel& m) { m.meshes[0].triangles.pop_back(); },
        [](SourceModel& m) { m.meshes[0].positions[1].x() = kNan; },
        [](SourceModel& m) {
          m.meshes[0].normals[1] = {0, 0, 2};
        },
        [](SourceModel& m) { m.meshes[0].normals.pop_back(); }, [](SourceModel& m) { m.meshes[0].uvs[1].y() = kNan; },
        [](SourceModel& m) { m.meshes[0].uvs.pop_back(); }, [](SourceModel& m) { m.meshes[0].colors.pop_back(); },
        [](SourceModel& m) { m.meshes[0].colors[1].w() = kNan; },
        [](SourceModel& m) { m.meshes[0].colors[1].w() = -1; },
        [](SourceModel& m) { m.materials[0].opacity_texture.image = 1; },
        [](SourceModel& m) {
          m.meshes[0].influence_begin = {0, 2, 1, 4};
        },
        [](SourceModel& m) { m.meshes[0].influence_begin.back() = 5; },
        [](SourceModel& m) { m.meshes[0].influences[0].node = 2; },
        [](SourceModel& m) { m.meshes[0].influences[0].weight = kNan; },
        [](SourceModel& m) { m.meshes[0].influences[3].weight = 0.5f; },
        [](SourceModel& m) { m.materials[0].base_texture.image = 1; },
        [](SourceModel& m) { m.materials[0].base_color.x() = kNan; },
        [](SourceModel& m) { m.materials[0].normal_strength = kNan; },
        [](SourceModel& m) { m.materials[0].normal_strength = -1; },
        [](SourceModel& m) { m.materials[0].normal_strength = 17; },
        [](SourceModel& m) { m.materials[0].alpha_cutoff = 2; }));

INSTANTIATE_TEST_SUITE_P(
    Springs, BrokenPromise,
    testing::Values<Break>([](SourceModel& m) { m.head_node = 2; }, [](SourceModel& m) { m.colliders[0].node = 2; },
                           [](SourceModel& m) { m.colliders[0].radius = -1; },
                           [](SourceModel& m) { m.colliders[0].radius = double{kNan}; },
                           [](SourceModel& m) { m.colliders[0].tail.x() = double{kNan}; },
                           [](SourceModel& m) { m.colliders[0].normal.setZero(); },
                           [](SourceModel& m) { m.colliders.resize(kMaxSourceColliders + 1); },
                           [](SourceModel& m) { m.springs[0].joints.clear(); },
                           [](SourceModel& m) { m.springs[0].joints[0].node = 2; },
                           [](SourceModel& m) { m.springs[0].joints[1].node = 0; },
                           [](SourceModel& m) { std::swap(m.springs[0].joints[0].node, m.springs[0].joints[1].node); },
                           [](SourceModel& m) { m.springs[0].joints[0].drag = 1.5; },
                           [](SourceModel& m) { m.springs[0].joints[0].stiffness = -1; },
                           [](SourceModel& m) { m.springs[0].joints[0].length = -1; },
                           [](SourceModel& m) { m.springs[0].joints[0].hit_radius = -1; },
                           [](SourceModel& m) { m.springs[0].joints[0].gravity_power = double{kNan}; },
                           [](SourceModel& m) { m.springs[0].joints[0].gravity_direction *= 2; },
                           [](SourceModel& m) { m.springs[0].center = 2; },
                           [](SourceModel& m) { m.springs[0].colliders = {2}; },
                           [](SourceModel& m) {
                             m.springs[0].colliders = {1, 0};
                           },
                           [](SourceModel& m) { m.springs.push_back(m.springs[0]); }));

}  // namespace coif::importer::model_stream_test
