#pragma once

#include "lanes/lane_layout.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace coif {

/// Number of parts of sixteen lanes that suffice for so many members in any division among so many lists: each list has
/// at most one part that is not full, and at least one member.
[[nodiscard]] constexpr std::uint64_t part_count(std::uint64_t members, std::uint32_t lists) {
  if (members == 0) return 0;
  return (members + kLanes - 1) / kLanes + (lists < members ? lists : members) - 1;
}

/// The parts that several lists share. There are enough for every member, so moving one between lists needs no memory.
template <typename Part>
struct PartPool {
  Part* free = nullptr;  ///< Linked by Part::next.
  std::uint32_t parts = 0;
  std::uint32_t members = 0;

  void add(Part* part) {
    put(part);
    ++parts;
  }
  void put(Part* part) {
    part->next = free;
    free = part;
  }
  [[nodiscard]] Part* get() {
    Part* const part = free;
    free = part->next;
    return part;
  }
  /// Takes a part out of the pool that its members do not need; null where there is none.
  [[nodiscard]] Part* take_spare(std::uint32_t lists) {
    if (parts <= part_count(members, lists)) return nullptr;
    --parts;
    return get();
  }
};

/// A list of parts with sixteen lanes each; all but the last are full. `Part` has `previous`, `next` and `count`.
template <typename Part>
struct DenseList {
  struct Place {
    Part* part = nullptr;
    std::uint32_t lane = 0;
  };

  Part* first = nullptr;
  Part* last = nullptr;

  [[nodiscard]] bool is_full() const { return last == nullptr || last->count == kLanes; }
  /// The last lane in use.
  [[nodiscard]] Place back() const { return {last, last->count - 1}; }
  /// Takes the next free lane.
  Place push(PartPool<Part>& pool) {
    if (is_full()) append(pool.get());
    return {last, last->count++};
  }
  void pop(PartPool<Part>& pool) {
    if (--last->count == 0) pool.put(remove_last());
  }
  void append(Part* part) {
    part->previous = last;
    part->next = nullptr;
    (last != nullptr ? last->next : first) = part;
    last = part;
  }
  Part* remove_last() {
    Part* const gone = last;
    last = gone->previous;
    (last != nullptr ? last->next : first) = nullptr;
    return gone;
  }
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

}  // namespace coif
