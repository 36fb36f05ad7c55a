#pragma once

#include "motion/head_path.h"

#include <cstddef>
#include <span>
#include <vector>

namespace coif::motion {

/// A clip to be carried into another program: for each key eight doubles, little-endian, seconds, position x, y, z and
/// rotation x, y, z, w.
[[nodiscard]] std::vector<std::byte> clip_bytes(std::span<const ClipKey> keys);

/// Of what clip_bytes() gave, bit for bit; empty for what is no clip that path_of() takes.
[[nodiscard]] std::vector<ClipKey> clip_keys(std::span<const std::byte> bytes);

}  // namespace coif::motion
