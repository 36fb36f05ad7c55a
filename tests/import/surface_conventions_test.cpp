// Coordinates of textures, opacity and vertex colours: what each format means by them.

#include "import/import.h"
#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <string>

namespace coif::importer::surface_conventions_test {

using test::import_or_fail;
using test::TemporaryFolder;

class SurfaceConventions : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(SurfaceConventions, ScaleAndOffsetOfAnObjsTextureMoveItsCoordinates) {
  folder_.write("m.mtl", "newmtl moved\nmap_Kd -s 0.5 0.25 1 -o 0.5 0.125 0 hair.png\nnewmtl plain\nmap_Kd hair.png\n");
  const SourceModel model =
      import_or_fail(folder_.write("m.obj",
                                   "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl moved\nf "
                                   "1/1 2/2 3/3\nusemtl plain\nf 1/1 3/3 2/2\n"));
  for (const SourceMesh& mesh : model.meshes) {
    const bool is_moved = material_name(model, mesh) == "moved";
    for (std::size_t v = 0; v < mesh.uvs.size(); ++v) {
      const Eigen::Vector2f own(mesh.positions[v].x(), mesh.positions[v].y());  // V from below
      const Eigen::Vector2f wanted = is_moved ? Eigen::Vector2f(0.5f * own.x() + 0.5f, 0.25f * own.y() + 0.125f) : own;
      EXPECT_TRUE(mesh.uvs[v].isApprox(Eigen::Vector2f(wanted.x(), 1 - wanted.y()), 1e-6f)) << mesh.uvs[v].transpose();
    }
    EXPECT_EQ(model.materials.at(mesh.material).base_texture.path, "hair.png");
  }
  EXPECT_TRUE(model.warnings.empty());
}

TEST_F(SurfaceConventions, OptionsOfAnObjsTextureLeaveItsPathWhole) {
  folder_.write("m.mtl",
                "newmtl hair\nmap_Kd -s 2 3 -o 0.25 0.5-1 hair.png\nmap_d -imfchan g -blendu on packed alpha.png\n");
  const SourceModel model = import_or_fail(folder_.write(
      "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl hair\nf 1/1 2/2 3/3\n"));
  const SourceMaterial& material = model.materials.at(model.meshes.at(0).material);
  EXPECT_EQ(material.base_texture.path, "0.5-1 hair.png") << "a name may begin like a number";
  EXPECT_EQ(material.opacity_texture.path, "packed alpha.png");
  EXPECT_EQ(material.opacity_channel, TextureChannel::kGreen);
  EXPECT_TRUE(model.meshes[0].uvs[0].isApprox(Eigen::Vector2f(0.25f, 1))) << model.meshes[0].uvs[0].transpose();
}

TEST_F(SurfaceConventions, OptionsOfAnObjsTextureMayStandBehindItsPath) {
  const auto read_with = [&](const std::string& statement) {
    folder_.write("m.mtl", "newmtl hair\n" + statement + "\n");
    return import_or_fail(folder_.write(
        "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl hair\nf 1/1 2/2 3/3\n"));
  };
  const SourceModel model = read_with("map_Kd my hair.png -s 2 3 -o 0.25 0.5 0 -clamp on");
  const SourceTexture& texture = model.materials.at(model.meshes.at(0).material).base_texture;
  EXPECT_EQ(texture.path, "my hair.png");
  EXPECT_EQ(texture.wrap[0], TextureWrap::kClamp);
  EXPECT_TRUE(model.meshes[0].uvs[1].isApprox(Eigen::Vector2f(2.25f, 0.5f))) << model.meshes[0].uvs[1].transpose();
  for (const std::string path : {"hair -s new.png", "v1.2 hair -s 2 new.png", "hair.png -old"}) {
    const SourceModel other = read_with("map_Kd " + path);
    EXPECT_EQ(other.materials.at(other.meshes.at(0).material).base_texture.path, path);
  }
}

TEST_F(SurfaceConventions, AnObjsOpacityThatLiesElsewhereIsTold) {
  folder_.write("m.mtl", "newmtl moved\nmap_Kd -s 2 2 1 hair.png\nmap_d alpha.png\n");
  const SourceModel model = import_or_fail(folder_.write(
      "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl moved\nf 1/1 2/2 3/3\n"));
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].message.find("map_d is placed otherwise than map_Kd"), std::string::npos);
}

TEST_F(SurfaceConventions, AnObjsClampedTextureIsKnown) {
  folder_.write("m.mtl", "newmtl held\nmap_Kd -clamp on hair.png\n");
  const SourceModel model = import_or_fail(folder_.write(
      "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl held\nf 1/1 2/2 3/3\n"));
  EXPECT_EQ(model.materials.at(model.meshes.at(0).material).base_texture.wrap[0], TextureWrap::kClamp);
  EXPECT_EQ(model.materials.at(model.meshes.at(0).material).base_texture.wrap[1], TextureWrap::kClamp);
}

