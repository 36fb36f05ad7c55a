#pragma once

#include "cook/settle_colliders.h"
#include "cook/skeleton.h"
#include "write/asset_writer.h"

namespace coif {

/// Writes skeleton, bones, names, chains and colliders of `contents`, in head space. Rest directions are in the parent's
/// frame, which at rest has the axes of the model.
void pack_skeleton(const Skeleton& skeleton, const Colliders& colliders, AssetContents& contents);

}  // namespace coif
