#include "cook/recipe/recipe_keys.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace coif {

std::vector<std::string> files_named_by(const Recipe& recipe) {
  std::vector<std::string> files;
  for (const RecipeKey& key : recipe_keys()) {
    if (!key.names_file) continue;
    const nlohmann::json value = write_value(key, recipe);
    const nlohmann::json& file = value.is_object() ? member(value, "file") : value;
    if (file.is_string() && !file.get_ref<const std::string&>().empty()) files.push_back(file.get<std::string>());
  }
  return files;
}

}  // namespace coif
