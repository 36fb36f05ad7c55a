// Which meshes of a file are levels of detail of one thing, and which of them is read.

#include "import/gltf_builder.h"
#include "import/imported_model.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace coif::importer::detail_levels_test {

using nlohmann::json;
using test::GltfBuilder;
using test::import_or_fail;
using test::TemporaryFolder;
using Names = std::vector<std::string>;

/// A strip of so many pairs of triangles, in one place whatever their number, and where it stands.
struct Strip {
  std::string name;
  int quads;
  std::array<float, 3> at{0, 0, 0};
};

class DetailLevels : public testing::Test {
 protected:
  SourceModel read(const std::vector<Strip>& strips, const Names& wanted = {}) const {
    GltfBuilder file;
    file.document["nodes"] = file.document["meshes"] = file.document["scenes"][0]["nodes"] = json::array();
    for (std::size_t i = 0; i < strips.size(); ++i) {
      file.document["meshes"].push_back(mesh_of(strips[i], file));
      file.document["nodes"].push_back({{"name", strips[i].name}, {"mesh", i}, {"translation", strips[i].at}});
      file.document["scenes"][0]["nodes"].push_back(i);
    }
    ImportSettings settings;
    settings.meshes = wanted;
    return import_or_fail(file.write(folder_), settings);
  }
  Names kept(const std::vector<Strip>& strips, const Names& wanted = {}) const {
    Names names;
    for (const SourceMesh& mesh : read(strips, wanted).meshes) names.push_back(mesh.name);
    return names;
  }

 private:
  static json mesh_of(const Strip& strip, GltfBuilder& file) {
    std::vector<float> places, corners;
    for (int row = 0; row <= strip.quads; ++row) {
      const float y = 2.0f * float(row) / float(strip.quads), first = float(2 * row);
      places.insert(places.end(), {0, y, 0, 1, y, 0.1f * y});
      if (row < strip.quads)
        corners.insert(corners.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
    }
    const std::size_t position = file.add_places(places);
    const std::size_t indices = file.add(corners, "SCALAR", {.component = 5123});
    return {{"name", strip.name}, {"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", indices}}}}};
  }

  TemporaryFolder folder_;
};

TEST_F(DetailLevels, GoByTheLettersLodWhereverTheyLie) {
  EXPECT_EQ(kept({{"Hair_LOD0", 8}, {"Hair_LOD1", 4, {3, 0, 0}}, {"Head", 2}}), (Names{"Hair_LOD0", "Head"}));
  EXPECT_EQ(kept({{"Hair", 8}, {"Hair_LOD1", 4}}), (Names{"Hair"}));
  EXPECT_EQ(kept({{"hair.lod0", 8}, {"hair.lod1", 4}}), (Names{"hair.lod0"}));
  EXPECT_EQ(kept({{"Hair_lod_00", 8}, {"Hair_lod_01", 4}}), (Names{"Hair_lod_00"}));
  EXPECT_EQ(kept({{"LOD0_Hair", 8}, {"LOD1_Hair.001", 4}, {"LOD1_Fringe", 2}}), (Names{"LOD0_Hair", "LOD1_Fringe"}))
      << "a fringe that is there once is left";
}

TEST_F(DetailLevels, OfWhichTrianglesTellTheFinest) {
  EXPECT_EQ(kept({{"Hair_LOD0", 2}, {"Hair_LOD1", 4}, {"Hair_LOD2", 8}}), (Names{"Hair_LOD2"})) << "0 is the coarsest";
  EXPECT_EQ(kept({{"Hair", 9}, {"Hair_LOD0", 2}, {"Hair_LOD1", 4}}), (Names{"Hair"}));
  EXPECT_EQ(kept({{"Hair_LOD100", 8}, {"Hair_LOD50", 4}}), (Names{"Hair_LOD100"})) << "percent";
  EXPECT_EQ(kept({{"Hair", 9, {3, 0, 0}}, {"Hair_LOD0", 8}, {"Hair_LOD1", 4}}), (Names{"Hair", "Hair_LOD0"}))
      << "another part of the hair";
}

TEST_F(DetailLevels, GoByTheLetterLWhereShapesAreOne) {
  const SourceModel model = read({{"Hair_L0", 8}, {"Hair_L1", 4}, {"Hair_L2", 2}});
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].name, "Hair_L0");
  EXPECT_TRUE(test::warns(model, "of 'Hair_L0': 'Hair_L1', 'Hair_L2'")) << test::warnings_of(model);
  EXPECT_TRUE(test::warns(model, "\"hair.meshes\""));
  EXPECT_EQ(kept({{"Hair", 8}, {"Hair_L1", 4}}), (Names{"Hair"}));
  EXPECT_EQ(kept({{"HairL1", 8}, {"HairL2", 4}}), (Names{"HairL1"}));
}

TEST_F(DetailLevels, AreNotLocksOfTheLeftSide) {
  const std::vector<std::vector<Strip>> sides{{{"Hair_L", 8}, {"Hair_R", 4, {3, 0, 0}}},
                                              {{"Lock_L1", 8}, {"Lock_L2", 4, {0.5f, 0, 0}}},
                                              {{"Lock_L1", 8}, {"Lock_L2", 4}, {"Lock_R1", 8, {3, 0, 0}}},
                                              {{"Lock_L1", 8}, {"Lock_L2", 4}, {"Lock_R", 8, {3, 0, 0}}},
                                              {{"Lock_L1", 8}, {"Lock_L2", 8}},
                                              {{"Lock_L1", 4}, {"Lock_L2", 8}},
                                              {{"Curl1", 8}, {"Curl2", 4}},
                                              {{"Hair_Long1", 8}, {"Hair_Long2", 4}}};
  for (const std::vector<Strip>& strips : sides) {
    const SourceModel model = read(strips);
    EXPECT_EQ(model.meshes.size(), strips.size()) << strips[1].name;
    EXPECT_TRUE(model.warnings.empty()) << test::warnings_of(model);
  }
}

TEST_F(DetailLevels, MayBeChosenByTheirNames) {
  const std::vector<Strip> levels{{"Hair_LOD0", 8}, {"Hair_LOD1", 4}, {"Hair_LOD2", 2}};
  EXPECT_EQ(kept(levels, {"hair_lod1"}), (Names{"Hair_LOD1"}));
  EXPECT_TRUE(read(levels, {"Hair_LOD1"}).warnings.empty()) << "who chooses knows of the others";
  EXPECT_EQ(kept(levels, {"Hair*"}), (Names{"Hair_LOD0"})) << "the finest of those that match";
  EXPECT_EQ(kept(levels, {"*1", "*2"}), (Names{"Hair_LOD1"}));
  EXPECT_EQ(kept(levels, {"Hair_LOD0", "Hair_LOD2"}), (Names{"Hair_LOD0", "Hair_LOD2"})) << "both, as it says";
  EXPECT_EQ(kept(levels, {"Head"}), (Names{"Hair_LOD0"}));
}

}  // namespace coif::importer::detail_levels_test
