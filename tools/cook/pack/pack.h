#pragma once

#include "cook/lods/detail_level.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"
#include "cook/texture/bake_textures.h"
#include "import/source_model.h"
#include "write/asset_writer.h"

#include <coif/asset_records.h>

#include <cstdint>
#include <vector>

namespace coif::cook {

struct SceneRecipe;
struct DrawnRecipe;

/// Writes vertices, skin, indices and patches of `contents`: patches contiguous in draw order, triangles inside a patch
/// ordered for the vertex cache, vertices in order of first use. Positions move to head space.
///
/// Each of `levels`, finest first, has its own indices and patches; all share the finest one's vertices and order. A
/// single level needs no records.
void pack_mesh(const HairStrips& hair, const HairRig& rig, std::span<const DetailLevel> levels, const PatchOrder& order,
               AssetContents& contents);

/// The largest reflection of a shading model under uniform light from everywhere ("white furnace"), where a white matte
/// surface has 1: an upper bound over all viewing directions, with a white base texture and a full mask, in the
/// brightest channel, without the ambient term and before `light_cut`. Derived in shaders/SHADING.md.
[[nodiscard]] double furnace_bound(const MaterialRecord& material);

/// The cut with which the material reflects no more than it gets; 0 if that is already so.
[[nodiscard]] float bounding_cut(const MaterialRecord& material);

/// The recipe's material; its base colour times `color`'s factor, thresholds as chosen, highlights with the shift and
/// mask that all strands have in common.
[[nodiscard]] MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                                           const DrawnRecipe& recipe);

/// The provenance of a cook by this version of the tool. `recipe_hash`: recipe_hash(). `source_hash`: XXH64 of the
/// source file's bytes.
[[nodiscard]] ProvenanceRecord make_provenance(const importer::SourceModel& source, std::uint64_t recipe_hash,
                                               std::uint64_t source_hash);

/// Takes the parts out of `contents` that the recipe's "scene" is without: bone names, quality, provenance, shift and
/// mask, all that is drawn.
void leave_out_parts(const SceneRecipe& recipe, AssetContents& contents, Findings& findings);

}  // namespace coif::cook
