#include "platform/scratch_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace coif::scratch_folder_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

bool goes(const fs::path& path) {
  for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end;
       std::this_thread::sleep_for(2ms)) {
    if (!fs::exists(path)) return true;
  }
  return false;
}

TEST(ScratchFolder, GoesWithItsObject) {
  fs::path path;
  {
    auto folder = ScratchFolder::create();
    ASSERT_TRUE(folder) << folder.error().why.message();
    const ScratchFolder moved = std::move(*folder);
    path = moved.path();
    struct stat facts {};
    ASSERT_EQ(stat(path.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, 0700u) << "nobody else's";
    std::ofstream(path / "model.glb") << "bytes";
  }
  EXPECT_FALSE(fs::exists(path)) << "at once";
}

TEST(ScratchFolder, GoesWhenItsProcessIsKilled) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t owner = fork();
  if (owner == 0) {
    auto folder = ScratchFolder::create();
    const std::string path = folder->path().string();
    std::ofstream(folder->path() / "model.glb") << "bytes";
    if (write(ends[1], path.data(), path.size()) < 0) _exit(1);
    close(ends[1]);
    for (;;) pause();
  }
  close(ends[1]);
  char text[4096];
  const ssize_t length = read(ends[0], text, sizeof text);
  ASSERT_GT(length, 0);
  const fs::path path(std::string(text, std::size_t(length)));
  ASSERT_TRUE(fs::exists(path / "model.glb"));
  kill(owner, SIGKILL);
  EXPECT_TRUE(goes(path));
  waitpid(owner, nullptr, 0);
  close(ends[0]);
}

TEST(ScratchFolder, SaysWhereNoneCanBe) {
  const char* const before = getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  setenv("TMPDIR", "/nonexistent/folder", 1);
  const auto folder = ScratchFolder::create();
  before != nullptr ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().place, "TMPDIR");
  EXPECT_TRUE(folder.error().why);
}

}  // namespace
}  // namespace coif::scratch_folder_test
