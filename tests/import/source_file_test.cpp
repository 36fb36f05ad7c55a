// What import_model refuses before it parses, and how the limits of the import process show.

#include "import/import.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <string>

namespace coif::importer::source_file_test {

namespace fs = std::filesystem;
using Kind = ToolError::Kind;
using test::SmallGltf;
using test::TemporaryFolder;

class Refusal : public testing::Test {
 protected:
  void expect(const fs::path& path, Kind kind, const std::string& text, const ImportSettings& settings = {}) {
    const auto model = import_model(path, settings);
    ASSERT_FALSE(model) << path;
    EXPECT_EQ(model.error().kind, kind) << model.error().message;
    EXPECT_EQ(model.error().message.rfind(path.string() + ": ", 0), 0u) << model.error().message;
    EXPECT_NE(model.error().message.find(text), std::string::npos) << model.error().message;
  }
  TemporaryFolder folder_;
};

TEST_F(Refusal, AbsentFile) { expect(folder_.path() / "none.fbx", Kind::kFileAccess, "No such file"); }

TEST_F(Refusal, Folder) { expect(folder_.path(), Kind::kFileAccess, "is a folder"); }

TEST_F(Refusal, PipeInsteadOfAFile) {
  const fs::path path = folder_.path() / "pipe.obj";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  expect(path, Kind::kFileAccess, "not a regular file");
}

TEST_F(Refusal, UnreadableFile) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const fs::path path = folder_.write("secret.obj", "v 0 0 0\n");
  fs::permissions(path, fs::perms::none);
  expect(path, Kind::kFileAccess, "Permission denied");
}

TEST_F(Refusal, EmptyFile) { expect(folder_.write("empty.glb", ""), Kind::kBadInput, "is empty"); }

TEST_F(Refusal, FileAboveTheLimit) {
  ImportSettings settings;
  settings.max_file_bytes = 3;
  expect(folder_.write("big.obj", "v 0 0 0\n"), Kind::kBadInput, "the limit is 3", settings);
}

TEST_F(Refusal, UnknownSuffixListsTheKnownOnes) {
  expect(folder_.write("hair.blend", "BLENDER"), Kind::kUnsupported, ".fbx, .gltf, .glb, .vrm, .obj, .dae");
  expect(folder_.write("hair", "v 0 0 0\n"), Kind::kUnsupported, ".obj");
}

TEST_F(Refusal, ContentOfAnotherFormatThanTheSuffix) {
  const std::string stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid s\n";
  expect(folder_.write("hair.glb", stl), Kind::kBadInput, "glTF 2.0");
  expect(folder_.write("hair.fbx", stl), Kind::kBadInput, "FBX");
}

TEST_F(Refusal, ColladaThatIsNoXml) {
  const std::string whole = test::small_dae("1", "Y_UP");
  expect(folder_.write("cut.dae", whole.substr(0, whole.size() - 5)), Kind::kBadInput, "COLLADA");
  expect(
      folder_.write("open.dae", "<COLLADA><float_array id='a' count='1'><accessor source='#a' count='2'/></COLLADA>"),
      Kind::kBadInput, "COLLADA");
}

TEST_F(Refusal, ColladaThatReadsBeyondAnArray) {
  std::string text = test::small_dae("1", "Y_UP");
  text.replace(text.find("count=\"3\" stride"), 9, "id=\"a>b\" count=\"300\"");
  expect(folder_.write("m.dae", text), Kind::kBadInput,
         "cannot be read as COLLADA: an accessor reads 900 numbers of the array 'pa', which has 9");
}

TEST_F(Refusal, MissingSideFileIsNamed) {
  const fs::path path = SmallGltf().write(folder_, "m.gltf");
  fs::remove(folder_.path() / "m.gltf.bin");
  expect(path, Kind::kBadInput, "m.gltf.bin");
}

TEST_F(Refusal, SuffixCaseDoesNotMatter) {
  fs::rename(SmallGltf().write(folder_, "m.gltf"), folder_.path() / "M.GLTF");
  const auto model = import_model(folder_.path() / "M.GLTF");
  EXPECT_TRUE(model) << model.error().message;
}

TEST_F(Refusal, MemoryLimitIsAnErrorOfTheFile) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "no memory limit under AddressSanitizer";
#endif
  std::string obj;
  for (int i = 0; i < 200000; ++i) obj += "v 0.123 4.567 8.901\n";
  obj += "f 1 2 3\n";
  ImportSettings settings;
  settings.max_memory_bytes = 4 << 20;
  expect(folder_.write("hungry.obj", obj), Kind::kBadInput, "4 MiB of memory", settings);
}

TEST_F(Refusal, TimeLimitIsAnErrorOfTheFile) {
  ImportSettings settings;
  settings.max_seconds = 0;
  expect(folder_.write("slow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), Kind::kBadInput, "exceeded 0 s", settings);
}

TEST_F(Refusal, EndlessSideFileIsStoppedByALimit) {
  ImportSettings settings;
  settings.max_memory_bytes = 64 << 20;
  settings.max_seconds = 5;
  const auto model = import_model(folder_.write("m.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": []}], "buffers": [{"byteLength": 4000000000, "uri": "/dev/zero"}]})"),
                                  settings);
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, Kind::kBadInput) << model.error().message;
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::vector<std::string> side_files_of(const std::filesystem::path& path) {
  const auto model = import_model(path);
  EXPECT_TRUE(model) << (model ? "" : model.error().message);
  return model ? model->side_files : std::vector<std::string>{};
}

