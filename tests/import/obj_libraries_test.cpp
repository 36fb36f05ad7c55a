// Material libraries of an OBJ: how their names and their text are written.

#include "import/imported_model.h"
#include "import/model_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace coif::importer::obj_libraries_test {

using test::import_or_fail;
using test::TemporaryFolder;
using test::warns;

constexpr const char* kRed = "newmtl hair\nKd 1 0 0\nmap_Kd hair.png\n";

class ObjLibraries : public testing::Test {
 protected:
  /// A triangle of the material "hair", behind lines that name libraries.
  SourceModel read(const std::string& lines) const {
    return import_or_fail(folder_.write(
        "m.obj", lines + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl hair\nf 1/1 2/2 3/3\n"));
  }
  static const SourceMaterial& hair(const SourceModel& model) {
    return model.materials.at(model.meshes.at(0).material);
  }
  /// Whether the library "my hair.mtl" was read.
  void expect_read(const SourceModel& model, const std::string& how) const {
    EXPECT_EQ(hair(model).base_color.y(), 0) << how;
    EXPECT_EQ(hair(model).base_texture.path, "hair.png") << how;
  }

  TemporaryFolder folder_;
};

TEST_F(ObjLibraries, MayBeNamedWithBlanksQuotesAndContinuedLines) {
  folder_.write("my hair.mtl", kRed);
  for (const std::string line : {"mtllib my hair.mtl", "mtllib my hair.mtl \t ", "mtllib \"my hair.mtl\"",
                                 "mtllib\tmy hair.mtl\r", "mtllib \\\nmy hair.mtl", "\xEF\xBB\xBFmtllib my hair.mtl"}) {
    const SourceModel model = read(line);
    expect_read(model, line);
    EXPECT_TRUE(model.warnings.empty()) << line << test::warnings_of(model);
  }
}

TEST_F(ObjLibraries, AreFoundUnderAnotherSpellingWithAWarning) {
  std::filesystem::create_directory(folder_.path() / "sub");
  folder_.write("sub/my hair.mtl", kRed);
  for (const std::string name : {"sub\\my hair.mtl", ".\\Sub\\My Hair.MTL", "SUB/my hair.mtl"}) {
    const SourceModel model = read("mtllib " + name);
    expect_read(model, name);
    EXPECT_TRUE(warns(model, "'" + name + "' is named, and there is no such file; 'sub/my hair.mtl' is taken for it"))
        << test::warnings_of(model);
  }
  folder_.write("h\u00E4r.mtl", kRed);
  expect_read(read("mtllib h\xE4r.mtl"), "Latin-1");
  expect_read(read("mtllib C:\\Users\\me\\h\u00E4r.mtl"), "a path of another machine");
  EXPECT_TRUE(warns(read("mtllib none.mtl"), "'none.mtl' is named for the materials and was not read"));
}

TEST_F(ObjLibraries, MayBeSeveralInOneStatement) {
  folder_.write("a.mtl", "newmtl skin\nKd 0 1 0\n");
  folder_.write("my hair.mtl", kRed);
  for (const std::string line :
       {"mtllib a.mtl my hair.mtl", "mtllib a.mtl \"my hair.mtl\"", "mtllib a.mtl\nmtllib my hair.mtl"}) {
    const SourceModel model = read(line);
    expect_read(model, line);
    EXPECT_TRUE(model.warnings.empty()) << test::warnings_of(model);
  }
}

TEST_F(ObjLibraries, MayBeWrittenInEveryWay) {
  for (const std::string text : {
           "newmtl hair\r\nKd 1 0 0\r\nmap_Kd hair.png\r\n",
           "newmtl hair\rKd 1 0 0\rmap_Kd hair.png\r",
           "\xEF\xBB\xBFnewmtl hair\nKd 1 0 0\nmap_Kd hair.png",
           "\tnewmtl\thair \n\tKd\t1\t0\t0\n\tmap_Kd\thair.png \t\n",
           "newmtl hair\nKd 1 0 0\nmap_Kd \"hair.png\"\n",
           "newmtl hair\nKd 1 \\\n 0 0\nmap_Kd \\\r\n hair.png\n",
           "NEWMTL hair\nKD 1 0 0\nMap_kD hair.png\n",
       }) {
    folder_.write("m.mtl", text);
    const SourceModel model = read("mtllib m.mtl");
    expect_read(model, text);
    EXPECT_TRUE(model.warnings.empty()) << text << test::warnings_of(model);
  }
  folder_.write("m.mtl", "newmtl hair\nmap_Kd -s 2 2 1 \"my h\xE4r.png\"\n");
  const SourceModel model = read("mtllib m.mtl");
  EXPECT_EQ(hair(model).base_texture.path, "my h\u00E4r.png");
  EXPECT_FLOAT_EQ(model.meshes[0].uvs[1].x(), 2);
  EXPECT_NE(std::ranges::find(model.named_images, "my h\u00E4r.png"), model.named_images.end());
}

TEST_F(ObjLibraries, OfWhichOneStatementIsNotReadAreReadToTheEnd) {
  for (const std::string line : {"Ka spectral lamp.rfl 1", "Tf xyz 1 1 1", "d nothing", "Ns", "illum none"}) {
    folder_.write("m.mtl", "newmtl hair\n" + line + "\nKd 1 0 0\nmap_Kd hair.png\n");
    expect_read(read("mtllib m.mtl"), line);
  }
}

TEST_F(ObjLibraries, SayHowOpaqueAMaterialIs) {
  const auto read_with = [&](const std::string& lines) {
    folder_.write("m.mtl", "newmtl hair\nmap_Kd hair.png\n" + lines);
    return read("mtllib m.mtl");
  };
  for (const std::string line : {"d 0.25\n", "d -halo 0.25\n", "Tr 0.75\n", "Tr 0.5\nd 0.25\n"}) {
    const SourceModel model = read_with(line);
    EXPECT_FLOAT_EQ(hair(model).base_color.w(), 0.25f) << line;
    EXPECT_EQ(hair(model).alpha_use, AlphaUse::kBlend) << line;
    EXPECT_TRUE(model.warnings.empty()) << line;
  }
  for (const std::string line : {"d 0\n", "Tr 1\n", "d 0\nmap_d alpha.png\n"}) {
    const SourceModel model = read_with(line);
    EXPECT_EQ(hair(model).base_color.w(), 1) << line;
    EXPECT_TRUE(warns(model, "wholly transparent (" + line.substr(0, line.find('\n')) + ")"))
        << test::warnings_of(model);
  }
  for (const std::string line : {"d 1\n", "Tr 0\n", "d 1\nTr 1\n", "d nothing\n", ""}) {
    const SourceModel model = read_with(line);
    EXPECT_EQ(hair(model).base_color.w(), 1) << line;
    EXPECT_TRUE(model.warnings.empty()) << line << test::warnings_of(model);
  }
}

TEST_F(ObjLibraries, SayWhatIsNotRead) {
  folder_.write("m.mtl", "newmtl hair\nmap_Kd hair.png\nmap_Tr clear.png\n");
  EXPECT_TRUE(warns(read("mtllib m.mtl"), "map_Tr 'clear.png' is not read"));
  folder_.write("m.mtl", "newmtl hair\nKd 0 0 0\nmap_Ke glow.png\n");
  const SourceModel model = read("mtllib m.mtl");
  EXPECT_EQ(hair(model).base_texture.path, "glow.png");
  EXPECT_EQ(hair(model).base_color, Eigen::Vector4f::Ones());
  EXPECT_TRUE(warns(model, "only its light has a texture, 'glow.png'")) << test::warnings_of(model);
}

TEST_F(ObjLibraries, ThatLackAMaterialAreTold) {
  folder_.write("m.mtl", "newmtl my hair\nmap_Kd hair.png\n");
  EXPECT_TRUE(warns(read("mtllib m.mtl"), "has the material 'hair', which its .mtl does not have"));
  folder_.write("m.mtl", "newmtl hair\nmap_Kd hair.png\n");
  EXPECT_TRUE(read("mtllib m.mtl").warnings.empty());
}

TEST_F(ObjLibraries, WhoseBlackHidesATextureAreTakenForWhite) {
  folder_.write("m.mtl", "newmtl hair\nKd 0 0 0\nmap_Kd hair.png\n");
  const SourceModel model = read("mtllib m.mtl");
  EXPECT_EQ(hair(model).base_color, Eigen::Vector4f::Ones());
  EXPECT_TRUE(warns(model, "Kd 0 0 0")) << test::warnings_of(model);
  folder_.write("m.mtl", "newmtl hair\nKd 0 0 0\n");
  EXPECT_EQ(hair(read("mtllib m.mtl")).base_color.x(), 0) << "black hair";
}

}  // namespace coif::importer::obj_libraries_test
