#pragma once

#include "../lanes/lane_layout.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace coif {

/// A chain of parts with sixteen lanes each; the first lanes are in use, without a hole. There is room for all members,
/// of which some may be elsewhere (asleep), so coming back needs no memory. `Part` has `previous`, `next` and `count`.
template <typename Part>
struct DenseList {
  struct Place {
    Part* part = nullptr;
    std::uint32_t lane = 0;
  };

  /// Takes the next free lane. There must be room.
  Place push() {
    if (tip == nullptr) {
      tip = first;
    } else if (tip->count == kLanes) {
      tip = tip->next;
    }
    return {tip, tip->count++};
  }
  /// The last lane in use.
  [[nodiscard]] Place back() const { return {tip, tip->count - 1}; }
  void pop() {
    if (--tip->count == 0) tip = tip->previous;
  }
  [[nodiscard]] bool is_used() const { return tip != nullptr; }

  /// True where one more member needs one more part.
  [[nodiscard]] bool is_full() const { return members == parts * kLanes; }
  void append(Part* part) {
    part->previous = last;
    part->next = nullptr;
    (last != nullptr ? last->next : first) = part;
    last = part;
    ++parts;
  }
  /// Takes the last part out of the list, if the members have room without it and it is not in use. Else null.
  Part* take_spare() {
    if (parts == 0 || members > (parts - 1) * kLanes) return nullptr;
    Part* const spare = last;
    last = spare->previous;
    (last != nullptr ? last->next : first) = nullptr;
    --parts;
    return spare;
  }

  Part* first = nullptr;
  Part* last = nullptr;
  Part* tip = nullptr;  ///< The last part in use.
  std::uint32_t parts = 0;
  std::uint32_t members = 0;
};

/// Copies a lane of `bytes` bytes of numbers that lie sixteen side by side, of any type.
inline void copy_lane(const void* from, std::uint32_t i, void* to, std::uint32_t k, std::size_t bytes) {
  const auto* const source = static_cast<const unsigned char*>(from) + i * sizeof(float);
  auto* const goal = static_cast<unsigned char*>(to) + k * sizeof(float);
  for (std::size_t at = 0; at < bytes; at += sizeof(Lanes)) std::memcpy(goal + at, source + at, sizeof(float));
}

/// Copies a lane to a plain array with one number for every sixteen, and back.
inline void copy_lane_out(const void* from, std::uint32_t i, float* to, std::size_t bytes) {
  const auto* const source = static_cast<const unsigned char*>(from) + i * sizeof(float);
  for (std::size_t at = 0; at < bytes; at += sizeof(Lanes)) std::memcpy(to++, source + at, sizeof(float));
}
inline void copy_lane_in(const float* from, void* to, std::uint32_t k, std::size_t bytes) {
  auto* const goal = static_cast<unsigned char*>(to) + k * sizeof(float);
  for (std::size_t at = 0; at < bytes; at += sizeof(Lanes)) std::memcpy(goal + at, from++, sizeof(float));
}

/// Allocates memory at any time out of one piece that the host gave. Freed memory joins the free memory on both sides.
/// The caller of give() must pass the size. Constant time except for a walk over the gaps.
class WorldHeap {
 public:
  static constexpr std::size_t kAlignment = 64;

  WorldHeap() = default;  ///< Without memory.
  /// `memory` starts at a multiple of kAlignment.
  explicit WorldHeap(std::span<std::byte> memory);

  /// Bytes at a multiple of kAlignment, not initialised, from the smallest gap that suffices. Null where none does.
  [[nodiscard]] std::byte* take(std::size_t bytes);
  void give_back(void* memory, std::size_t bytes);

  /// The bytes that take(bytes) uses.
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
