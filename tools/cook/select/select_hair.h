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

/// The triangles of a source that are hair: per mesh and triangle; empty for a mesh without hair.
struct HairChoice {
  std::vector<std::vector<bool>> taken;

  [[nodiscard]] bool takes(std::size_t mesh, std::size_t triangle) const {
    return !taken[mesh].empty() && taken[mesh][triangle];
  }
};

/// Error (kBadInput): a name of the recipe matches no mesh, material or node; with the names that exist.
tl::expected<void, ToolError> check_hair_names(const importer::SourceModel& source, const HairRecipe& recipe);

/// Chooses by the recipe's mesh, material and bone names, if any. Else by the first kind of evidence that finds
/// something: meshes, materials or textures with a hair name; connected pieces that hair bones or springs below the
/// head move; pieces of a transparent material on the head that no lid or brow moves. Where all of that leaves the
/// crown of the head bare, what covers it is taken, too, with a warning; without any sign the whole model, if it is not
/// a body with limbs. Caps under that hair and cores inside it are hair as well. Notes the reason for each mesh that
/// gave hair, and what was left out of the others. Errors (kBadInput): a pattern that matches nothing, or a character
/// without any sign of hair; with the names that exist.
tl::expected<HairChoice, ToolError> choose_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                                Findings& findings);

/// Cuts the hair that choose_hair() finds out of the model and joins it: welded, without degenerate triangles. Errors
/// (kBadInput): those of choose_hair(); no triangle is left.
tl::expected<HairMesh, ToolError> select_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                              Findings& findings);

/// Warns (C115) of two hair meshes that lie on each other, one with clearly fewer triangles: probably levels of detail
/// of one thing. `hair`: numbers of the meshes that are hair.
void warn_of_stacked_meshes(const importer::SourceModel& source, std::span<const std::uint32_t> hair,
                            Findings& findings);

}  // namespace coif::cook
