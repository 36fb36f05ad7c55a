#include "view/server/latest_work.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <vector>

namespace coif::view::latest_work_test {
namespace {

using namespace std::chrono_literals;

/// Work that lasts until it is let go or asked to stop, and notes what was done.
struct Bench {
  std::mutex lock;
  std::condition_variable_any changed;
  std::vector<std::uint64_t> begun, ended_in_time;
  int at_once = 0, most_at_once = 0;
  bool is_let_go = false;

  void work(std::uint64_t number, const std::stop_token& stop) {
    std::unique_lock guard(lock);
    begun.push_back(number);
    most_at_once = std::max(most_at_once, ++at_once);
    changed.notify_all();
    changed.wait(guard, stop, [&] { return is_let_go; });
    if (!stop.stop_requested()) ended_in_time.push_back(number);
    --at_once;
    changed.notify_all();
  }
  LatestWork::Work function() {
    return [this](std::uint64_t number, const std::stop_token& stop) { work(number, stop); };
  }
  template <typename Ready>
  bool wait(const Ready& ready) {
    std::unique_lock guard(lock);
    return changed.wait_for(guard, 10s, ready);
  }
  void let_go() {
    const std::lock_guard guard(lock);
    is_let_go = true;
    changed.notify_all();
  }
};

TEST(LatestWork, DoesWhatIsAskedOnce) {
  Bench bench;
  bench.is_let_go = true;
  LatestWork work(bench.function());
  EXPECT_EQ(work.ask(), 1u);
  EXPECT_TRUE(bench.wait([&] { return bench.ended_in_time.size() == 1; }));
  EXPECT_EQ(work.ask(), 2u);
  EXPECT_TRUE(bench.wait([&] { return bench.ended_in_time.size() == 2; }));
  EXPECT_EQ(bench.begun, (std::vector<std::uint64_t>{1, 2}));
}

TEST(LatestWork, TheLatestMakesTheOthersObsolete) {
  Bench bench;
  LatestWork work(bench.function());
  work.ask();
  ASSERT_TRUE(bench.wait([&] { return bench.begun.size() == 1; }));
  std::uint64_t last = 0;
  for (int i = 0; i < 100; ++i) last = work.ask();
  bench.let_go();
  ASSERT_TRUE(bench.wait([&] { return !bench.ended_in_time.empty() && bench.ended_in_time.back() == last; }));
  EXPECT_EQ(bench.ended_in_time, std::vector<std::uint64_t>{last});
  EXPECT_EQ(bench.most_at_once, 1);
}

TEST(LatestWork, EndsWhatItIsDoing) {
  Bench bench;
  const auto begin = std::chrono::steady_clock::now();
  {
    LatestWork work(bench.function());
    work.ask();
    ASSERT_TRUE(bench.wait([&] { return bench.begun.size() == 1; }));
  }
  EXPECT_EQ(bench.at_once, 0);
  EXPECT_TRUE(bench.ended_in_time.empty());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

}  // namespace
}  // namespace coif::view::latest_work_test
