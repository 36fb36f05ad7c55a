#pragma once

#include "cook/hair_mesh.h"
#include "cook/recipe.h"

namespace coif {

struct SelectedHair {
  HairMesh mesh;                      ///< Welded; without degenerate triangles.
  std::vector<std::uint32_t> meshes;  ///< Source meshes that gave triangles.
  std::vector<std::string> left_out;  ///< What was not taken, one line each.
  std::vector<std::string> warnings;
};

/// Cuts the hair out of the model by the recipe's mesh, material and bone names. Without any, everything whose mesh or
/// material is called hair; failing that, the whole model. Errors (kBadInput): a pattern that matches nothing, with the
/// names there are; nothing left.
tl::expected<SelectedHair, ToolError> select_hair(const SourceModel& source, const Recipe& recipe);

}  // namespace coif
