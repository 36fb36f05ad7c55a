#pragma once

#include <cstdint>

namespace coif {

/// While it lives, this process may add so much memory to what it has, beyond which allocations fail, and work for so long,
/// after which TookTooLong is thrown (base/work_limit.h). Memory is not limited under AddressSanitizer.
class CookLimits {
 public:
  CookLimits(std::uint64_t memory_bytes, std::uint32_t seconds, unsigned threads);
  ~CookLimits();
  CookLimits(const CookLimits&) = delete;
  CookLimits& operator=(const CookLimits&) = delete;

 private:
  std::uint64_t memory_before_ = 0;  ///< The soft limit that was in force.
};

}  // namespace coif
