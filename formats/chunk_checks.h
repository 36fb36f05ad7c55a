#pragma once
// What open() proves about the content of each group of chunks, once, so that nothing needs to be checked later.
// The spans of `asset` are already known to lie inside the file and to hold whole records.

#include <coif/asset.h>
#include <coif/bit_cast.h>

#include <cstddef>
#include <cstdint>

namespace coif {

/// `entry` is known to lie inside the file.
LoadStatus check_hash(std::span<const std::byte> file, const ChunkEntry& entry);

/// Chunks that every asset must have.
LoadStatus check_needed_chunks(const Asset& asset);
LoadStatus check_names(const Asset& asset);
LoadStatus check_skeleton(const Asset& asset);
LoadStatus check_dynamics(const Asset& asset);
LoadStatus check_links(const Asset& asset);
LoadStatus check_colliders(const Asset& asset);
LoadStatus check_body(const Asset& asset);
/// Chunks without which other chunks (those that are drawn) are refused.
LoadStatus check_needs(const Asset& asset);
LoadStatus check_lods(const Asset& asset);
LoadStatus check_mesh(const Asset& asset);
LoadStatus check_orders(const Asset& asset);
LoadStatus check_material(const Asset& asset);
LoadStatus check_textures(const Asset& asset);
LoadStatus check_tuning(const Asset& asset);
LoadStatus check_provenance(const Asset& asset);

using ContentCheck = LoadStatus (*)(const Asset&);

/// They run in this order: each relies on those before it.
inline constexpr ContentCheck kContentChecks[] = {check_needed_chunks, check_names,     check_skeleton,  check_dynamics,
                                                  check_links,         check_colliders, check_needs,     check_body,
                                                  check_lods,          check_mesh,      check_orders,    check_material,
                                                  check_textures,      check_tuning,    check_provenance};

inline bool is_rigid(const BoneRecord& bone) { return bone.kind != BoneKind::kSimulated; }

// Comparisons that are false for NaN, so that one test covers range and finiteness.

/// Metres, texture repeats, colours. A larger value means a broken file.
inline constexpr float kMaxCoordinate = 1.0e5f;

inline bool in_range(float value, float low, float high) { return value >= low && value <= high; }

/// The top bit is set where `value` is NaN, infinite or larger than kMaxCoordinate: without their signs, floats are
/// ordered as their bits are. Suits many numbers at once: join their words with OR and test one bit.
inline std::uint32_t beyond_limit(float value) {
  return bit_cast<std::uint32_t>(kMaxCoordinate) - (bit_cast<std::uint32_t>(value) & 0x7FFFFFFFu);
}

template <std::size_t kCount>
bool all_in_range(const float (&values)[kCount], float low, float high) {
  for (float value : values) {
    if (!in_range(value, low, high)) return false;
  }
  return true;
}

template <std::size_t kCount>
bool all_finite(const float (&values)[kCount]) {
  return all_in_range(values, -kMaxCoordinate, kMaxCoordinate);
}

/// True where the vector's length is 1 within one per mille.
template <std::size_t kCount>
bool is_unit(const float (&values)[kCount]) {
  if (!all_in_range(values, -2.0f, 2.0f)) return false;
  float square = 0;
  for (float value : values) square += value * value;
  return in_range(square, 0.998f, 1.002f);
}

template <std::size_t kCount>
bool all_zero(const float (&values)[kCount]) {
  return all_in_range(values, 0.0f, 0.0f);
}

}  // namespace coif
