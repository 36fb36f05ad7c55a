#include "worn.h"

#include <cstring>
#include <new>

namespace coif {
namespace {

std::uint32_t taken_by(const WornAsset& worn) {
  return PlacedColliders::first(worn.asset.colliders().size()) << worn.first_collider;
}

bool has_same_colliders(const Asset& a, const Asset& b) {
  const auto one = a.colliders(), other = b.colliders();
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

/// The first place with room for `count` colliders side by side; kMaxColliders: none.
std::uint32_t room_in(const ColliderTable& table, std::size_t count) {
  for (std::uint32_t first = 0; first + count <= kMaxColliders; ++first) {
    if ((table.taken & (PlacedColliders::first(count) << first)) == 0) return first;
  }
  return kMaxColliders;
}

/// In the asset's order, since hair between several colliders depends on it.
void enter(ColliderTable& table, std::uint32_t first, WornAsset& worn) {
  worn.colliders = &table;
  worn.first_collider = first;
  table.taken |= taken_by(worn);
  const auto records = worn.asset.colliders();
  for (std::uint32_t i = 0; i < records.size(); ++i) table.placed.place(first + i, records[i]);
}

}  // namespace

bool join_colliders(WorldState& world, WornAsset& worn) {
  const auto records = worn.asset.colliders();
  if (records.empty()) return true;
  for (const WornAsset& other : world.assets) {
    if (&other == &worn || !other.is_there || !has_same_colliders(other.asset, worn.asset)) continue;
    worn.colliders = other.colliders;
    worn.first_collider = other.first_collider;
    return true;
  }
  for (ColliderTable* table = world.colliders; table != nullptr; table = table->next) {
    const std::uint32_t first = room_in(*table, records.size());
    if (first == kMaxColliders) continue;
    enter(*table, first, worn);
    return true;
  }
  std::byte* const memory = world.heap.take(sizeof(ColliderTable));
  if (memory == nullptr) return false;
  auto* const table = ::new (static_cast<void*>(memory)) ColliderTable{world.colliders, 0, {}};
  world.colliders = table;
  enter(*table, 0, worn);
  return true;
}

void leave_colliders(WorldState& world, WornAsset& worn) {
  if (worn.colliders == nullptr) return;
  for (const WornAsset& other : world.assets) {
    const bool shares = other.colliders == worn.colliders && other.first_collider == worn.first_collider;
    if (&other != &worn && other.is_there && shares) return;
  }
  ColliderTable& table = *worn.colliders;
  table.taken &= ~taken_by(worn);
  if (table.taken != 0) return;
  ColliderTable** link = &world.colliders;
  while (*link != &table) link = &(*link)->next;
  *link = table.next;
  world.heap.give_back(&table, sizeof(ColliderTable));
}

}  // namespace coif
