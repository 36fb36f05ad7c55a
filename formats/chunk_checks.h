#pragma once
// What open() proves about the content of each group of chunks, once, so that nothing needs to be checked later.
// The spans of `asset` are already known to lie inside the file and to hold whole records.

#include <coif/asset.h>

namespace coif {

/// `entry` is known to lie inside the file.
LoadStatus check_hash(std::span<const std::byte> file, const ChunkEntry& entry);
LoadStatus check_names(std::span<const char> names);
LoadStatus check_skeleton(const Asset& asset, std::size_t name_bytes);
LoadStatus check_dynamics(const Asset& asset);
LoadStatus check_colliders(const Asset& asset);
/// Before check_mesh(), which relies on it.
LoadStatus check_lods(const Asset& asset);
LoadStatus check_mesh(const Asset& asset);
/// After check_lods() and check_mesh(), on which it relies.
LoadStatus check_orders(const Asset& asset);
LoadStatus check_material(const Asset& asset);
LoadStatus check_textures(const Asset& asset, std::size_t texel_bytes);
LoadStatus check_provenance(const Asset& asset);
LoadStatus check_tuning(const Asset& asset);

}  // namespace coif
