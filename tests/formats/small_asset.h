#pragma once

#include "write/asset_writer.h"

namespace coif {

/// An asset of about 3 KiB that uses every chunk: a head, one scalp bone, a chain of two bones and one of one bone
/// that branches off the head, four shapes of collider, two patches of one triangle each, both textures, a tuning.
[[nodiscard]] AssetContents small_asset();

}  // namespace coif
