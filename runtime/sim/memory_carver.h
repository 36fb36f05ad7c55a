#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>

namespace coif {

/// Takes arrays one after another out of one block. Without a block it only counts, so that the size announced before
/// and the memory used later come from the same calls.
class MemoryCarver {
 public:
  static constexpr std::size_t kAlignment = 64;

  /// `base`: null to count, else aligned to kAlignment and as large as a counting run says.
  explicit MemoryCarver(std::byte* base) : base_(base) {}

  /// `count` values of T, default-initialised; empty while counting.
  template <typename T>
  std::span<T> take(std::uint64_t count) {
    static_assert(alignof(T) <= kAlignment);
    T* const first = static_cast<T*>(take_zeros(count * sizeof(T)));
    if (first == nullptr) return {};
    if constexpr (!std::is_trivially_default_constructible_v<T>) {
      for (std::uint64_t i = 0; i < count; ++i) ::new (static_cast<void*>(first + i)) T{};
    }
    return {first, std::size_t(count)};
  }

  /// Uninitialised bytes; empty while counting.
  std::span<std::byte> take_raw(std::uint64_t bytes);

  /// Bytes taken, padding between arrays included.
  [[nodiscard]] std::uint64_t used() const { return used_; }

 private:
  /// Null while counting, or for no bytes.
  void* take_zeros(std::uint64_t bytes);

  std::byte* base_;
  std::uint64_t used_ = 0;
};

}  // namespace coif
