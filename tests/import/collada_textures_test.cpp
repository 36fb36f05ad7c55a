// Which coordinates a COLLADA document's textures are looked up at, and how they go on outside 0..1.

#include "import/import.h"
#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace coif::importer::collada_textures_test {

using test::import_or_fail;
using test::TemporaryFolder;
using test::warnings_of;

/// What a document of one triangle varies. Its corners have (0.1, 0.1) in the UV array "a" and (0.7, 0.7) in "b".
struct Parts {
  std::string inputs =
      R"(<input semantic="TEXCOORD" source="#a" offset="1" set="0"/><input semantic="TEXCOORD" source="#b" offset="1" set="1"/>)";
  std::string binding = R"(<bind_vertex_input semantic="HairUV" input_semantic="TEXCOORD" input_set="1"/>)";
  std::string sampler;
  std::string opacity_texcoord = "HairUV";
  bool is_skinned = false;
};

std::string array(const char* id, int count, int width, const std::string& numbers) {
  const std::string params =
      width == 3 ? R"(<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>)"
                 : R"(<param name="S" type="float"/><param name="T" type="float"/>)";
  return fmt::format(
      R"(<source id="{0}"><float_array id="{0}-n" count="{1}">{3}</float_array><technique_common><accessor source="#{0}-n" count="{4}" stride="{2}">{5}</accessor></technique_common></source>)",
      id, count * width, width, numbers, count, params);
}

std::string controllers(bool is_skinned) {
  if (!is_skinned) return "";
  return R"(<library_controllers><controller id="skin"><skin source="#g"><source id="j"><Name_array id="j-n" count="1">bone</Name_array><technique_common><accessor source="#j-n" count="1" stride="1"><param name="JOINT" type="name"/></accessor></technique_common></source>
<source id="i"><float_array id="i-n" count="16">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array><technique_common><accessor source="#i-n" count="1" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>
<source id="w"><float_array id="w-n" count="1">1</float_array><technique_common><accessor source="#w-n" count="1" stride="1"><param name="WEIGHT" type="float"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#i"/></joints>
<vertex_weights count="3"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" offset="1"/><vcount>1 1 1</vcount><v>0 0 0 0 0 0</v></vertex_weights></skin></controller></library_controllers>)";
}

std::string document(const Parts& parts) {
  const std::string instance = parts.is_skinned ? "instance_controller url=\"#skin\"" : "instance_geometry url=\"#g\"";
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_images><image id="c"><init_from>c.png</init_from></image><image id="o"><init_from>o.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="cs"><surface type="2D"><init_from>c</init_from></surface></newparam>
<newparam sid="ct"><sampler2D><source>cs</source>)" +
         parts.sampler + R"(</sampler2D></newparam>
<newparam sid="os"><surface type="2D"><init_from>o</init_from></surface></newparam>
<newparam sid="ot"><sampler2D><source>os</source></sampler2D></newparam>
<technique sid="t"><lambert><diffuse><texture texture="ct" texcoord="HairUV"/></diffuse><transparent><texture texture="ot" texcoord=")" +
         parts.opacity_texcoord + R"("/></transparent></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="Hair"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>)" +
         array("p", 3, 3, "0 0 0 1 0 0 0 1 0") + array("a", 3, 2, "0.1 0.1 0.1 0.1 0.1 0.1") +
         array("b", 3, 2, "0.7 0.7 0.7 0.7 0.7 0.7") +
         R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/>)" +
         parts.inputs + R"(<p>0 0 1 1 2 2</p></triangles></mesh></geometry></library_geometries>)" +
         controllers(parts.is_skinned) + R"(
<library_visual_scenes><visual_scene id="s"><node id="bone" sid="bone" type="JOINT"/><node id="n"><)" +
         instance + R"(><bind_material><technique_common><instance_material symbol="s" target="#m">)" + parts.binding +
         R"(</instance_material></technique_common></bind_material></)" + instance.substr(0, instance.find(' ')) +
         R"(></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

class ColladaTexturesTest : public testing::Test {
 protected:
  SourceModel model_of(const Parts& parts) { return import_or_fail(folder_.write("m.dae", document(parts))); }
  float u_of(const Parts& parts) { return model_of(parts).meshes.at(0).uvs.at(0).x(); }
  TemporaryFolder folder_;
};

TEST_F(ColladaTexturesTest, ATextureIsLookedUpAtTheSetThatItsCoordinatesAreBoundTo) {
  Parts parts;
  EXPECT_FLOAT_EQ(u_of(parts), 0.7f);
  EXPECT_TRUE(model_of(parts).warnings.empty()) << warnings_of(model_of(parts));
  parts.binding = R"(<bind_vertex_input semantic="Other" input_semantic="TEXCOORD" input_set="1"/>
<bind_vertex_input semantic="HairUV" input_semantic="TEXCOORD" input_set="0"/>)";
  parts.opacity_texcoord = "HairUV";
  EXPECT_FLOAT_EQ(u_of(parts), 0.1f);
}

