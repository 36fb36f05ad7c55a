#pragma once
// What the files of the C interface that move hair share.

#include "asset_view.h"

#include <coif/hair.h>

// In the first bytes of the caller's memory; what coif::Hair needs follows.
struct coif_hair {
  coif::Asset asset;
  coif::Hair hair;
};

namespace coif::c {

/// A list of C's type, which has the same layout; empty for null.
template <typename T, typename InC>
std::span<const T> span_of(const InC* list, std::uint32_t count) {
  static_assert(sizeof(InC) == sizeof(T) && alignof(InC) == alignof(T));
  return {reinterpret_cast<const T*>(list), list == nullptr ? 0 : count};
}

}  // namespace coif::c
