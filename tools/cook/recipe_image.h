#pragma once

#include "cook/cook.h"
#include "cook/image.h"

namespace coif {

struct RecipeImage {
  std::optional<Image> image;  ///< None where the recipe names none.
  std::filesystem::path path;
};

/// Reads the image that the recipe's "textures.KEY" names, a path from the recipe's folder. Error (kBadInput): it cannot
/// be read; the artist asked for it.
tl::expected<RecipeImage, ToolError> read_recipe_image(const std::string& name, const char* key,
                                                       const CookSettings& settings);

}  // namespace coif