TEST_F(ColladaTexturesTest, ASkinnedMeshHasTheSetOfItsGeometry) {
  Parts parts;
  parts.is_skinned = true;
  const SourceModel model = model_of(parts);
  ASSERT_FALSE(model.meshes.at(0).influences.empty()) << warnings_of(model);
  EXPECT_FLOAT_EQ(model.meshes[0].uvs.at(0).x(), 0.7f);
}

TEST_F(ColladaTexturesTest, NumbersOfSetsMayHaveGaps) {
  Parts parts;
  parts.inputs =
      R"(<input semantic="TEXCOORD" source="#a" offset="1" set="2"/><input semantic="TEXCOORD" source="#b" offset="1" set="5"/>)";
  parts.binding = R"(<bind_vertex_input semantic="HairUV" input_semantic="TEXCOORD" input_set="5"/>)";
  EXPECT_FLOAT_EQ(u_of(parts), 0.7f);
  parts.binding = R"(<bind_vertex_input semantic="HairUV" input_semantic="TEXCOORD" input_set="2"/>)";
  EXPECT_FLOAT_EQ(u_of(parts), 0.1f);
}

TEST_F(ColladaTexturesTest, WithoutABindingTheFirstSetIsTaken) {
  Parts parts;
  for (const char* const binding :
       {"", R"(<bind_vertex_input semantic="HairUV" input_semantic="TEXCOORD" input_set="9"/>)",
        R"(<bind_vertex_input semantic="HairUV" input_semantic="NORMAL" input_set="1"/>)"}) {
    parts.binding = binding;
    EXPECT_FLOAT_EQ(u_of(parts), 0.1f) << binding;
  }
}

TEST_F(ColladaTexturesTest, OpacityAtAnotherSetThanTheColourIsTold) {
  Parts parts;
  parts.binding += R"(<bind_vertex_input semantic="Mask" input_semantic="TEXCOORD" input_set="0"/>)";
  parts.opacity_texcoord = "Mask";
  const SourceModel model = model_of(parts);
  EXPECT_FLOAT_EQ(model.meshes.at(0).uvs.at(0).x(), 0.7f);
  EXPECT_TRUE(test::warns(model, "its opacity texture has other texture coordinates")) << warnings_of(model);
}

TEST_F(ColladaTexturesTest, ASamplerSaysHowItsTextureGoesOn) {
  Parts parts;
  const auto wraps = [&](const char* sampler) {
    parts.sampler = sampler;
    const SourceModel model = model_of(parts);
    const SourceMaterial& material = model.materials.at(model.meshes.at(0).material);
    EXPECT_EQ(material.opacity_texture.wrap[0], TextureWrap::kRepeat) << "has a sampler of its own";
    return std::pair(material.base_texture.wrap[0], material.base_texture.wrap[1]);
  };
  EXPECT_EQ(wraps(""), std::pair(TextureWrap::kRepeat, TextureWrap::kRepeat));
  EXPECT_EQ(wraps("<wrap_s>CLAMP</wrap_s><wrap_t>MIRROR</wrap_t>"),
            std::pair(TextureWrap::kClamp, TextureWrap::kMirror));
  EXPECT_EQ(wraps("<wrap_s>WRAP</wrap_s><wrap_t>BORDER</wrap_t>"),
            std::pair(TextureWrap::kRepeat, TextureWrap::kClamp));
}

// The texture names "HairUV", the second of the hair's maps; Blender's glTF of the scene has the same.
std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

TEST_F(ColladaTexturesTest, SamplersOfVersion15NameTheirImage) {
  std::string text = document({.sampler = "<wrap_s>CLAMP</wrap_s>"});
  text = replaced(text, "2005/11/COLLADASchema\" version=\"1.4.1\"", "2008/03/COLLADASchema\" version=\"1.5.0\"");
  text = replaced(text, "<init_from>c.png</init_from>", "<init_from><ref>c.png</ref></init_from>");
  text = replaced(text, "<init_from>o.png</init_from>", "<init_from><ref>o.png</ref></init_from>");
  text = replaced(text, "<source>cs</source>", "<instance_image url=\"#c\"/>");
  text = replaced(text, "<source>os</source>", "<instance_image url=\"#o\"/>");
  const SourceModel model = import_or_fail(folder_.write("m.dae", text));
  const SourceMaterial& material = model.materials.at(model.meshes.at(0).material);
  EXPECT_EQ(material.base_texture.path, "c.png");
  EXPECT_EQ(material.opacity_texture.path, "o.png");
  EXPECT_EQ(material.base_texture.wrap[0], TextureWrap::kClamp);
}

TEST_F(ColladaTexturesTest, NodesThatAreHiddenAreLeftOutWithAllBelowThem) {
  const std::string off = "<extra><technique profile=\"FCOLLADA\"><visibility>0</visibility></technique></extra>";
  const std::string again =
      "<node id=\"old\">" + off + "<node id=\"old_lock\"><instance_geometry url=\"#g\"/></node></node>";
  const std::string both = replaced(document({}), "<node id=\"n\">", again + "<node id=\"n\">");
  const SourceModel model = import_or_fail(folder_.write("m.dae", both));
  EXPECT_EQ(model.meshes.size(), 1u);
  EXPECT_NE(warnings_of(model).find("1 mesh left out, since the file hides it: 'old_lock'"), std::string::npos);
  for (const char* const shown : {"1", "true"}) {
    const SourceModel two =
        import_or_fail(folder_.write("m.dae", replaced(both, "<visibility>0<", fmt::format("<visibility>{}<", shown))));
    EXPECT_EQ(two.meshes.size(), 2u) << shown;
    EXPECT_TRUE(two.warnings.empty()) << shown;
  }
}

