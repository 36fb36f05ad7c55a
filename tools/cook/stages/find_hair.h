#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/drawn_recipe.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_mesh.h"
#include "cook/stages/cook_log.h"
#include "cook/texture/base_color.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <optional>

namespace coif::cook {

/// What of a source is hair.
struct SourceHair {
  std::optional<importer::SourceModel>
      settled;    ///< The source in metres with Y up; none where it is like that as it was read.
  HairMesh mesh;  ///< With one texture, whose coordinates it has.
  BaseColor color;

  /// The model that the hair is of.
  [[nodiscard]] const importer::SourceModel& model(const importer::SourceModel& source) const {
    return settled ? *settled : source;
  }
};

/// The first stage of a cook. Textures are joined here, since that moves texture coordinates and splits vertices, which
/// all that follows numbers. Errors: those of select_hair() and find_base_color().
tl::expected<SourceHair, ToolError> find_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                              const DrawnRecipe& drawn, const CookSettings& settings, CookLog& log);

}  // namespace coif::cook
