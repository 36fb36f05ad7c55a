#include "model_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif {
namespace {

using test::SmallGltf;
using test::TemporaryFolder;

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

}  // namespace
}  // namespace coif
