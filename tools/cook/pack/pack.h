#pragma once

#include "cook/lods/make_lods.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/colliders.h"
#include "cook/rig/skeleton.h"
#include "cook/select/hair_mesh.h"
#include "cook/strands/strand_direction.h"
#include "cook/texture/bake_textures.h"
#include "import/source_model.h"
#include "write/asset_writer.h"

#include <coif/asset_records.h>

#include <cstdint>
#include <vector>

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

/// The most that a shading model returns of light that comes from everywhere alike ("white furnace"), where a white matte
/// surface returns 1: an upper bound over all directions of view, of a white base texture with a full mask, in the
/// channel that returns most, without the ambient term and before `light_cut`. Derived in shaders/SHADING.md.
[[nodiscard]] double furnace_bound(const MaterialRecord& material);

/// The cut with which the material returns no more than it gets; 0 where it does not anyway.
[[nodiscard]] float bounding_cut(const MaterialRecord& material);

/// The recipe's material; its base colour times `color`'s factor, thresholds as chosen, highlights with the shift and mask
/// that all strands have in common.
[[nodiscard]] MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                                           const Recipe& recipe);

/// What a cook by this version of the tool says of its origin. `source_hash`: XXH64 of the source file's bytes.
[[nodiscard]] ProvenanceRecord make_provenance(const SourceModel& source, const Recipe& recipe,
                                               std::uint64_t source_hash);

// What the recipe's "scene" says that nobody will look for, and what nothing in the asset would ever use.

/// Takes the parts out of `contents` that the recipe's "scene" is without: bone names, quality, provenance, shift and mask,
/// all that is drawn.
[[nodiscard]] std::vector<LeftOut> leave_out_parts(const Recipe& recipe, AssetContents& contents);

/// The head alone in place of a skeleton that moves: every vertex follows it. For a scene that does not simulate.
[[nodiscard]] std::vector<LeftOut> leave_out_motion(Skeleton rigid, Skeleton& skeleton, SkinWeights& weights);

/// Levels of detail that are too fine or too coarse for every size at which the scene shows the head. One always stays. The
/// finest that stays simulates every bone and is what errors are measured from: those of the others grow by its own at
/// most, and are given so.
[[nodiscard]] std::vector<LeftOut> leave_out_levels(const Recipe& recipe, DetailLevels& lods);

/// Colliders that are in no bone's set, where bones move at all; the sets count afresh. `colliders` has its reach settled.
[[nodiscard]] std::vector<LeftOut> leave_out_colliders(Colliders& colliders);

}  // namespace coif
