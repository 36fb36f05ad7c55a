// What a process behind the fence can still open, tried by a child of this one.

#include "platform/child_process.h"
#include "platform/job.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <linux/landlock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace coif::platform::file_fence_test {

namespace fs = std::filesystem;

bool opens(const fs::path& path, int flags = O_RDONLY) { return open(path.c_str(), flags | O_CLOEXEC, 0600) >= 0; }

struct Attempt {
  std::string_view name;
  bool (*works)(const fs::path& root);
};

bool moves(const fs::path& model) { return rename((model / "hair.obj").c_str(), (model / "other.obj").c_str()) == 0; }

constexpr Attempt kAttempts[] = {
    {"the model", [](const fs::path& root) { return opens(root / "model" / "hair.obj"); }},
    {"a texture", [](const fs::path& root) { return opens(root / "model" / "textures" / "hair.png"); }},
    {"the folder", [](const fs::path& root) { return opens(root / "model", O_DIRECTORY); }},
    {"a secret", [](const fs::path& root) { return opens(root / "secret.txt"); }},
    {"a secret from the folder", [](const fs::path& root) { return opens(root / "model" / ".." / "secret.txt"); }},
    {"a link that leads out", [](const fs::path& root) { return opens(root / "model" / "leak.mtl"); }},
    {"the system's file", [](const fs::path&) { return opens("/etc/passwd"); }},
    {"a link to the model", [](const fs::path& root) { return opens(root / "model.obj"); }},
    {"writing", [](const fs::path& root) { return opens(root / "model" / "hair.obj", O_WRONLY); }},
    {"a new file", [](const fs::path& root) { return opens(root / "model" / "new", O_CREAT | O_WRONLY); }},
    {"a new folder", [](const fs::path& root) { return mkdir((root / "model" / "new").c_str(), 0700) == 0; }},
    {"another name", [](const fs::path& root) { return moves(root / "model"); }},
    {"removing", [](const fs::path& root) { return unlink((root / "model" / "hair.obj").c_str()) == 0; }},
    {"a new link", [](const fs::path& root) { return symlink("/", (root / "model" / "new").c_str()) == 0; }},
    {"a signal to the parent", [](const fs::path&) { return kill(getppid(), 0) == 0; }},
    {"a signal to itself", [](const fs::path&) { return kill(getpid(), 0) == 0; }},
};

const Job kTry("test.behind the fence", [](const JobCall& call) -> Bytes {
  std::istringstream request(std::string(call.request().begin(), call.request().end()));
  std::string name, root, file;
  std::getline(std::getline(std::getline(request, name), root), file);
  if (!fence_files({fs::path(root) / "model"}, file)) return {};
  return {std::uint8_t(std::ranges::find(kAttempts, name, &Attempt::name)->works(root) ? 'y' : 'n')};
});

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

  /// Whether an attempt works behind the fence around `model`: 'y' or 'n'; nothing where there can be no fence.
  std::string behind(const fs::path& file, std::string_view attempt) {
    EXPECT_NE(std::ranges::find(kAttempts, attempt, &Attempt::name), std::end(kAttempts)) << attempt;
    const std::string request = std::string(attempt) + '\n' + root_.string() + '\n' + file.string();
    const auto result = run_in_child(kTry, Bytes(request.begin(), request.end()), {.limits = {1 << 30, 20, 64}});
    EXPECT_EQ(result.end, ChildResult::End::kFinished);
    return {result.output.begin(), result.output.end()};
  }
  std::string behind(std::string_view attempt) { return behind(root_ / "model" / "hair.obj", attempt); }

  bool has_fence() { return behind("the model") == "y"; }

  fs::path root_;
};

TEST_F(FileFence, ReadsTheFolderAndBelowAndNothingElse) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  for (const char* attempt : {"a texture", "the folder"}) EXPECT_EQ(behind(attempt), "y") << attempt;
  for (const char* attempt : {"a secret", "a secret from the folder", "a link that leads out", "the system's file"})
    EXPECT_EQ(behind(attempt), "n") << attempt;
}

TEST_F(FileFence, ReadsTheFileItselfWhereverItsLinkLeads) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(behind(root_ / "secret.txt", "a secret"), "y");
  EXPECT_EQ(behind(root_ / "model.obj", "a link to the model"), "y");
}

TEST_F(FileFence, NothingIsWrittenMadeMovedOrRemoved) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  for (const char* attempt : {"writing", "a new file", "a new folder", "another name", "removing", "a new link"})
    EXPECT_EQ(behind(attempt), "n") << attempt;
  EXPECT_TRUE(fs::exists(root_ / "model" / "hair.obj") && !fs::exists(root_ / "model" / "new"));
}

TEST_F(FileFence, SignalsNobodyWhereTheKernelKnowsScopes) {
  if (!has_fence()) GTEST_SKIP() << "this kernel has no Landlock";
  if (syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 6)
    GTEST_SKIP() << "Landlock before 6";
  EXPECT_EQ(behind("a signal to the parent"), "n");
  EXPECT_EQ(behind("a signal to itself"), "y");
}

TEST_F(FileFence, NeedsAFolderThatIsThere) {
  EXPECT_FALSE(fence_files({root_ / "absent"}, root_ / "secret.txt"));
  EXPECT_TRUE(opens("/etc/passwd")) << "and leaves this process as it was";
}

}  // namespace coif::platform::file_fence_test