TEST_F(SurfaceConventions, VertexColorsOfAnObjAreReadAsAScreenShowsThem) {
  const SourceModel model =
      import_or_fail(folder_.write("m.obj", "v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1 0.5 0\nf 1 2 3\n"));
  ASSERT_EQ(model.meshes.at(0).colors.size(), 3u);
  EXPECT_TRUE(model.meshes[0].colors[0].isApprox(Eigen::Vector4f(1, 0.2140411f, 0, 1), 1e-4f))
      << model.meshes[0].colors[0].transpose();
  const SourceModel white =
      import_or_fail(folder_.write("w.obj", "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n"));
  EXPECT_TRUE(white.meshes.at(0).colors.empty()) << "white says nothing";
}

TEST_F(SurfaceConventions, VertexColorsOfAnObjMayBeBytes) {
  const auto first_color = [&](const std::string& colors) {
    return import_or_fail(folder_.write("m.obj", "v 0 0 0 " + colors + "\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n"))
        .meshes.at(0)
        .colors.at(0);
  };
  EXPECT_TRUE(first_color("255 51 0").isApprox(first_color("1 0.2 0"), 1e-6f));
  EXPECT_EQ(first_color("1 0 0").x(), 1);
  EXPECT_EQ(first_color("2.5 0 0").x(), 2.5f) << "brighter than white";
}

TEST_F(SurfaceConventions, VerticesOfAnObjThatHaveNoColorAreWhite) {
  const std::string head = "o Head\nv 0 0 5\nv 1 0 5 1\nv 0 1 5\nf 1 2 3\n";
  const auto hair_of = [&](const std::string& color) {
    const SourceModel model = import_or_fail(
        folder_.write("m.obj", head + "o Hair\nv 0 0 0 " + color + "\r\nv 1 0 0\nv\t0 1 0 " + color + "\nf 4 5 6\n"));
    EXPECT_TRUE(model.meshes.at(0).colors.empty()) << "the head has none";
    EXPECT_EQ(model.meshes.at(0).positions[1].z(), 5);
    return model.meshes.at(1);
  };
  for (const char* const color : {"1 0 0", "255 0 0", "1 0 0 0.5", "255 0 0 255"}) {
    const SourceMesh hair = hair_of(color);
    ASSERT_EQ(hair.colors.size(), 3u) << color;
    for (int v = 0; v < 3; ++v) {
      const Eigen::Vector4f wanted = v == 1 ? Eigen::Vector4f(1, 1, 1, 1) : Eigen::Vector4f(1, 0, 0, 1);
      EXPECT_TRUE(hair.colors[std::size_t(v)].isApprox(wanted, 1e-6f)) << color << ": " << hair.colors[std::size_t(v)];
    }
  }
  EXPECT_EQ(hair_of("2.5 0 0").colors.at(1).y(), 1) << "no bytes: brighter than white";
}

TEST_F(SurfaceConventions, ColladaSaysWhichNumbersOfATextureAreTheOpacity) {
  const auto material_of = [&](const std::string& opaque) {
    const SourceModel model = import_or_fail(folder_.write(
        "m.dae",
        R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_images><image id="c"><init_from>c.png</init_from></image><image id="a"><init_from>a.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="cs"><surface type="2D"><init_from>c</init_from></surface></newparam>
<newparam sid="ct"><sampler2D><source>cs</source></sampler2D></newparam>
<newparam sid="as"><surface type="2D"><init_from>a</init_from></surface></newparam>
<newparam sid="at"><sampler2D><source>as</source></sampler2D></newparam>
<technique sid="t"><lambert><diffuse><texture texture="ct" texcoord="UV"/></diffuse>
<transparent )" +
            opaque +
            R"(><texture texture="at" texcoord="UV"/></transparent></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="Hair"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)"));
    return model.materials.at(model.meshes.at(0).material);
  };
  EXPECT_EQ(material_of("").opacity_texture.path, "a.png");
  EXPECT_EQ(material_of("").opacity_channel, TextureChannel::kAuto);
  EXPECT_FALSE(material_of(R"(opaque="A_ONE")").opacity_inverted);
  EXPECT_EQ(material_of(R"(opaque="RGB_ZERO")").opacity_channel, TextureChannel::kLuminance);
  EXPECT_TRUE(material_of(R"(opaque="RGB_ZERO")").opacity_inverted);
}

}  // namespace coif::importer::surface_conventions_test
