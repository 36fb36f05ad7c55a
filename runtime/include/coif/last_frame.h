#pragma once
// The matrices of the last frame, which vectors of motion are made from. Kept by the host, for those crowds that
// it draws vectors of.

#include <coif/export.h>
#include <coif/hair.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstddef>
#include <span>

namespace coif {

/// Copies the matrices of all instances, one head's after the other's, to be kept while the next step changes
/// them: call it before step(), and keep the heads' poses of the last frame beside. 48 bytes for each bone and
/// head, at the price of a copy. kNotCreated; kSizeMismatch unless there is room for exactly instance_count() *
/// bone_count() matrices, and nothing is copied.
COIF_API Status keep_palettes(const Hair& hair, std::span<Mat34> kept);

/// One head's part of them.
[[nodiscard]] inline std::span<const Mat34> kept_palette(std::span<const Mat34> kept, std::uint32_t bones,
                                                         std::uint32_t instance) {
  return kept.subspan(std::size_t{instance} * bones, bones);
}

}  // namespace coif
