#pragma once

#include "cache/cook_cache.h"

namespace coif::cache {

/// An entry with something in every part of it.
[[nodiscard]] CacheEntry small_entry();

}  // namespace coif::cache
