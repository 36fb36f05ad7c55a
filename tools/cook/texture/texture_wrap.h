#pragma once

#include "cook/texture/base_color.h"

namespace coif::cook {

/// Cooked textures repeat. Makes hair whose textures do not look the same on one that does, the cheapest way first:
///
/// - Where no triangle crosses a border of the image, coordinates are clamped or folded into it.
/// - A mirrored image that is crossed is stored with its mirror image beside it.
/// - A clamped image that is crossed becomes a tile that reaches as far as the coordinates do: `clamped` of a look
/// stays
///   TextureWrap::kClamp then, and it is to be drawn in an atlas. Elsewhere the looks are kRepeat afterwards.
///
/// Coordinates farther out than a tile can be are taken back to it, with a warning.
void settle_wraps(SurfaceLooks& looks, HairMesh& hair, Findings& findings);

}  // namespace coif::cook
