#include "cli/cook_limits.h"

#include "platform/child_process.h"
#include "platform/work_limit.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace coif {
namespace {

/// Address space that a thread reserves for its stack and its share of the heap, used or not.
constexpr std::uint64_t kBytesOfAThread = std::uint64_t{80} << 20;

constexpr std::chrono::seconds kGrace{2};

}  // namespace

CookLimits::CookLimits(const CookAllowance& allowance, std::function<void()> overrun) {
  if (kMemoryIsLimited) {
    const std::uint64_t threads = allowance.threads + 1;  // and the watch
    memory_before_ = swap_memory_limit(address_space_in_use() + allowance.memory_bytes + threads * kBytesOfAThread);
  }
  WorkLimit::set(allowance.whole, std::min(allowance.pass, allowance.whole));
  const auto end = std::chrono::steady_clock::now() + allowance.whole + kGrace;
  try {
    watch_ = std::jthread([this, end, overrun = std::move(overrun)](const std::stop_token& stop) {
      std::unique_lock guard(lock_);
      ended_.wait_until(guard, stop, end, [] { return false; });
      if (!stop.stop_requested()) overrun();
    });
  } catch (const std::system_error&) {  // No thread is to be had; what looks at the clock ends in time all the same.
  }
}

CookLimits::~CookLimits() {
  watch_ = {};
  WorkLimit::lift();
  if (kMemoryIsLimited) swap_memory_limit(memory_before_);
}

}  // namespace coif
