#pragma once
// Assets and heads that come and go.

#include "world_heads.h"

namespace coif {

/// What a valid description says.
[[nodiscard]] WorldRules rules_of(const WorldDesc& desc);

/// Memory for a world with `units` blocks and bundles at most.
[[nodiscard]] MemoryNeed world_need(const WorldDesc& desc, std::uint64_t units);
/// Creates an empty world in memory of that size; null where it is too small or not aligned. `shared` may be null.
[[nodiscard]] WorldState* create_world(const WorldDesc& desc, std::uint64_t units, const SharedCode* shared,
                                       std::span<std::byte> memory);

// worn_asset.cpp

/// A free place for an asset; null where there is none.
[[nodiscard]] WornAsset* free_asset(WorldState& world);
/// False where there is no memory.
[[nodiscard]] bool add_asset(WorldState& world, WornAsset& worn, const Asset& asset, LaneOrder order);
/// No head may wear it.
void remove_asset(WorldState& world, WornAsset& worn);
/// Sets what follows from the asset alone: its rows, its heads' memory.
void measure(const WorldRules& rules, const SharedCode* shared, LaneOrder order, WornAsset& worn);
/// Bytes of the memory of an asset that has been measured.
[[nodiscard]] std::size_t worn_bytes(const WorldRules& rules, const SharedCode* shared, LaneOrder order,
                                     WornAsset& worn);

/// What an asset with so many heads needs where nothing is shared with others.
struct WornNeed {
  std::uint64_t bytes = 0;  ///< Part of WorldDesc::hair_bytes.
  std::uint64_t units = 0;  ///< Blocks.
};
[[nodiscard]] WornNeed need_of(const Asset& asset, const WorldRules& rules, const SharedCode* shared, LaneOrder order,
                               std::uint32_t heads);

// crowds.cpp

/// Bytes of what a block of a crowd points to; `worn`: its asset, null for kShared.
[[nodiscard]] std::size_t number_bytes(const WorldRules& rules, LaneOrder order, const WornAsset* worn);
/// Bytes of a crowd itself.
[[nodiscard]] std::size_t crowd_bytes(std::uint32_t treatments);
/// Null where there is no memory.
[[nodiscard]] Crowd* join_crowd(WorldState& world, WornAsset& worn, LaneOrder order);
void leave_crowd(WorldState& world, Crowd& crowd);
/// Makes room for so many more heads; false where there is no memory.
[[nodiscard]] bool add_members(WorldState& world, Crowd& crowd, std::uint32_t count);
void remove_member(WorldState& world, Crowd& crowd);
void give_spares_back(WorldState& world, Crowd& crowd);

// worn_head.cpp

/// Adds a head at `unit`, in its rest pose. False where there is no memory or place.
[[nodiscard]] bool add_head(WorldState& world, std::uint32_t asset, const HeadPose& unit, std::uint32_t& added);
/// As add_head(), for a head whose room in its crowd there is already.
[[nodiscard]] bool add_counted_head(WorldState& world, std::uint32_t asset, const HeadPose& unit, std::uint32_t& added);
void remove_head(WorldState& world, std::uint32_t head);

// shared_colliders.cpp

/// Gives the asset's colliders places in a table, or shares those of an asset with the same colliders. False where
/// there is no memory.
[[nodiscard]] bool join_colliders(WorldState& world, WornAsset& worn);
void leave_colliders(WorldState& world, WornAsset& worn);

}  // namespace coif
