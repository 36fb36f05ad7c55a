#include "cli/recipe_choice.h"

#include <fmt/format.h>

#include <system_error>

namespace coif {
namespace {

namespace fs = std::filesystem;

tl::expected<RecipeChoice, ToolError> read_choice(const fs::path& file) {
  auto recipe = read_recipe(file);
  if (!recipe) return tl::unexpected(recipe.error());
  return RecipeChoice{std::move(*recipe), file.parent_path(), file};
}

}  // namespace

tl::expected<RecipeChoice, ToolError> choose_recipe(const fs::path& source, const std::optional<std::string>& named,
                                                    const Messages& messages) {
  if (named) return read_choice(*named);
  fs::path beside = source;
  beside.replace_extension(".recipe.json");
  std::error_code ignored;
  if (source.empty() || !fs::exists(beside, ignored)) return RecipeChoice{default_recipe(), source.parent_path(), {}};
  messages.note(fmt::format("{}: used, as it lies beside the source; --recipe names another", beside.string()));
  return read_choice(beside);
}

ImportSettings import_settings(const Recipe& recipe) {
  ImportSettings settings;
  if (recipe.metres_per_unit > 0) settings.metres_per_unit = recipe.metres_per_unit;
  if (recipe.up_axis == "x") settings.up_axis = UpAxis::kX;
  if (recipe.up_axis == "y") settings.up_axis = UpAxis::kY;
  if (recipe.up_axis == "z") settings.up_axis = UpAxis::kZ;
  return settings;
}

}  // namespace coif
