// What a process behind the fence can still open, tried by a child of this one.

#include "platform/child_process.h"
#include "platform/sandbox.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <linux/landlock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace coif::file_fence_test {

namespace fs = std::filesystem;

bool opens(const fs::path& path, int flags = O_RDONLY) { return open(path.c_str(), flags | O_CLOEXEC, 0600) >= 0; }

class FileFence : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) / ("fence_" + std::to_string(getpid()));
    fs::create_directories(root_ / "model" / "textures");
    for (const char* name : {"secret.txt", "model/hair.obj", "model/textures/hair.png"}) {
      std::ofstream(root_ / name) << "some bytes";
    }
    fs::create_symlink(root_ / "secret.txt", root_ / "model" / "leak.mtl");
    fs::create_symlink(root_ / "model" / "hair.obj", root_ / "model.obj");
  }
  void TearDown() override { fs::remove_all(root_); }

  /// Behind the fence around `model`: 'y' or 'n'; nothing where there can be no fence.
  std::string behind(const fs::path& file, const std::function<bool()>& attempt) {
    const auto result = run_in_child({std::uint64_t{1} << 30, 20, 64}, [&]() -> std::vector<std::uint8_t> {
      if (!fence_files({root_ / "model"}, file)) return {};
      return {std::uint8_t(attempt() ? 'y' : 'n')};
    });
    EXPECT_EQ(result.end, ChildResult::End::kFinished);
    return {result.output.begin(), result.output.end()};
  }
  std::string behind(const std::function<bool()>& attempt) { return behind(root_ / "model" / "hair.obj", attempt); }

  bool has_fence() {
    const std::string inside = behind([this] { return opens(root_ / "model" / "hair.obj"); });
    return inside == "y";
  }

  fs::path root_;
};

TEST_F(FileFence, ReadsTheFolderAndBelowAndNothingElse) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(behind([this] { return opens(root_ / "model" / "textures" / "hair.png"); }), "y");
  EXPECT_EQ(behind([this] { return opens(root_ / "model", O_DIRECTORY); }), "y");
  EXPECT_EQ(behind([this] { return opens(root_ / "secret.txt"); }), "n");
  EXPECT_EQ(behind([this] { return opens(root_ / "model" / ".." / "secret.txt"); }), "n");
  EXPECT_EQ(behind([this] { return opens(root_ / "model" / "leak.mtl"); }), "n") << "a link that leads out";
  EXPECT_EQ(behind([] { return opens("/etc/passwd"); }), "n");
}

TEST_F(FileFence, ReadsTheFileItselfWhereverItsLinkLeads) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(behind(root_ / "secret.txt", [this] { return opens(root_ / "secret.txt"); }), "y");
  EXPECT_EQ(behind(root_ / "model.obj", [this] { return opens(root_ / "model.obj"); }), "y");
}

TEST_F(FileFence, NothingIsWrittenMadeMovedOrRemoved) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  const fs::path model = root_ / "model";
  EXPECT_EQ(behind([&] { return opens(model / "hair.obj", O_WRONLY); }), "n");
  EXPECT_EQ(behind([&] { return opens(model / "new", O_CREAT | O_WRONLY); }), "n");
  EXPECT_EQ(behind([&] { return mkdir((model / "new").c_str(), 0700) == 0; }), "n");
  EXPECT_EQ(behind([&] { return rename((model / "hair.obj").c_str(), (model / "other.obj").c_str()) == 0; }), "n");
  EXPECT_EQ(behind([&] { return unlink((model / "hair.obj").c_str()) == 0; }), "n");
  EXPECT_EQ(behind([&] { return symlink("/", (model / "new").c_str()) == 0; }), "n");
  EXPECT_TRUE(fs::exists(model / "hair.obj") && !fs::exists(model / "new"));
}

TEST_F(FileFence, SignalsNobodyWhereTheKernelKnowsScopes) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  if (syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 6)
    GTEST_SKIP() << "Landlock before 6";
  EXPECT_EQ(behind([] { return kill(getppid(), 0) == 0; }), "n");
  EXPECT_EQ(behind([] { return kill(getpid(), 0) == 0; }), "y");
}

TEST_F(FileFence, NeedsAFolderThatIsThere) {
  EXPECT_FALSE(fence_files({root_ / "absent"}, root_ / "secret.txt"));
  EXPECT_TRUE(opens("/etc/passwd")) << "and leaves this process as it was";
}

}  // namespace coif::file_fence_test
