// What the records of an FBX say of models, levels of detail and shape keys.

#include "import/fbx_objects.h"
#include "import/fbx_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace coif::importer::fbx_objects_test {

// Two deformers, channels and shapes, each connected to all: more shapes than the file has connections.
TEST(FbxObjectsOf, ShapesConnectedCrosswiseAreLeftOut) {
  std::string objects = "Geometry: 1, \"Geometry::\", \"Mesh\" {\n}\n", connections;
  for (int i = 0; i < 100; ++i) {
    objects += fmt::format(
        "Deformer: {}, \"\", \"BlendShape\" {{\n}}\nDeformer: {}, \"\", \"BlendShapeChannel\" {{\n}}\nGeometry: {}, "
        "\"\", \"Shape\" {{\n}}\n",
        100 + i, 200 + i, 300 + i);
    connections += fmt::format("C: \"OO\",{},1\n", 100 + i);
    for (int k = 0; k < 100; ++k)
      connections += fmt::format("C: \"OO\",{},{}\nC: \"OO\",{},{}\n", 200 + k, 100 + i, 300 + k, 200 + i);
  }
  const std::string file = "Objects: {\n" + objects + "}\nConnections: {\n" + connections + "}\n";
  const auto read = FbxObjects::read(file);
  ASSERT_TRUE(read);
  ASSERT_NE(read->find(1), nullptr);
  EXPECT_TRUE(read->shapes(*read->find(1)).empty());
}

TEST(FbxObjectsOf, BinaryFilesSayTheSame) {
  for (const std::uint32_t version : {7400u, 7500u}) {
    const std::string file = test::small_binary_fbx(version);
    const auto read = FbxObjects::read(file);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->find(1)->name, "Hair");
    EXPECT_FALSE(read->find(1)->is_visible);
    EXPECT_TRUE(read->find(1)->is_lod_group);
    const auto shapes = read->shapes(*read->find(2));
    ASSERT_EQ(shapes.size(), 2u);
    EXPECT_EQ(shapes[0].key, "Long");
    EXPECT_DOUBLE_EQ(shapes[0].key_weight, 0.5);
    EXPECT_DOUBLE_EQ(shapes[0].weight, 0.5);
    EXPECT_DOUBLE_EQ(shapes[1].weight, 0.5);
  }
}

TEST(FbxObjectsOf, OfObjectsWithOneIdTheLastCounts) {
  const auto read =
      FbxObjects::read("Objects: {\nModel: 1, \"Model::a\", \"Mesh\" {\n}\nModel: 1, \"Model::b\", \"Mesh\" {\n}\n}\n");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->find(1)->name, "b");
}

TEST(FbxObjectsOf, AGroupMayBeToldByItsAttributeAlone) {
  const auto read = FbxObjects::read(R"(Objects: {
  Model: 1, "Model::group", "Null" {
  }
  NodeAttribute: 2, "NodeAttribute::group", "LodGroup" {
  }
}
Connections: {
  C: "OO",2,1
  C: "OO",1,0
})");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->find(1)->is_lod_group);
  ASSERT_EQ(read->below(0).size(), 1u);
  EXPECT_EQ(read->below(0)[0].from, 1);
}

TEST(FbxObjectsOf, ValuesOfTheWrongKindAreLeftOut) {
  const auto read = FbxObjects::read(R"(Objects: {
  Model: "1", "Model::a", "Mesh" {
  }
  Model: 2
  Model: 3, "Model::b", "Mesh" {
    Properties70: {
      P: "Visibility", "Visibility", "", "A","0"
      P: "Visibility"
    }
  }
  Deformer: 4, "", "BlendShapeChannel" {
    DeformPercent: 1e999
    FullWeights: "a"
  }
}
Connections: {
  C: "OO","3",0
  C: "OO"
  C: "OP",3,0,"LookAtProperty"
})");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->find(2), nullptr);
  EXPECT_TRUE(read->find(3)->is_visible);
  EXPECT_EQ(read->find(4)->percent, 0);
  EXPECT_TRUE(read->below(0).empty());
}

}  // namespace coif::importer::fbx_objects_test
