#include "platform/files.h"

#include "platform/child_process.h"
#include "platform/stop.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace coif::platform::scratch_folder_test {
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

/// Tells where its folder is, and waits for ever.
const Job kOwner("test.owner of a folder", [](const JobCall& call) -> Bytes {
  const auto folder = ScratchFolder::create();
  if (!folder) return {};
  std::ofstream(folder->path() / "model.glb") << "bytes";
  call.note(folder->path().string());
  for (;;) pause();
});

TEST(ScratchFolder, GoesWhenItsProcessIsKilled) {
  fs::path path;
  bool was_there = false;
  std::stop_source stop;
  const auto kill_owner = [&](std::string_view note) {
    path = note;
    was_there = fs::exists(path / "model.glb");
    stop.request_stop();
  };
  EXPECT_THROW((void)run_in_child(kOwner, {}, {ChildKind::kWorker, {}, stop.get_token(), kill_owner}), Stopped);
  ASSERT_TRUE(was_there) << path;
  EXPECT_TRUE(goes(path));
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
}  // namespace coif::platform::scratch_folder_test
