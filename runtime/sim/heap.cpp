#include "heap.h"

#include "memory_carver.h"

#include <cstring>
#include <new>

namespace coif {
namespace {

/// Bytes from `at` to the next multiple of `alignment`.
std::size_t bytes_before(const void* at, std::size_t alignment) {
  return (alignment - reinterpret_cast<std::uintptr_t>(at) % alignment) % alignment;
}

}  // namespace

WorldHeap::Gap* WorldHeap::make_gap(std::byte* at, std::size_t bytes, Gap* next) {
  static_assert(sizeof(Gap) <= kGrain);
  return ::new (static_cast<void*>(at)) Gap{bytes, next};
}

WorldHeap::WorldHeap(std::span<std::byte> memory) {
  const std::size_t bytes = memory.size() / kGrain * kGrain;
  if (bytes != 0) first_ = make_gap(memory.data(), bytes, nullptr);
}

std::byte* WorldHeap::take(std::size_t bytes, std::size_t alignment) {
  bytes = rounded(bytes, kGrain);
  Gap** best = nullptr;
  for (Gap** link = &first_; *link != nullptr; link = &(*link)->next) {
    const bool fits = (*link)->bytes >= bytes_before(*link, alignment) + bytes;
    if (fits && (best == nullptr || (*link)->bytes < (*best)->bytes)) best = link;
    if (fits && (*link)->bytes == bytes) break;
  }
  if (best == nullptr) return nullptr;
  Gap* const gap = *best;
  const std::size_t before = bytes_before(gap, alignment), after = gap->bytes - before - bytes;
  auto* const memory = reinterpret_cast<std::byte*>(gap) + before;
  Gap* next = gap->next;
  if (after != 0) next = make_gap(memory + bytes, after, next);
  *best = before != 0 ? make_gap(memory - before, before, next) : next;
  return memory;
}

void WorldHeap::give_back(void* memory, std::size_t bytes) {
  auto* const begin = static_cast<std::byte*>(memory);
  bytes = rounded(bytes, kGrain);
  Gap* before = nullptr;
  Gap* after = first_;
  while (after != nullptr && reinterpret_cast<std::byte*>(after) < begin) {
    before = after;
    after = after->next;
  }
  if (after != nullptr && begin + bytes == reinterpret_cast<std::byte*>(after)) {
    bytes += after->bytes;
    after = after->next;
  }
  if (before != nullptr && reinterpret_cast<std::byte*>(before) + before->bytes == begin) {
    before->bytes += bytes;
    before->next = after;
    return;
  }
  Gap* const gap = make_gap(begin, bytes, after);
  (before != nullptr ? before->next : first_) = gap;
}

std::span<std::byte> MemoryCarver::take_raw(std::uint64_t bytes) {
  used_ = (used_ + kAlignment - 1) / kAlignment * kAlignment;
  const std::uint64_t begin = used_;
  used_ += bytes;
  return base_ == nullptr ? std::span<std::byte>{} : std::span(base_ + begin, std::size_t(bytes));
}

void* MemoryCarver::take_zeros(std::uint64_t bytes) {
  const std::span<std::byte> taken = take_raw(bytes);
  if (taken.empty()) return nullptr;
  return std::memset(taken.data(), 0, taken.size());
}

}  // namespace coif
