#pragma once
// The matrices of the last frame, from which motion vectors are made. The host keeps them, for crowds that it draws
// vectors of.

#include <coif/export.h>
#include <coif/hair.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstddef>
#include <span>

namespace coif {

/// Copies the matrices of all instances, one head's after the other's, so that they survive the next step. Call it
/// before step(), and keep the heads' poses of the last frame with them. Takes 48 bytes for each bone and head.
/// kNotCreated; kSizeMismatch unless `kept` has exactly instance_count() * bone_count() matrices. After an error
/// nothing was copied.
COIF_API Status keep_palettes(const Hair& hair, std::span<Mat34> kept);

/// One head's part of the kept matrices.
[[nodiscard]] inline std::span<const Mat34> kept_palette(std::span<const Mat34> kept, std::uint32_t bones,
                                                         std::uint32_t instance) {
  return kept.subspan(std::size_t{instance} * bones, bones);
}

}  // namespace coif
