#include "cli/cook_limits.h"

#include "base/work_limit.h"
#include "process/child_process.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>

namespace coif {
namespace {

/// Address space that a thread reserves for its stack and its share of the heap, used or not.
constexpr std::uint64_t kBytesOfAThread = std::uint64_t{80} << 20;

std::uint64_t swap_memory_limit(std::uint64_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  const std::uint64_t before = limit.rlim_cur;
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
  return before;
}

}  // namespace

CookLimits::CookLimits(std::uint64_t memory_bytes, std::uint32_t seconds, unsigned threads) {
  if (kMemoryIsLimited) {
    memory_before_ = swap_memory_limit(address_space_in_use() + memory_bytes + threads * kBytesOfAThread);
  }
  WorkLimit::set(std::chrono::seconds(seconds));
}

CookLimits::~CookLimits() {
  WorkLimit::lift();
  if (kMemoryIsLimited) swap_memory_limit(memory_before_);
}

}  // namespace coif
