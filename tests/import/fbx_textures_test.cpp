// How an FBX says that its textures go on outside 0..1.

#include "import/fbx_files.h"
#include "import/fbx_objects.h"
#include "import/imported_model.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace coif::fbx_textures_test {

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

/// A triangle whose material has a colour and an opacity texture.
SourceMaterial material_of(const TemporaryFolder& folder, const std::string& color, const std::string& opacity) {
  std::string file = test::text_fbx({{20, "hair", 0, ""}});
  file.insert(file.find("Objects:  {\n") + 12,
              "  Material: 50, \"Material::Hair\", \"\" {\n    Version: 102\n    ShadingModel: \"phong\"\n  }\n" +
                  texture(60, "hair.png", color) + texture(61, "mask.png", opacity));
  file.insert(file.find("    GeometryVersion: 124\n"), R"(    LayerElementMaterial: 0 {
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
    }
)");
  file.insert(file.find("Connections:  {\n") + 16,
              "  C: \"OO\",50,20\n  C: \"OP\",60,50, \"DiffuseColor\"\n  C: \"OP\",61,50, \"TransparentColor\"\n");
  const SourceModel model = import_or_fail(folder.write("m.fbx", file));
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

}  // namespace coif::fbx_textures_test
