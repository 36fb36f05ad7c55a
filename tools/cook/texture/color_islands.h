#pragma once

#include "cook/select/hair_mesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace coif::cook {

/// The triangles that `takes` takes, in pieces that hang together by index; pieces and triangles in the order of the
/// mesh.
[[nodiscard]] std::vector<std::vector<std::size_t>> color_islands(const HairMesh& hair,
                                                                  const std::function<bool(std::size_t)>& takes);

}  // namespace coif::cook
