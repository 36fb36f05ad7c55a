#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Allocates memory at any time out of one piece that the host gave. Freed memory joins the free memory on both sides.
/// The caller of give_back() must pass the size. Constant time except for a walk over the gaps.
class WorldHeap {
 public:
  static constexpr std::size_t kAlignment = 64;
  static constexpr std::size_t kGrain = 16;  ///< All sizes and places are multiples of it.

  WorldHeap() = default;  ///< Without memory.
  /// `memory` starts at a multiple of kAlignment.
  explicit WorldHeap(std::span<std::byte> memory);

  /// Bytes at a multiple of `alignment` (kGrain or kAlignment), not initialised, from the smallest gap that suffices.
  /// Null where none does.
  [[nodiscard]] std::byte* take(std::size_t bytes, std::size_t alignment = kAlignment);
  void give_back(void* memory, std::size_t bytes);

  /// The most bytes that take(bytes) with kAlignment can cost: those in front of the place may be too few for others.
  [[nodiscard]] static constexpr std::uint64_t most(std::size_t bytes) {
    return rounded(bytes, kGrain) + kAlignment - kGrain;
  }
  [[nodiscard]] static constexpr std::size_t rounded(std::size_t bytes, std::size_t alignment = kAlignment) {
    return bytes == 0 ? alignment : (bytes + alignment - 1) / alignment * alignment;
  }

 private:
  /// Lies in the free memory itself, in the order of addresses.
  struct Gap {
    std::size_t bytes;
    Gap* next;
  };
  static Gap* make_gap(std::byte* at, std::size_t bytes, Gap* next);

  Gap* first_ = nullptr;
};

}  // namespace coif
