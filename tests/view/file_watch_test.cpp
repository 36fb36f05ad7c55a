#include "view/server/live_cook.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <string>

namespace coif::view::file_watch_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Files = std::vector<fs::path>;

class FileWatchTest : public testing::Test {
 protected:
  FileWatchTest() { fs::create_directories(folder_); }
  ~FileWatchTest() override { fs::remove_all(folder_); }

  fs::path write(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// Clocks of file systems are coarse.
  static void make_later(const fs::path& file) { fs::last_write_time(file, fs::last_write_time(file) + 1s); }

  fs::path folder_ = fs::temp_directory_path() / ("coif_file_watch_test." + std::to_string(getpid()));
  FileWatch watch_;
};

TEST_F(FileWatchTest, TellsWhatWasWrittenAppearedOrWent) {
  const fs::path still = write("still", "a"), written = write("written", "a"), longer = write("longer", "a"),
                 gone = write("gone", "a"), appears = folder_ / "appears";
  watch_.watch(Files{still, written, longer, gone, appears}, FileWatch::Time::max());
  EXPECT_TRUE(watch_.changed().empty());

  make_later(written);
  const auto time = fs::last_write_time(longer);
  write("longer", "ab");
  fs::last_write_time(longer, time);
  fs::remove(gone);
  write("appears", "");
  EXPECT_EQ(watch_.changed(), (Files{appears, gone, longer, written}));
  EXPECT_TRUE(watch_.changed().empty()) << "each change once";
}

TEST_F(FileWatchTest, ReplacedFilesAreChanged) {
  const fs::path file = write("model", "a");
  watch_.watch(Files{file}, FileWatch::Time::max());
  make_later(write("model.new", "b"));
  fs::rename(folder_ / "model.new", file);
  EXPECT_EQ(watch_.changed(), Files{file});
}

TEST_F(FileWatchTest, NewFilesAreChangedWhereTheyWereWrittenSince) {
  const fs::path before = write("before", "a"), since = write("since", "a"), known = write("known", "a");
  const auto begin = fs::last_write_time(since);
  fs::last_write_time(since, begin + 2s);
  fs::last_write_time(before, begin - 2s);
  fs::last_write_time(known, begin + 2s);
  watch_.watch(Files{known}, FileWatch::Time::max());
  watch_.watch(Files{before, since, known}, begin);
  EXPECT_EQ(watch_.changed(), Files{since});
  EXPECT_TRUE(watch_.changed().empty());
}

TEST_F(FileWatchTest, KnowsOfChangesWhileTheListIsMade) {
  const fs::path file = write("file", "a");
  watch_.watch(Files{file}, FileWatch::Time::max());
  make_later(file);
  watch_.watch(Files{file, folder_ / "other"}, FileWatch::Time::max());
  EXPECT_EQ(watch_.changed(), Files{file}) << "watching anew forgets nothing";
  watch_.watch(Files{}, FileWatch::Time::max());
  make_later(file);
  EXPECT_TRUE(watch_.changed().empty());
}

}  // namespace
}  // namespace coif::view::file_watch_test
