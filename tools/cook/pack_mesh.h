#pragma once

#include "cook/make_lods.h"
#include "cook/skin_weights.h"
#include "cook/sort_patches.h"
#include "cook/strand_direction.h"
#include "write/asset_writer.h"

namespace coif {

/// Writes vertices, skin, indices and patches of `contents`: patches contiguous in draw order, triangles inside a patch
/// ordered for the vertex cache, vertices in order of first use. Positions move to head space, whose
/// origin is `origin` in the model.
///
/// Each of `levels`, finest first, has its own indices and patches; all share the finest one's vertices and order. One level
/// alone needs no records.
void pack_mesh(const HairMesh& mesh, std::span<const DetailLevel> levels, const PatchOrder& order,
               const StrandField& strands, const Eigen::Vector3d& origin, const SkinWeights& weights,
               AssetContents& contents);

}  // namespace coif
