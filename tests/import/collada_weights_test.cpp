// Weights of bones that a COLLADA document gets wrong.

#include "import/imported_model.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace coif::importer::collada_weights_test {

using test::import_or_fail;
using test::TemporaryFolder;
using test::warnings_of;
using test::warns;

/// A triangle whose corners are held by two bones; `weights` are six numbers, two for each corner.
std::string document(const std::string& weights) {
  const std::string joints =
      R"(<source id="j"><Name_array id="j-n" count="2">one two</Name_array><technique_common><accessor source="#j-n" count="2" stride="1"><param name="JOINT" type="name"/></accessor></technique_common></source>
<source id="i"><float_array id="i-n" count="32">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array><technique_common><accessor source="#i-n" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>)";
  return fmt::format(R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="p-n" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source="#p-n" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_controllers><controller id="skin"><skin source="#g">{}
<source id="w"><float_array id="w-n" count="6">{}</float_array><technique_common><accessor source="#w-n" count="6" stride="1"><param name="WEIGHT" type="float"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#i"/></joints>
<vertex_weights count="3"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" offset="1"/><vcount>2 2 2</vcount><v>0 0 1 1 0 2 1 3 0 4 1 5</v></vertex_weights></skin></controller></library_controllers>
<library_visual_scenes><visual_scene id="s"><node id="one" sid="one" type="JOINT"/><node id="two" sid="two" type="JOINT"/><node id="n"><instance_controller url="#skin"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)",
                     joints, weights);
}

SourceModel model_with(const std::string& weights) {
  const TemporaryFolder folder;
  return import_or_fail(folder.write("m.dae", document(weights)));
}

TEST(ColladaWeights, ThatAddUpToOneSayNothing) {
  const SourceModel model = model_with("0.25 0.75 1 0 0.5 0.5");
  ASSERT_EQ(model.meshes.at(0).influence_begin.back(), 5u);
  EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST(ColladaWeights, ThatDoNotAddUpToOneAreScaledAndTold) {
  const SourceModel model = model_with("0.25 0.75 0.3 0.1 2 2");
  const SourceMesh& mesh = model.meshes.at(0);
  EXPECT_FLOAT_EQ(mesh.influences.at(mesh.influence_begin[1]).weight, 0.75f);
  EXPECT_TRUE(warns(model, "the weights of 2 vertices do not add up to 1 (of vertex 1 to 0.4)")) << warnings_of(model);
}

TEST(ColladaWeights, BelowZeroAndNotFiniteAreDroppedAndTold) {
  const SourceModel model = model_with("1 -0.5 NaN 1 0.5 0.5");
  EXPECT_EQ(model.meshes.at(0).influence_begin.back(), 4u);
  EXPECT_TRUE(warns(model, "2 bone weights below zero or not finite dropped")) << warnings_of(model);
  EXPECT_FALSE(warns(model, "do not add up")) << warnings_of(model);
}

}  // namespace coif::importer::collada_weights_test
