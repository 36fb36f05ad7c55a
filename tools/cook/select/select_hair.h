#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "cook/select/hair_mesh.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif {

/// Which triangles of a source are hair, and why.
struct HairChoice {
  std::vector<std::vector<bool>> taken;  ///< Per source mesh and triangle; of a mesh without hair: empty.
  std::vector<std::string> reasons;      ///< One line per mesh that gave hair.
  std::vector<LeftOut> left_out;         ///< One per mesh that did not, or not wholly.
  std::vector<std::string> warnings;

  [[nodiscard]] bool takes(std::size_t mesh, std::size_t triangle) const {
    return !taken[mesh].empty() && taken[mesh][triangle];
  }
};

/// By the recipe's mesh, material and bone names where it has any. Else by the first evidence that finds something:
/// meshes, materials or textures called hair; connected pieces that hair bones or springs below the head move; pieces of
/// a transparent material on the head that no lid or brow moves; the whole model. Errors (kBadInput): a pattern that
/// matches nothing, with the names there are.
tl::expected<HairChoice, ToolError> choose_hair(const SourceModel& source, const Recipe& recipe);

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
