#include "dense_list.h"

#include <new>

namespace coif {

WorldHeap::Gap* WorldHeap::make_gap(std::byte* at, std::size_t bytes, Gap* next) {
  return ::new (static_cast<void*>(at)) Gap{bytes, next};
}

WorldHeap::WorldHeap(std::span<std::byte> memory) {
  const std::size_t bytes = memory.size() / kAlignment * kAlignment;
  if (bytes != 0) first_ = make_gap(memory.data(), bytes, nullptr);
}

std::byte* WorldHeap::take(std::size_t bytes) {
  bytes = rounded(bytes);
  Gap** best = nullptr;
  for (Gap** link = &first_; *link != nullptr; link = &(*link)->next) {
    const bool fits = (*link)->bytes >= bytes;
    if (fits && (best == nullptr || (*link)->bytes < (*best)->bytes)) best = link;
    if (fits && (*link)->bytes == bytes) break;
  }
  if (best == nullptr) return nullptr;
  Gap* const gap = *best;
  auto* const memory = reinterpret_cast<std::byte*>(gap);
  const std::size_t left = gap->bytes - bytes;
  Gap* const next = gap->next;
  *best = left != 0 ? make_gap(memory + bytes, left, next) : next;
  return memory;
}

void WorldHeap::give_back(void* memory, std::size_t bytes) {
  auto* const begin = static_cast<std::byte*>(memory);
  bytes = rounded(bytes);
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

}  // namespace coif
