#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace coif {

struct CookAllowance {
  std::uint64_t memory_bytes = 0;  ///< To add to what the process has.
  std::chrono::seconds whole{0};   ///< Of the cook.
  std::chrono::seconds pass{0};    ///< Of each pass; as long as the whole where it is not asked for.
  unsigned threads = 1;
};

/// While it lives, allocations beyond the allowance fail, and what works for longer meets TookTooLong
/// (platform/work_limit.h). Code that does not look at the clock for two seconds after that, such as a library's, meets
/// `overrun` instead, which is called on a thread of its own, once, and must end the process. Memory is not limited
/// under AddressSanitizer.
class CookLimits {
 public:
  CookLimits(const CookAllowance& allowance, std::function<void()> overrun);
  ~CookLimits();
  CookLimits(const CookLimits&) = delete;
  CookLimits& operator=(const CookLimits&) = delete;

 private:
  std::uint64_t memory_before_ = 0;  ///< The soft limit that was in force.
  std::mutex lock_;
  std::condition_variable_any ended_;
  std::jthread watch_;  ///< Last, so that it ends first.
};

}  // namespace coif
