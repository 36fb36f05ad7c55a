#include "cook/recipe_image.h"

#include <fmt/format.h>

namespace coif {

tl::expected<RecipeImage, ToolError> read_recipe_image(const std::string& name, const char* key,
                                                       const CookSettings& settings) {
  if (name.empty()) return RecipeImage{};
  const std::filesystem::path path = settings.recipe_directory / name;
  auto image = read_image(path);
  if (image) return RecipeImage{std::move(*image), path};
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: recipe key \"textures.{}\": {}",
                                                                          path.string(), key, image.error())});
}

}  // namespace coif
