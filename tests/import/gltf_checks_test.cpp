#include "import/gltf_scene.h"

#include "import/model_files.h"

#include <limits>
#include <set>

namespace coif::importer::gltf_checks_test {

using test::SmallGltf;
using test::TemporaryFolder;
using Codes = std::set<std::string>;

Codes codes_of(const Diagnostics& faults) {
  Codes codes;
  for (const Diagnostic& fault : faults) codes.insert(fault.code);
  return codes;
}

/// What a file says beside its lack of bounds, which SmallGltf does not write.
Codes codes_of(const SmallGltf& model) {
  const TemporaryFolder folder;
  Codes codes = codes_of(check_gltf(model.write(folder, "small.gltf")));
  codes.erase("S117");
  return codes;
}

SmallGltf skinned() {
  SmallGltf model;
  model.joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
  model.weights = {0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0, 0.25f, 0.75f, 0, 0};
  model.nodes = R"([{"name": "strip", "mesh": 0, "skin": 0}, {"name": "a"}, {"name": "b"}])";
  model.roots = "[0, 1, 2]";
  model.skin_joints = "[1, 2]";
  return model;
}

TEST(GltfChecks, SoundFilesHaveNothing) {
  EXPECT_EQ(codes_of(SmallGltf()), Codes{});
  EXPECT_EQ(codes_of(skinned()), Codes{});
}

TEST(GltfChecks, IndicesOfNoVertexAndTheRestartNumber) {
  SmallGltf model;
  model.indices = {0, 1, 3};
  EXPECT_EQ(codes_of(model), Codes{"S112"});
  model.indices = {0, 1, 65535};
  EXPECT_EQ(codes_of(model), Codes{"S112"});
}

TEST(GltfChecks, NumbersThatAreNone) {
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    SmallGltf model;
    model.positions[4] = odd;
    EXPECT_EQ(codes_of(model), Codes{"S113"});
    model = SmallGltf();
    model.uvs[1] = odd;
    EXPECT_EQ(codes_of(model), Codes{"S113"});
  }
}

TEST(GltfChecks, NormalsOfAnotherLength) {
  SmallGltf model;
  model.normals[2] = 0;
  EXPECT_EQ(codes_of(model), Codes{"S116"});
  model.normals[2] = 1.02f;
  EXPECT_EQ(codes_of(model), Codes{"S116"});
  model.normals[2] = 1.005f;
  EXPECT_EQ(codes_of(model), Codes{}) << "rounding of a byte";
}

TEST(GltfChecks, JointsTwiceOrNotOfTheSkin) {
  SmallGltf model = skinned();
  model.joints[1] = 0;
  EXPECT_EQ(codes_of(model), Codes{"S114"});
  model.weights[0] = 1, model.weights[1] = 0;
  EXPECT_EQ(codes_of(model), Codes{}) << "a joint without weight is none";
  model.joints[3] = 2;
  EXPECT_EQ(codes_of(model), Codes{"S114"}) << "... but has to be there";
}

TEST(GltfChecks, WeightsThatDoNotAddUp) {
  SmallGltf model = skinned();
  model.weights[0] = 0.25f;
  EXPECT_EQ(codes_of(model), Codes{"S115"});
  model.weights[0] = 0.5001f;
  EXPECT_EQ(codes_of(model), Codes{}) << "rounding";
  model.weights[2] = -2.0e-16f;
  EXPECT_EQ(codes_of(model), Codes{}) << "what a subtraction leaves";
  model.weights = {1.5f, -0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  EXPECT_EQ(codes_of(model), Codes{"S115"});
}

TEST(GltfChecks, ReferencesToNothing) {
  SmallGltf model;
  model.roots = "[7]";
  EXPECT_EQ(codes_of(model), Codes{"S111"});
  model = SmallGltf();
  model.nodes = R"([{"mesh": 0, "children": [0]}])";
  EXPECT_TRUE(codes_of(model).contains("S111"));
  model.nodes = R"([{"mesh": 0, "rotation": [0, 0, 0, 2]}])";
  EXPECT_EQ(codes_of(model), Codes{"S116"});
}

TEST(GltfChecks, FaultsOfOneKindGiveAFewSentences) {
  SmallGltf model;
  model.nodes = "[";
  for (int i = 0; i < 500; ++i) model.nodes += R"({"mesh": 9},)";
  model.nodes += R"({"mesh": 0}])";
  const TemporaryFolder folder;
  const auto faults = check_gltf(model.write(folder, "many.gltf"));
  EXPECT_LT(faults.size(), 10u);
  const auto of_nodes = std::ranges::find_if(faults, [](const Diagnostic& fault) {
    return fault.message.find("the same in 497 more places") != std::string::npos;
  });
  EXPECT_NE(of_nodes, faults.end()) << faults.front().message;
}

TEST(GltfChecks, WhatIsNoJsonIsAFault) {
  const TemporaryFolder folder;
  EXPECT_EQ(codes_of(check_gltf(folder.write("a.gltf", "{\"asset\": "))), Codes{"S111"});
  EXPECT_EQ(codes_of(check_gltf(folder.write("b.gltf", "[1]"))), Codes{"S111"});
}

}  // namespace coif::importer::gltf_checks_test
