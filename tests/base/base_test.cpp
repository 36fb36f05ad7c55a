#include "base/encodings.h"
#include "base/files.h"
#include "base/geometry.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "base/timing.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace coif::base_test {

std::vector<std::string> synced;  ///< Paths of what was written through to the disk.
bool is_killed_at_sync = false;   ///< The process ends when a file is about to be.

}  // namespace coif::base_test

/// In place of the library's, which it calls.
extern "C" int fsync(int descriptor) {
  if (coif::base_test::is_killed_at_sync) ::raise(SIGKILL);
  std::error_code error;
  coif::base_test::synced.push_back(std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", descriptor), error));
  return int(::syscall(SYS_fsync, descriptor));
}

namespace coif::base_test {

TEST(ParallelFor, CallsEachOnceWhateverTheThreads) {
  for (const unsigned threads : {0u, 1u, 3u, 64u}) {
    std::vector<int> calls(20, 0);
    parallel_for(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(std::ranges::count(calls, 1), 20) << threads;
  }
  parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, WhatACallThrowsArrives) {
  for (const unsigned threads : {1u, 4u}) {
    std::atomic<int> calls = 0;
    const auto body = [&](std::size_t i) {
      ++calls;
      if (i == 3) throw std::bad_alloc();
    };
    EXPECT_THROW(parallel_for(10'000'000, threads, body), std::bad_alloc) << threads;
    EXPECT_LT(calls, 10'000'000) << "the others go on";
  }
}

TEST(ParallelFor, EndsWhenAskedToStop) {
  for (const unsigned count : {1u, 4u}) {
    std::stop_source stop;
    std::atomic<int> calls = 0;
    const auto body = [&](std::size_t) {
      if (++calls == 10) stop.request_stop();
    };
    EXPECT_THROW(parallel_for(10'000'000, {count, stop.get_token()}, body), platform::Stopped) << count;
    EXPECT_LE(calls, 10 + int(count)) << "no further call begins";
    EXPECT_THROW(parallel_for(1, {count, stop.get_token()}, body), platform::Stopped);
    EXPECT_NO_THROW(parallel_for(0, {count, stop.get_token()}, body));
  }
}

TEST(Threads, AreAtLeastOneAndKeepTheirToken) {
  std::stop_source stop;
  const platform::Threads threads(8, stop.get_token());
  EXPECT_EQ(threads.divided_by(3).count, 2u);
  EXPECT_EQ(threads.divided_by(0).count, 8u);
  EXPECT_EQ(threads.divided_by(20).count, 1u);
  EXPECT_EQ(platform::Threads(0).count, 1u);
  stop.request_stop();
  EXPECT_THROW(platform::throw_if_stopped(threads.divided_by(2).stop), platform::Stopped);
  EXPECT_NO_THROW(platform::throw_if_stopped(platform::Threads().stop));
}

TEST(SamplesAround, IsTheRectangleOfTheWidestView) {
  const Eigen::Vector3f a(0, 0, 0), b(0.3f, 0, 0), c(0, 0.1f, 0.02f);
  EXPECT_NEAR(samples_around(a, b, c, 0.01), 31 * 11, 0.01);
  EXPECT_NEAR(samples_around(c, a, b, 0.01), 31 * 11, 0.01);
  EXPECT_NEAR(samples_around(a, a, a, 0.01), 1, 1e-9);
}

TEST(SpreadInSquare, NoneOfTheFirstSoManyLiesNearAnother) {
  std::vector<Eigen::Vector2d> points;
  double nearest = 1;
  for (std::size_t n = 1; n <= 1000; ++n) {
    const Eigen::Vector2d point = spread_in_square(n);
    EXPECT_GE(point.minCoeff(), 0);
    EXPECT_LT(point.maxCoeff(), 1);
    for (const Eigen::Vector2d& other : points) {
      const Eigen::Array2d way = (point - other).array().abs();
      nearest = std::min(nearest, way.min(1 - way).matrix().norm());
    }
    points.push_back(point);
    if (n > 1) {
      ASSERT_GT(nearest, 0.5 / std::sqrt(double(n))) << n << " points";
    }
  }
}

TEST(SpreadInTriangle, FillsItEvenly) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t n = 1; n <= 1000; ++n) {
    const Eigen::Vector2d point = spread_in_triangle(n);
    EXPECT_GE(point.minCoeff(), 0);
    EXPECT_LE(point.sum(), 1);
    sum += point / 1000;
  }
  EXPECT_NEAR(sum.x(), 1.0 / 3, 0.005);
  EXPECT_NEAR(sum.y(), 1.0 / 3, 0.005);
}

TEST(WriteOutput, ClearsAwayWhatAKilledProcessLeftOfTheSameFile) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("coif_write_output_{}", ::getpid());
  fs::create_directories(folder);
  const auto make = [&](const char* name, std::chrono::hours age) {
    std::ofstream(folder / name) << "half";
    fs::last_write_time(folder / name, fs::file_time_type::clock::now() - age);
  };
  constexpr auto kOld = std::chrono::hours(2), kNew = std::chrono::hours(0);
  make("bob.coif.4711.0123abcd.tmp", kOld);
  make("bob.coif.4712.0123abcd.tmp", kNew);   // somebody may be writing it
  make("long.coif.4711.0123abcd.tmp", kOld);  // another output's
  make("bob.coif.notes.tmp", kOld);           // somebody's own
  make("bob.coif.4711.0123abcd.tmp.tmp", kOld);
  ASSERT_TRUE(write_output(folder / "bob.coif", std::as_bytes(std::span("whole"))));
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder)) left.insert(entry.path().filename());
  const std::set<std::string> expected{"bob.coif", "bob.coif.4712.0123abcd.tmp", "long.coif.4711.0123abcd.tmp",
                                       "bob.coif.notes.tmp", "bob.coif.4711.0123abcd.tmp.tmp"};
  EXPECT_EQ(left, expected);
  fs::remove_all(folder);
}

