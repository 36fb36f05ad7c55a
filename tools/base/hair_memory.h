#pragma once

// Memory that a tool gives the runtime.

#include <coif/hair.h>

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace coif {

using HairMemory = std::unique_ptr<std::byte, decltype(&std::free)>;

/// As large and as aligned as Hair::create() asks for; null where it cannot be had.
[[nodiscard]] inline HairMemory allocate(const MemoryNeed& need) {
  const std::size_t units = need.bytes == 0 ? 1 : (need.bytes + need.alignment - 1) / need.alignment;
  return {static_cast<std::byte*>(std::aligned_alloc(need.alignment, units * need.alignment)), &std::free};
}

}  // namespace coif
