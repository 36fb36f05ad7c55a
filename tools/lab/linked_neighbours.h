#pragma once

#include "write/asset_writer.h"

#include <coif/asset.h>

namespace coif::lab {

/// What Hair reads of the asset, each chain linked to the nearest of those before it, as hair would be that hangs
/// together everywhere: what links could cost. Stretch a tenth, and half as near.
[[nodiscard]] AssetContents with_neighbours_linked(const Asset& asset);

}  // namespace coif::lab