TEST(WriteOutput, WaitsForTheDiskWhereThatIsAsked) {
  namespace fs = std::filesystem;
  const fs::path file = fs::path(testing::TempDir()) / fmt::format("coif_durable_{}", ::getpid());
  synced = {};
  ASSERT_TRUE(write_output(file, std::as_bytes(std::span("soon"))));
  EXPECT_TRUE(synced.empty());
  ASSERT_TRUE(write_output(file, std::as_bytes(std::span("now")), platform::Durability::kNow));
  // The file before it has its name, then the folder that holds the name.
  ASSERT_EQ(synced.size(), 2u);
  const bool had_no_name = synced[0].starts_with(fs::canonical(testing::TempDir()).string() + "/#");
  EXPECT_TRUE(had_no_name || synced[0].starts_with(file.string() + ".")) << synced[0];
  EXPECT_EQ(synced[1], fs::canonical(testing::TempDir()).string());
  fs::remove(file);
}

TEST(Files, OutputsAreNoInputs) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("coif_check_output_{}", ::getpid());
  fs::create_directories(folder / "below");
  std::ofstream(folder / "hair.png") << "pixels";
  fs::create_hard_link(folder / "hair.png", folder / "hard.png");
  fs::create_symlink("hair.png", folder / "soft.png");
  const std::vector<fs::path> inputs{folder / "hair.obj", folder / "below/../hair.png", folder / "absent.png",
                                     fs::path()};
  for (const char* output :
       {"hair.png", "hard.png", "soft.png", "below/../hair.png", "absent.png", "below/../absent.png"}) {
    const auto checked = check_output(folder / output, inputs);
    ASSERT_FALSE(checked) << output;
    EXPECT_EQ(checked.error().kind, ToolError::Kind::kUsage);
    EXPECT_NE(checked.error().message.find("is also an input"), std::string::npos) << checked.error().message;
  }
  EXPECT_TRUE(check_output(folder / "hair.coif", inputs));
  EXPECT_FALSE(check_output("-", inputs));
  const NamedOutput same[] = {{"--output", folder / "a"}, {"--report", {}}, {"--depfile", folder / "below/../a"}};
  const auto checked = check_outputs(same, inputs);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().message, "--depfile and --output name the same file");
  fs::remove_all(folder);
}

TEST(Files, KilledWritersLeaveNothing) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("coif_killed_writer_{}", ::getpid());
  fs::create_directories(folder);
  const int probe = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (probe < 0) GTEST_SKIP() << "this file system has no files without a name";
  ::close(probe);
  std::ofstream(folder / "hair.coif") << "before";
  const pid_t child = ::fork();
  if (child == 0) {
    is_killed_at_sync = true;
    (void)write_output(folder / "hair.coif", std::as_bytes(std::span("after")), platform::Durability::kNow);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  std::string text;
  std::ifstream(folder / "hair.coif") >> text;
  EXPECT_EQ(text, "before");
  fs::remove_all(folder);
}

TEST(Files, NamesOfAnyLengthAreWritten) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("coif_long_names_{}", ::getpid());
  fs::create_directories(folder);
  const std::string name(255, 'n');
  for (int round = 0; round < 2; ++round) {
    const auto written = write_output(folder / name, std::as_bytes(std::span("whole")));
    ASSERT_TRUE(written) << written.error().message;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  EXPECT_FALSE(write_output(folder / (name + "n"), std::as_bytes(std::span("whole"))));
  fs::remove_all(folder);
}