TEST_F(ColladaTexturesTest, NodesAndMeshesHaveTheirNamesNotTheirIds) {
  std::string text =
      replaced(document({.is_skinned = true}), "<geometry id=\"g\">", "<geometry id=\"g\" name=\"Hair\">");
  text = replaced(text, "<node id=\"bone\"", "<node id=\"bone\" name=\"left lock\"");
  const SourceModel model = import_or_fail(folder_.write("m.dae", text));
  EXPECT_EQ(model.meshes.at(0).name, "Hair");
  ASSERT_FALSE(model.meshes[0].influences.empty());
  EXPECT_EQ(model.nodes.at(model.meshes[0].influences[0].node).name, "left lock");
  EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST_F(ColladaTexturesTest, LevelsOfDetailAreToldByNames) {
  const std::string fine = "<node id=\"n\" name=\"Hair_LOD0\">";
  const std::string coarse = "<node id=\"ID7\" name=\"Hair_LOD1\"><instance_geometry url=\"#g\"/></node>";
  const SourceModel model =
      import_or_fail(folder_.write("m.dae", replaced(document({}), "<node id=\"n\">", coarse + fine)));
  EXPECT_EQ(model.meshes.size(), 1u);
  EXPECT_NE(warnings_of(model).find("1 mesh left out as coarser levels of detail"), std::string::npos)
      << warnings_of(model);
}

TEST_F(ColladaTexturesTest, ShapesOfAMorphThatAreOnArePartOfTheShape) {
  const auto text_with = [](const char* method, double weight) {
    std::string text = document({});
    const std::size_t begin = text.find("<geometry id=\"g\">"), end = text.find("</library_geometries>");
    std::string target = text.substr(begin, end - begin);
    for (std::size_t at = 0; (at = target.find("id=\"", at)) != std::string::npos; at += 5) target.insert(at + 4, "t");
    for (std::size_t at = 0; (at = target.find("\"#", at)) != std::string::npos; at += 3) target.insert(at + 2, "t");
    target = replaced(target, "0 0 0 1 0 0 0 1 0", "0 0 0 1 0 0 0 5 0");
    text.insert(end, target);
    text.insert(text.find("<library_visual_scenes>"),
                fmt::format(R"(<library_controllers><controller id="mc"><morph source="#g" method="{}">
<source id="mt"><IDREF_array id="mt-n" count="1">tg</IDREF_array><technique_common><accessor source="#mt-n" count="1" stride="1"><param name="MORPH_TARGET" type="IDREF"/></accessor></technique_common></source>
<source id="mw"><float_array id="mw-n" count="1">{}</float_array><technique_common><accessor source="#mw-n" count="1" stride="1"><param name="MORPH_WEIGHT" type="float"/></accessor></technique_common></source>
<targets><input semantic="MORPH_TARGET" source="#mt"/><input semantic="MORPH_WEIGHT" source="#mw"/></targets></morph></controller></library_controllers>)",
                            method, weight));
    text = replaced(text, "<instance_geometry url=\"#g\">", "<instance_controller url=\"#mc\">");
    return replaced(text, "</instance_geometry>", "</instance_controller>");
  };
  const auto tip_of = [&](const char* method, double weight) {
    return import_or_fail(folder_.write("m.dae", text_with(method, weight))).meshes.at(0).positions.at(2).y();
  };
  EXPECT_EQ(tip_of("NORMALIZED", 0), 1);
  EXPECT_EQ(tip_of("NORMALIZED", 1), 5);
  EXPECT_EQ(tip_of("NORMALIZED", 0.5), 3);
  EXPECT_EQ(tip_of("RELATIVE", 1), 6);
  const SourceModel model = import_or_fail(folder_.write("m.dae", text_with("NORMALIZED", 0.5)));
  EXPECT_NE(warnings_of(model).find("shape keys are on"), std::string::npos) << warnings_of(model);
}

TEST(ColladaTexturesShared, BlendersSecondUvMapIsTaken) {
  const std::filesystem::path folder = std::filesystem::path(COIF_TEST_ASSETS) / "../cases/reading/blender";
  if (!std::filesystem::exists(folder / "b03_second_uv.dae")) GTEST_SKIP() << "no files of Blender at " << folder;
  const test::Shape dae = test::measure(import_or_fail(folder / "b03_second_uv.dae"));
  const test::Shape gltf = test::measure(import_or_fail(folder / "b03_second_uv.glb"));
  EXPECT_TRUE(dae.mean_uv.isApprox(gltf.mean_uv, 1e-5))
      << dae.mean_uv.transpose() << " and " << gltf.mean_uv.transpose();
}

}  // namespace coif::importer::collada_textures_test
