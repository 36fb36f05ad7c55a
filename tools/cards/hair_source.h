#pragma once

#include "base/tool_error.h"
#include "cook/recipe/recipe.h"
#include "import/import.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <functional>
#include <string>

namespace coif::cards {

/// What beside the source's own bytes decides which model a cook begins with.
struct HairSourceSettings {
  importer::ImportSettings import;         ///< Its unit and axis are those of the source.
  std::filesystem::path recipe_directory;  ///< CookSettings::recipe_directory.
  platform::Threads threads = 1;           ///< The model does not depend on it.
  /// Called before each part of the work with its name, "import" or "cards". May be empty, and may throw.
  std::function<void(const char* part)> progress{};
};

/// The model that a cook begins with: an artist's strips as import_model() has them; cards in place of strands, of a
/// .hair or .tfx and of an .obj or glTF whose hair is lines: it has no triangles, or some dozens of lines and no mesh
/// called hair, and its meshes are the body; cards of hair that is grown as a recipe says, where the source is a recipe
/// itself (is_recipe_file()). Where there are strands, a body that the recipe names comes with them. Errors: those of
/// import_model(), read_groom(), grow_from() and model_of_cards(). Blocks; costs a fork or two, so call it before
/// starting threads where you can.
[[nodiscard]] tl::expected<importer::SourceModel, ToolError> read_hair_source(const std::filesystem::path& path,
                                                                              const cook::Recipe& recipe,
                                                                              const HairSourceSettings& settings);

/// The recipe's values that read_hair_source() asks for: with others it gives another model.
[[nodiscard]] std::string source_values(const cook::Recipe& recipe);

}  // namespace coif::cards
