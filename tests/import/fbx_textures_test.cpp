// How an FBX says where its textures lie, and how they go on outside 0..1.

#include "import/fbx_files.h"
#include "import/fbx_objects.h"
#include "import/imported_model.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coif::importer::fbx_textures_test {

using test::fbx_property;
using test::import_or_fail;
using test::TemporaryFolder;

std::string texture(int id, const std::string& file, const std::string& properties) {
  return fmt::format(
      "  Texture: {0}, \"Texture::t{0}\", \"\" {{\n    Type: \"TextureVideoClip\"\n    FileName: \"C:\\work\\{1}\"\n"
      "    RelativeFilename: \"maps\\{1}\"\n    Properties70:  {{\n{2}    }}\n  }}\n",
      id, file, properties);
}

std::string clamped(const char* property) { return fbx_property(property, "enum", 1); }

/// What a mesh says of its one material, and the beginning of its layer.
constexpr const char* kOneMaterial = R"(    LayerElementMaterial: 0 {
      Version: 101
      Name: ""
      MappingInformationType: "AllSame"
      ReferenceInformationType: "IndexToDirect"
      Materials: *1 {
        a: 0
      }
    }
    Layer: 0 {
      Version: 100
      LayerElement:  {
        Type: "LayerElementMaterial"
        TypedIndex: 0
      }
)";

/// A triangle whose material has textures as the objects and connections say; the material is the object 50.
SourceModel model_with(const TemporaryFolder& folder, const std::string& textures, const std::string& connections) {
  std::string file = test::text_fbx({{20, "hair", 0, ""}});
  file.insert(
      file.find("Objects:  {\n") + 12,
      "  Material: 50, \"Material::Hair\", \"\" {\n    Version: 102\n    ShadingModel: \"phong\"\n  }\n" + textures);
  file.insert(file.find("    GeometryVersion: 124\n"), std::string(kOneMaterial) + "    }\n");
  file.insert(file.find("Connections:  {\n") + 16, "  C: \"OO\",50,20\n" + connections);
  return import_or_fail(folder.write("m.fbx", file));
}

/// The material of a triangle, which has a colour and an opacity texture.
SourceMaterial material_of(const TemporaryFolder& folder, const std::string& color, const std::string& opacity) {
  const SourceModel model =
      model_with(folder, texture(60, "hair.png", color) + texture(61, "mask.png", opacity),
                 "  C: \"OP\",60,50, \"DiffuseColor\"\n  C: \"OP\",61,50, \"TransparentColor\"\n");
  return model.materials.at(model.meshes.at(0).material);
}

TEST(FbxTextures, WrapModesAreThoseOfEachTexture) {
  const TemporaryFolder folder;
  const SourceMaterial material =
      material_of(folder, clamped("WrapModeU") + fbx_property("WrapModeV", "enum", 0), clamped("WrapModeV"));
  ASSERT_TRUE(material.base_texture.is_there());
  ASSERT_TRUE(material.opacity_texture.is_there());
  EXPECT_EQ(material.base_texture.wrap[0], TextureWrap::kClamp);
  EXPECT_EQ(material.base_texture.wrap[1], TextureWrap::kRepeat);
  EXPECT_EQ(material.opacity_texture.wrap[0], TextureWrap::kRepeat);
  EXPECT_EQ(material.opacity_texture.wrap[1], TextureWrap::kClamp);
}

TEST(FbxTextures, ATextureThatSaysNothingIsRepeated) {
  const TemporaryFolder folder;
  for (const TextureWrap wrap : material_of(folder, "", "").base_texture.wrap) EXPECT_EQ(wrap, TextureWrap::kRepeat);
}

TEST(FbxTextures, BinaryFilesSayTheSame) {
  using test::fbx_int32, test::fbx_long, test::fbx_name, test::fbx_text;
  const test::FbxTree wrap{
      "P", {fbx_text("WrapModeV"), fbx_text("enum"), fbx_text(""), fbx_text(""), fbx_int32(1)}, {}};
  const std::string file = test::binary_fbx(
      7400, {{"Objects",
              {},
              {{"Material", {fbx_long(1), fbx_name("Hair", "Material"), fbx_text("")}, {}},
               {"Texture",
                {fbx_long(2), fbx_name("t", "Texture"), fbx_text("")},
                {{"RelativeFilename", {fbx_text("hair.png")}, {}}, {"Properties70", {}, {wrap}}}}}},
             {"Connections", {}, {{"C", {fbx_text("OP"), fbx_long(2), fbx_long(1), fbx_text("DiffuseColor")}, {}}}}});
  const auto objects = FbxObjects::read(file);
  ASSERT_TRUE(objects);
  ASSERT_EQ(objects->on_properties(1).size(), 1u);
  const FbxObject& texture = *objects->find(objects->on_properties(1)[0].from);
  EXPECT_EQ(texture.kind, FbxKind::kTexture);
  EXPECT_EQ(texture.file, "hair.png");
  EXPECT_FALSE(texture.is_clamped[0]);
  EXPECT_TRUE(texture.is_clamped[1]);
  EXPECT_EQ(objects->find(1)->name, "Hair");
}

