#include "cli/cook_limits.h"

#include "platform/child_process.h"
#include "platform/work_limit.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <new>
#include <thread>

namespace coif::cook_limits_test {

using std::chrono::seconds;

CookAllowance allowance(seconds whole) { return {std::uint64_t{64} << 20, whole, whole, 1}; }

TEST(CookLimits, BoundMemoryAndTimeWhileTheyLive) {
  const auto take = [](std::size_t megabytes) { return std::make_unique<char[]>(megabytes << 20); };
  {
    const CookLimits limits(allowance(seconds(0)), [] { std::abort(); });
    EXPECT_THROW(WorkLimit::check(), TookTooLong);
    if (kMemoryIsLimited) {
      EXPECT_THROW(take(1024), std::bad_alloc);
    }
  }
  EXPECT_NO_THROW(WorkLimit::check());
  EXPECT_NO_THROW(take(1024));
}

// What never looks at the clock is ended from outside, and not before it had time to look.
TEST(CookLimits, EndWhatDoesNotLookAtTheClock) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EXIT(
      {
        const CookLimits limits(allowance(seconds(0)), [] { std::_Exit(3); });
        std::this_thread::sleep_for(seconds(100));
      },
      testing::ExitedWithCode(3), "");
  EXPECT_GT(std::chrono::steady_clock::now() - begin, seconds(1));
}

}  // namespace coif::cook_limits_test
