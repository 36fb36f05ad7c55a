#pragma once

#include <cstddef>

namespace coif {

/// Hair whose patches have next to no triangles: its strips fell apart when they were told from each other.
constexpr bool is_shattered(std::size_t triangles, std::size_t patches) {
  return patches > 8 && triangles < 4 * patches;
}

}  // namespace coif