/// The coordinates of the triangle's corners at (0, 0), (1, 0) and (0, 1) with a texture of these properties, V growing
/// upwards.
std::vector<Eigen::Vector2f> placed_uvs(const std::string& properties, const std::string& creator = "") {
  const TemporaryFolder folder;
  std::string file = test::text_fbx({{20, "hair", 0, ""}});
  const std::string header = "FBXHeaderExtension:  {\n";
  if (!creator.empty()) file.insert(file.find(header) + header.size(), "  Creator: \"" + creator + "\"\n");
  file.insert(file.find("Objects:  {\n") + 12,
              "  Material: 50, \"Material::Hair\", \"\" {\n    Version: 102\n    ShadingModel: \"phong\"\n  }\n" +
                  texture(60, "hair.png", properties));
  file.insert(file.find("    GeometryVersion: 124\n"), R"(    LayerElementUV: 0 {
      Version: 101
      Name: "UVMap"
      MappingInformationType: "ByPolygonVertex"
      ReferenceInformationType: "Direct"
      UV: *6 {
        a: 0,0,1,0,0,1
      }
    }
)" + std::string(kOneMaterial) +
                                                           R"(      LayerElement:  {
        Type: "LayerElementUV"
        TypedIndex: 0
      }
    }
)");
  file.insert(file.find("Connections:  {\n") + 16, "  C: \"OO\",50,20\n  C: \"OP\",60,50, \"DiffuseColor\"\n");
  const SourceModel model = import_or_fail(folder.write("m.fbx", file));
  std::vector<Eigen::Vector2f> uvs = model.meshes.at(0).uvs;
  for (Eigen::Vector2f& uv : uvs) uv.y() = 1 - uv.y();
  return uvs;
}

std::string pair_property(const char* name, double u, double v) {
  return fmt::format("      P: \"{}\", \"Vector\", \"\", \"A\",{},{},0\n", name, u, v);
}
std::string degrees_property(double degrees) {
  return fmt::format("      P: \"Rotation\", \"Vector\", \"\", \"A\",0,0,{}\n", degrees);
}

void expect_uvs(const std::string& properties, const std::vector<Eigen::Vector2f>& wanted,
                const std::string& creator = "") {
  const auto uvs = placed_uvs(properties, creator);
  ASSERT_EQ(uvs.size(), wanted.size());
  for (std::size_t v = 0; v < uvs.size(); ++v)
    EXPECT_LT((uvs[v] - wanted[v]).norm(), 1e-6f) << properties << uvs[v].transpose();
}

TEST(FbxTextures, LieOnTheSurfaceScaledTurnedAndMoved) {
  expect_uvs("", {{0, 0}, {1, 0}, {0, 1}});
  expect_uvs(pair_property("Scaling", 2, 4), {{0, 0}, {0.5f, 0}, {0, 0.25f}});
  expect_uvs(pair_property("Translation", 0.25, 0.5), {{-0.25f, -0.5f}, {0.75f, -0.5f}, {-0.25f, 0.5f}});
  expect_uvs(degrees_property(90), {{0, 0}, {0, -1}, {1, 0}});
  expect_uvs(pair_property("Scaling", 2, 2) + pair_property("Translation", 0.5, 0) + degrees_property(90),
             {{0, 0.25f}, {0, -0.25f}, {0.5f, 0.25f}});
  expect_uvs(pair_property("Scaling", 0, 1), {{0, 0}, {1, 0}, {0, 1}});
}

TEST(FbxTextures, RunAlongTheOtherAxisWhereUvSwapSaysSo) {
  const std::string swap = fbx_property("UVSwap", "bool", 1);
  expect_uvs(swap, {{0, 0}, {0, 1}, {1, 0}});
  expect_uvs(swap + pair_property("Scaling", 2, 4) + pair_property("Translation", 1, 0),
             {{-0.5f, 0}, {-0.5f, 0.25f}, {0, 0}});
  expect_uvs(fbx_property("UVSwap", "bool", 0), {{0, 0}, {1, 0}, {0, 1}});
}

