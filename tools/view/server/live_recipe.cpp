#include "view/server/live_cook.h"

#include "cook/recipe/recipe_keys.h"

#include <fmt/format.h>

namespace coif::view {
namespace {

constexpr const char* kChanges = "changes of the page";

/// The JSON of a file that is a recipe; empty where there is none.
tl::expected<nlohmann::json, ToolError> json_of(const std::filesystem::path& file) {
  if (file.empty()) return nlohmann::json::object();
  const auto text = cook::read_recipe_text(file);
  if (!text) return tl::unexpected(text.error());
  if (const auto alone = cook::parse_recipe(*text, file.string()); !alone) return tl::unexpected(alone.error());
  return parse_shallow_json(*text).value();
}

/// "patches" may be a list, short for its "overrides".
void write_out(nlohmann::json& recipe) {
  const auto patches = recipe.find("patches");
  if (patches != recipe.end() && patches->is_array()) *patches = nlohmann::json{{"overrides", std::move(*patches)}};
}

}  // namespace

tl::expected<nlohmann::json, ToolError> read_changes(std::string_view text) {
  auto changes = parse_shallow_json(text);
  if (!changes) return failure(ToolError::Kind::kBadInput, fmt::format("{}: {}", kChanges, changes.error()));
  if (!changes->is_object()) {
    return failure(ToolError::Kind::kBadInput,
                   fmt::format("{}: a recipe is a JSON object, such as {{\"dynamics\": {{...}}}}", kChanges));
  }
  for (const cook::RecipeKey& key : cook::recipe_keys()) {
    if (!key.names_file || member(member(*changes, key.section), key.name).is_null()) continue;
    return failure(ToolError::Kind::kBadInput,
                   fmt::format("{}: \"{}\" names a file; only a recipe's file may", kChanges, key.path()));
  }
  write_out(*changes);
  return std::move(*changes);
}

tl::expected<LiveRecipe, ToolError> live_recipe(const std::filesystem::path& file, const nlohmann::json& changes) {
  auto json = json_of(file);
  if (!json) return tl::unexpected(json.error());
  nlohmann::json merged = *json;
  write_out(merged);
  merged.merge_patch(changes);
  auto recipe = cook::parse_recipe(merged.dump(), kChanges);  // the file alone is a recipe, so that the fault is theirs
  if (!recipe) return tl::unexpected(recipe.error());
  return LiveRecipe{std::move(*recipe), std::move(*json)};
}

}  // namespace coif::view
