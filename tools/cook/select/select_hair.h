#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::cook {

struct HairRecipe;

/// Which triangles of a source are hair: per mesh and triangle; empty for a mesh without hair.
struct HairChoice {
  std::vector<std::vector<bool>> taken;

  [[nodiscard]] bool takes(std::size_t mesh, std::size_t triangle) const {
    return !taken[mesh].empty() && taken[mesh][triangle];
  }
};

/// By the recipe's mesh, material and bone names where it has any. Else by the first evidence that finds something:
/// meshes, materials or textures called hair; connected pieces that hair bones or springs below the head move; pieces
/// of a transparent material on the head that no lid or brow moves; the whole model, if it is none of a body with
/// limbs. Caps under that hair and cores inside it are hair as well. Notes why for each mesh that gave hair, and what
/// of the others was left out. Errors (kBadInput): a pattern that matches nothing, or a character of which nothing is
/// known to be hair, with the names there are.
tl::expected<HairChoice, ToolError> choose_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                                Findings& findings);

/// Cuts the hair that choose_hair() finds out of the model and joins it: welded, without degenerate triangles. Errors
/// (kBadInput): those of choose_hair(); nothing left.
tl::expected<HairMesh, ToolError> select_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                              Findings& findings);

/// Warns (C115) of two meshes of the hair that lie on each other, one of them with clearly fewer triangles, as levels
/// of detail of one thing do whatever they are called. `hair`: numbers of the meshes that are hair.
void warn_of_stacked_meshes(const importer::SourceModel& source, std::span<const std::uint32_t> hair,
                            Findings& findings);

}  // namespace coif::cook