TEST(FbxTextures, AreFoundByWhatProgramsCallTheProperty) {
  const TemporaryFolder folder;
  const std::string both =
      texture(60, "hair.png", clamped("WrapModeU")) + texture(61, "mask.png", clamped("WrapModeV"));
  for (const char* const opacity : {"TransparentColor", "Opacity", "Maya|opacity", "Maya|opacity|file",
                                    "3dsMax|Parameters|cutout_map", "Maya|TEX_opacity_map"}) {
    const SourceModel model = model_with(
        folder, both, fmt::format("  C: \"OP\",60,50, \"Arnold|base_color\"\n  C: \"OP\",61,50, \"{}\"\n", opacity));
    const SourceMaterial& material = model.materials.at(model.meshes.at(0).material);
    EXPECT_EQ(material.base_texture.path, "maps\\hair.png") << opacity;
    EXPECT_EQ(material.opacity_texture.path, "maps\\mask.png") << opacity;
    EXPECT_EQ(material.base_texture.wrap[0], TextureWrap::kClamp) << opacity;
    EXPECT_EQ(material.opacity_texture.wrap[1], TextureWrap::kClamp) << opacity;
    EXPECT_EQ(material.alpha_use, AlphaUse::kBlend) << opacity;
    EXPECT_TRUE(model.warnings.empty()) << opacity;
  }
  const SourceModel bumpy = model_with(folder, both, "  C: \"OP\",60,50, \"Maya|coatRoughness\"\n");
  EXPECT_FALSE(bumpy.materials.at(bumpy.meshes.at(0).material).base_texture.is_there());
}

TEST(FbxTextures, OfLayersTheFirstIsReadWithAWarning) {
  const TemporaryFolder folder;
  const std::string layered =
      "  LayeredTexture: 70, \"LayeredTexture::l\", \"\" {\n    LayeredTexture: 100\n    BlendModes: *2 {\n      a: "
      "0,0\n"
      "    }\n    Alphas: *2 {\n      a: 1,1\n    }\n  }\n";
  const std::string textures = layered + texture(60, "hair.png", clamped("WrapModeU")) + texture(61, "dirt.png", "");
  const std::string connected = "  C: \"OP\",70,50, \"DiffuseColor\"\n  C: \"OO\",60,70\n";
  const SourceModel one = model_with(folder, textures, connected);
  const SourceTexture& read = one.materials.at(one.meshes.at(0).material).base_texture;
  EXPECT_EQ(read.path, "maps\\hair.png");
  EXPECT_EQ(read.wrap[0], TextureWrap::kClamp);
  EXPECT_TRUE(one.warnings.empty());
  const SourceModel two = model_with(folder, textures, connected + "  C: \"OO\",61,70\n");
  EXPECT_EQ(two.materials.at(two.meshes.at(0).material).base_texture.path, "maps\\hair.png");
  ASSERT_EQ(two.warnings.size(), 1u);
  EXPECT_EQ(two.warnings[0].code, "S217");
  EXPECT_NE(two.warnings[0].message.find("2 layers of textures"), std::string::npos) << two.warnings[0].message;
}

TEST(FbxTextures, AreScaledAndTurnedAboutTheirPivots) {
  expect_uvs(pair_property("Scaling", 2, 2) + pair_property("TextureScalingPivot", 0.5, 0.5),
             {{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}});
  expect_uvs(degrees_property(90) + pair_property("TextureRotationPivot", 0.5, 0.5), {{0, 1}, {0, 0}, {1, 1}});
  expect_uvs(pair_property("TextureScalingPivot", 0.5, 0.5) + pair_property("TextureRotationPivot", 3, 4),
             {{0, 0}, {1, 0}, {0, 1}});
}

TEST(FbxTextures, OfBlenderAreTurnedInRadiansAndMovedAsTheyAre) {
  expect_uvs(degrees_property(1.5707963267948966), {{0, 0}, {0, -1}, {1, 0}}, "Blender (stable FBX IO) - 3.4.1");
  expect_uvs(pair_property("Scaling", 2, 2) + pair_property("Translation", 0.25, 0),
             {{0.25f, 0}, {0.75f, 0}, {0.25f, 0.5f}}, "Blender (stable FBX IO) - 3.4.1");
}

}  // namespace coif::importer::fbx_textures_test
