#pragma once

#include <cstddef>
#include <span>

namespace coif {

/// Memory for what comes and goes at any time, out of one piece that the host gave. What is freed joins the free memory
/// on both sides of it. Whoever frees says how much it was. Constant but for a walk over the gaps.
class WorldHeap {
 public:
  static constexpr std::size_t kAlignment = 64;

  WorldHeap() = default;  ///< Of no memory.
  /// `memory` starts at a multiple of kAlignment.
  explicit WorldHeap(std::span<std::byte> memory);

  /// Bytes at a multiple of kAlignment, not initialised; out of the smallest gap that has them. Null where none has.
  [[nodiscard]] std::byte* take(std::size_t bytes);
  void give_back(void* memory, std::size_t bytes);

  /// What take(bytes) takes.
  [[nodiscard]] static constexpr std::size_t rounded(std::size_t bytes) {
    return bytes == 0 ? kAlignment : (bytes + kAlignment - 1) / kAlignment * kAlignment;
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
