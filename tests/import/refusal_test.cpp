// What import_model refuses before it parses, and how the limits of the import process show.

#include "import/import.h"
#include "import/model_files.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <string>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
