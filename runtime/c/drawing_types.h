#pragma once
// Conversions of drawing's types from C to C++.

#include "asset_view.h"

#include <coif/drawing.h>

#include <cstring>

namespace coif::c {

static_assert(sizeof(coif_mat34) == sizeof(coif::Mat34));

/// The members that culling, orders and matrices use; without the levels' ranges, alpha and material.
inline coif::DrawnHair hair_of(const coif_drawn_hair& from) {
  coif::DrawnHair hair;
  hair.lod_count = from.lod_count;
  hair.order_count = from.order_count;
  hair.indices_of_order = from.indices_of_order;
  hair.index_bytes = from.index_bytes;
  std::memcpy(hair.order_of_view, from.order_of_view, sizeof hair.order_of_view);
  hair.reach = copied<coif::Reach>(from.reach);
  hair.bone_count = from.bone_count;
  hair.skinning = static_cast<coif::Skinning>(from.skinning);
  return hair;
}

/// Empty for null.
inline std::span<const coif::Mat34> matrices_of(const coif_mat34* palette, std::uint32_t count) {
  return {reinterpret_cast<const coif::Mat34*>(palette), palette == nullptr ? 0 : count};
}

}  // namespace coif::c
