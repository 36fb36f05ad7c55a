#pragma once

#include "cook/hair_mesh.h"
#include "cook/left_out.h"
#include "cook/recipe.h"

namespace coif {

struct SelectedHair {
  HairMesh mesh;                      ///< Welded; without degenerate triangles.
  std::vector<std::uint32_t> meshes;  ///< Source meshes that gave triangles.
  std::vector<std::string> notes;     ///< What was taken and why, one line each.
  std::vector<LeftOut> left_out;      ///< What was not taken.
  std::vector<std::string> warnings;
};

/// Cuts the hair that choose_hair() finds out of the model and joins it. Errors (kBadInput): those of choose_hair();
/// nothing left.
tl::expected<SelectedHair, ToolError> select_hair(const SourceModel& source, const Recipe& recipe);

}  // namespace coif
