#pragma once

#include "cook/recipe.h"
#include "write/asset_writer.h"

#include <string>
#include <vector>

namespace coif {

/// Writes into each vertex which share of the light from everywhere reaches it in the rest pose
/// (VertexRecord::normal[3]): over the 96 directions of view_cells.h, each as wide as its cell, the mean of what the
/// hair before the vertex lets through, 0 where a collider of the head is before it. Hair seen from both sides is lit
/// from both; hair with an outside only by what is above its surface. A card does not shade itself. Alpha counts as
/// painted, so this comes before keep_coverage(). Recipe: "occlusion.strength". Returns notes for the report.
///
/// Source of the idea: Zhukov, Iones, Kronin 1998, "An ambient light illumination model".
[[nodiscard]] std::vector<std::string> bake_occlusion(const Recipe& recipe, unsigned threads, AssetContents& contents);

}  // namespace coif
