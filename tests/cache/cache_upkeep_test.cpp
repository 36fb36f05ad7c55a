#include "cache/cook_cache.h"

#include "platform/files.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <functional>
#include <thread>

namespace coif::cache::cache_upkeep_test {

namespace fs = std::filesystem;
using std::chrono::hours;

/// A cache of entries of a thousand bytes each, number n used n hours ago.
class CacheUpkeep : public testing::Test {
 protected:
  CacheUpkeep() : folder_(fs::path(testing::TempDir()) / ("coif_cache_upkeep_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    for (int n = 0; n < 5; ++n) add(n);
  }
  ~CacheUpkeep() override { fs::remove_all(folder_); }

  fs::path entry(int n) const {
    const std::string key(32, char('a' + n));
    return folder_ / key.substr(0, 2) / key.substr(2) / (std::string(32, '0') + ".entry");
  }
  static void write(const fs::path& path, std::size_t bytes, hours age) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << std::string(bytes, 'x');
    fs::last_write_time(path, fs::file_time_type::clock::now() - age);
  }
  void add(int n) const { write(entry(n), 1000, hours(n)); }
  CacheUsage usage() const {
    const auto found = cache_usage(folder_);
    EXPECT_TRUE(found);
    return found.value_or(CacheUsage{});
  }

  fs::path folder_;
};

TEST_F(CacheUpkeep, CountsEntriesAndWhenTheyWereUsed) {
  write(entry(1).parent_path() / (std::string(32, '1') + ".entry"), 500, hours(30));
  const CacheUsage found = usage();
  EXPECT_EQ(found.keys, 5u);
  EXPECT_EQ(found.entries, 6u);
  EXPECT_EQ(found.bytes, 5500u);
  EXPECT_EQ(found.leftovers, 0u);
  ASSERT_TRUE(found.oldest_use && found.newest_use);
  EXPECT_EQ(std::chrono::round<hours>(*found.newest_use - *found.oldest_use), hours(30));
}

TEST_F(CacheUpkeep, RemovesTheLeastRecentlyUsedUntilTheRestFits) {
  const auto trimmed = trim_cache(folder_, 2999);
  ASSERT_TRUE(trimmed);
  EXPECT_EQ(trimmed->entries, 3u);
  EXPECT_EQ(trimmed->bytes, 3000u);
  for (int n = 0; n < 5; ++n) EXPECT_EQ(fs::exists(entry(n)), n < 2) << n;
  EXPECT_FALSE(fs::exists(entry(4).parent_path().parent_path())) << "nor its folders";
  EXPECT_EQ(trim_cache(folder_, 2000)->entries, 0u) << "as much as is allowed";
  EXPECT_EQ(trim_cache(folder_, 0)->entries, 2u);
  EXPECT_TRUE(fs::exists(folder_));
}

TEST_F(CacheUpkeep, RemovesWhatKilledCooksLeft) {
  const fs::path old = entry(0).string() + ".4711.0123abcd.tmp", fresh = entry(0).string() + ".4712.0123abcd.tmp";
  write(old, 10, hours(25));
  write(fresh, 10, hours(23));  // somebody may be writing it
  EXPECT_EQ(usage().leftovers, 1u);
  EXPECT_EQ(usage().leftover_bytes, 10u);
  EXPECT_EQ(trim_cache(folder_, 1u << 30)->leftovers, 1u);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(fresh));
}

TEST_F(CacheUpkeep, LeavesAloneWhatNoCacheWrote) {
  const fs::path others[] = {folder_ / "notes.entry",
                             folder_ / "aa" / "notes.entry",
                             folder_ / "zz" / std::string(30, 'a') / (std::string(32, '0') + ".entry"),
                             entry(0).parent_path() / "notes.entry",
                             entry(0).parent_path() / (std::string(31, '0') + ".entry"),
                             entry(0).parent_path() / (std::string(32, '0') + ".tmp.bak")};
  for (const fs::path& path : others) write(path, 7, hours(1000));
  EXPECT_EQ(usage().entries, 5u);
  ASSERT_TRUE(trim_cache(folder_, 0));
  EXPECT_EQ(usage().entries, 0u);
  for (const fs::path& path : others) EXPECT_TRUE(fs::exists(path)) << path;
}

TEST_F(CacheUpkeep, AFolderThatIsNotThereIsAnError) {
  const auto found = cache_usage(folder_ / "gone");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, ToolError::Kind::kFileAccess);
  EXPECT_NE(found.error().message.find("gone: cannot read the cache: No such file"), std::string::npos)
      << found.error().message;
  EXPECT_FALSE(trim_cache(folder_ / "gone", 0));
}

// Whoever cooks meanwhile finds what it stored or nothing, and can always store.
TEST_F(CacheUpkeep, CooksGoOnWhileItIsTrimmed) {
  const fs::path source = folder_ / "wig.obj";
  std::ofstream(source) << "model";
  const CookPlace place{source, folder_};
  cook::CookResult result;
  result.asset.assign(4096, std::byte{7});
  std::atomic<bool> is_done = false;
  std::thread trimmer([&] {
    while (!is_done) EXPECT_TRUE(trim_cache(folder_, 0));
  });
  std::size_t found = 0, failed = 0;
  const CookCache cache(folder_);
  for (int n = 0; n < 400; ++n) {
    const std::string key = content_digits(std::as_bytes(std::span(&n, 1)));
    failed += !cache.store(key, place, result, platform::file_clock_now() + hours(1));
    if (const auto entry = cache.find(key, place)) {
      ++found;
      EXPECT_EQ(entry->asset, result.asset);
    }
  }
  is_done = true;
  trimmer.join();
  // Twice in a row its folder may go between being made and being used; that costs a warning.
  EXPECT_LT(failed, 20u);
  EXPECT_LE(found, 400u);
}

}  // namespace coif::cache::cache_upkeep_test
