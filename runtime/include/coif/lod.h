#pragma once

#include <coif/asset_records.h>
#include <coif/export.h>

#include <cstdint>
#include <span>

namespace coif {

/// Share of the viewport's height that something of this height (metres) covers at this distance (metres, > 0) from the
/// eye, under a perspective camera whose vertical field of view is `fov` radians, 0 < fov < pi. LodRecord::screen_size
/// refers to the head's own height in the world, HeadPose::scale included.
[[nodiscard]] COIF_API float screen_share(float height, float distance, float fov);

/// The level to draw: the finest that fits `share` of the viewport's height, see LodRecord::screen_size.
///
/// `current` is the level drawn so far. It changes only where `share` is beyond a level's border by more than
/// `hysteresis` times the border, so that a head at a border does not flicker; 0.1 suits most games, 0 chooses afresh.
/// `hysteresis` outside 0..0.9 is clamped. Returns 0 for an asset without levels, the coarsest level for a share that
/// is not a number.
[[nodiscard]] COIF_API std::uint32_t choose_lod(std::span<const LodRecord> lods, float share, std::uint32_t current,
                                                float hysteresis = 0.1f);

}  // namespace coif
