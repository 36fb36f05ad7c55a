#pragma once

#include "write/asset_writer.h"

#include <utility>

namespace coif {

/// The same without all that is drawn, or depends on it: bones, dynamics and colliders stay.
[[nodiscard]] inline AssetContents without_mesh(AssetContents contents) {
  contents.vertices.clear();
  contents.skin.clear();
  contents.indices.clear();
  contents.patches.clear();
  contents.orders.clear();
  contents.order_views.clear();
  contents.lods.clear();
  contents.lod_bones.clear();
  return contents;
}

}  // namespace coif