bool holds(const std::vector<std::string>& files, const std::filesystem::path& path) {
  return std::ranges::find(files, path.string()) != files.end();
}

TEST(SideFiles, AnExternalBufferIsNamed) {
  const TemporaryFolder folder;
  const auto path = SmallGltf{}.write(folder, "strip.gltf");
  const std::vector<std::string> files = side_files_of(path);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_TRUE(std::filesystem::is_regular_file(files[0])) << files[0];
  EXPECT_EQ(std::filesystem::path(files[0]).extension(), ".bin");
}

TEST(SideFiles, AMaterialLibraryIsNamedWhetherItIsThereOrNot) {
  const TemporaryFolder folder;
  const auto path = folder.write("strip.obj", std::string("mtllib braid.mtl\n") + kTriangle);
  EXPECT_TRUE(holds(side_files_of(path), folder.path() / "braid.mtl"));
  (void)folder.write("braid.mtl", "newmtl hair\nKd 1 0 0\n");
  EXPECT_TRUE(holds(side_files_of(path), folder.path() / "braid.mtl"));
}

TEST(SideFiles, TheSourceItselfIsNotAmongThem) {
  const TemporaryFolder folder;
  const auto path = folder.write("strip.obj", kTriangle);
  EXPECT_FALSE(holds(side_files_of(path), path));
}

std::string document(const std::string& array, const std::string& accessor) {
  return fmt::format(
      "<?xml version=\"1.0\"?><COLLADA><source><float_array {}>1 2 3</float_array><accessor {}/></source></COLLADA>",
      array, accessor);
}

TEST(ColladaArrays, ThatAreLongEnoughAreLeftAlone) {
  EXPECT_FALSE(overrun_array(test::small_dae("1", "Y_UP")));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "source='#a' count='1' stride='3'")));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "source='#a' count='3'")));
  EXPECT_FALSE(overrun_array(document("id='a' count='0'", "source='#a' count='0' stride='3' offset='9'")));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "source='#elsewhere' count='9'")));
}

TEST(ColladaArrays, ThatEndTooSoonAreFound) {
  const auto fault = overrun_array(document("id='a' count='3'", "source='#a' count='8' stride='3'"));
  ASSERT_TRUE(fault);
  EXPECT_EQ(*fault, "an accessor reads 24 numbers of the array 'a', which has 3");
  EXPECT_TRUE(overrun_array(document("id='a' count='3'", "source='#a' count='1' stride='3' offset='1'")));
  EXPECT_TRUE(overrun_array(document("id=\"a\"\n count = \"3\"", "count=\"2\" source = \"#a\" stride=\"2\"")));
  EXPECT_TRUE(overrun_array(document("id='a'", "source='#a' count='1'")));
}

TEST(ColladaArrays, AreFoundOnWhicheverSideOfTheirAccessor) {
  EXPECT_TRUE(overrun_array("<accessor source='#a' count='4'/><Name_array id='a' count='3'>x y z</Name_array>"));
  EXPECT_TRUE(overrun_array("<IDREF_array id='a' count='3'>x y z</IDREF_array><accessor source='#a' count='4'/>"));
}

TEST(ColladaArrays, OfCommentsAreNone) {
  const std::string array = "<float_array id='a' count='9'/>";
  EXPECT_FALSE(overrun_array(array + "<!-- <accessor source='#a' count='10'/> > -->"));
  EXPECT_TRUE(overrun_array(array + "<!-- > --><accessor source='#a' count='10'/>"));
}

TEST(ColladaArrays, AreFoundWhateverTheirAttributesHold) {
  EXPECT_TRUE(overrun_array(document("id='a' count='3'", "id='a>b' source='#a' count='4'")));
  EXPECT_TRUE(overrun_array(document("id='a>b' count='3'", "source='#a>b' count='4'")));
  EXPECT_TRUE(overrun_array(document("id='a&amp;b' count='3'", "source='#a&#38;b' count='4'")));
  EXPECT_TRUE(overrun_array(document("name=' id=&quot;b' id='a' count='3'", "source='#a' count='4'")));
  EXPECT_TRUE(overrun_array(document("id='a' count='3'", "source='#a' count='0x64'")));
}

TEST(ColladaArrays, OfTextAreNone) {
  EXPECT_FALSE(
      overrun_array(document("id='a' count='3'", "") + "<p><![CDATA[<accessor source='#a' count='4'/>]]></p>"));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "") + "<?note <accessor source='#a' count='4'/>?>"));
}

TEST(ColladaArrays, NumbersWithoutEndDoNotWrapAround) {
  for (const char* huge : {"4294967296", "6148914691236517206", "18446744073709551615", "99999999999999999999999"}) {
    for (const char* accessor : {"source='#a' count='{}' stride='3'", "source='#a' count='3' stride='{}'",
                                 "source='#a' count='3' offset='{}'"}) {
      EXPECT_TRUE(overrun_array(document("id='a' count='3'", fmt::format(fmt::runtime(accessor), huge))))
          << huge << accessor;
    }
  }
}

TEST(ColladaArrays, BrokenDocumentsAreLeftToTheImporter) {
  const std::string whole = test::small_dae("1", "Y_UP");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(overrun_array(std::string_view(whole).substr(0, size))) << size;
  }
  for (const char* text :
       {"<", "<>", "< accessor source='#' count='1'>", "<!--", "<accessor count='", "<accessor count=5>"}) {
    EXPECT_FALSE(overrun_array(text)) << text;
  }
}

}  // namespace coif::importer::source_file_test