TEST(Text, TerminalsGetNothingToObey) {
  EXPECT_EQ(printable_text("a\x1b[2Jb\x7f\xc2\x9b"
                           "2J\n\xc2\xa0\xc3\xa9"),
            "a?[2Jb??2J \xc2\xa0\xc3\xa9");
}

TEST(PrintableText, KeepsTextInEveryScript) { EXPECT_EQ(printable_text("Zöpfe 髪 \U0001F487"), "Zöpfe 髪 \U0001F487"); }

TEST(PrintableText, ReplacesControlCharacters) { EXPECT_EQ(printable_text("a\nb\tc\x1b[0m\x7f"), "a b c?[0m?"); }

TEST(PrintableText, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable_text("\x94\xaf"), "??");            // Shift-JIS
  EXPECT_EQ(printable_text("\xC0\x80x"), "??x");          // overlong
  EXPECT_EQ(printable_text("\xED\xA0\x80"), "???");       // surrogate
  EXPECT_EQ(printable_text("\xF4\x90\x80\x80"), "????");  // beyond Unicode
  EXPECT_EQ(printable_text("x\xE9\xAB"), "x??");          // cut short
}

TEST(PrintableText, CutsBetweenCharacters) {
  EXPECT_EQ(printable_text("ab髪", 4), "ab");
  EXPECT_EQ(printable_text("ab髪", 5), "ab髪");
}

TEST(Base64, ComesBackWithAndWithoutPadding) {
  for (const char* text : {"", "f", "fo", "foo", "foob", "\xFB\xFF\xFE?"}) {
    const std::vector<std::uint8_t> bytes(text, text + std::strlen(text));
    std::string coded = base64(bytes);
    for (int padding = 0; padding < 2; ++padding) {
      const auto back = from_base64(coded);
      ASSERT_TRUE(back) << coded;
      EXPECT_TRUE(std::ranges::equal(*back, std::as_bytes(std::span(bytes)))) << coded;
      while (coded.ends_with('=')) coded.pop_back();
    }
  }
  EXPECT_FALSE(from_base64("Zm9v YmFy"));
  EXPECT_FALSE(from_base64("Zm=9"));
}

TEST(DecodedUri, TakesTwoDigitsOfEitherCaseAndLeavesTheRest) {
  EXPECT_EQ(decoded_uri("a%20b%2Fc%2fd"), "a b/c/d");
  EXPECT_EQ(decoded_uri("100%"), "100%");
  EXPECT_EQ(decoded_uri("%4"), "%4");
  EXPECT_EQ(decoded_uri("%g1%1g"), "%g1%1g");
}

TEST(Timing, MedianAndSpreadDoNotHearOneWildSample) {
  const Timing timing = SideBySideTiming::summarize({1000, 5, 4, 3, 6});
  EXPECT_EQ(timing.seconds, 5);
  EXPECT_DOUBLE_EQ(timing.spread_pct, 40);  // 4 to 6
  EXPECT_EQ(timing.rounds, 5u);
}

TEST(Timing, NothingMeasuredIsZero) {
  EXPECT_EQ(SideBySideTiming::summarize({}).rounds, 0u);
  EXPECT_EQ(SideBySideTiming::summarize({0, 0}).spread_pct, 0);
}

TEST(Timing, EveryWorkHasItsTurnInEveryRound) {
  // Batches of no length: one run to find that out, then one a round.
  unsigned runs[2] = {};
  const std::function<void()> works[] = {[&] { ++runs[0]; }, [&] { ++runs[1]; }};
  const auto timings = SideBySideTiming({.seconds = 0, .least_rounds = 7, .batch_seconds = 0}).run(works);
  ASSERT_EQ(timings.size(), 2u);
  for (const Timing& timing : timings) EXPECT_EQ(timing.rounds, 7u);
  EXPECT_EQ(runs[0], 8u);
  EXPECT_EQ(runs[1], 8u);
}

TEST(Timing, ShortWorkIsRepeatedUntilTheClockCanTell) {
  unsigned runs = 0;
  const std::function<void()> work[] = {[&] { ++runs; }};
  const auto timing = SideBySideTiming({.seconds = 0, .least_rounds = 1, .batch_seconds = 1e-4}).run(work).front();
  EXPECT_GT(runs, 100u);
  EXPECT_LT(timing.seconds, 1e-4);
}

TEST(Timing, EndsAfterTheMostRoundsHoweverMuchTimeThereIs) {
  const std::function<void()> work[] = {[] {}};
  const auto timing = SideBySideTiming({.seconds = 1e9, .most_rounds = 9, .batch_seconds = 0}).run(work).front();
  EXPECT_EQ(timing.rounds, 9u);
}

}  // namespace coif::base_test
