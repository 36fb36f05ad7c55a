#include "cook/recipe/recipe_keys_json.h"

#include "cook/recipe/recipe_keys.h"

#include <string>
#include <variant>

namespace coif {
namespace {

const char* kind_of(const RecipeKey& key) {
  const auto holds = [&]<typename Field>(Field Recipe::*) {
    return std::holds_alternative<Field Recipe::*>(key.field);
  };
  if (holds(&Recipe::scene_draw)) return "switch";
  if (holds(&Recipe::gravity_scale) || holds(&Recipe::friction)) return "number";
  if (holds(&Recipe::lod_levels) || holds(&Recipe::texture_max_size)) return "whole";
  return key.choices != nullptr && holds(&Recipe::up_axis) ? "choice" : "other";
}

}  // namespace

std::string recipe_keys_json() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const RecipeKey& key : recipe_keys()) {
    const nlohmann::ordered_json choices = key.choices != nullptr ? nlohmann::ordered_json(key.choices) : nullptr;
    all.push_back({{"path", key.path()},
                   {"section", key.section},
                   {"name", key.name},
                   {"kind", kind_of(key)},
                   {"default", nlohmann::ordered_json::parse(key.default_json)},
                   {"low", key.low},
                   {"high", key.high},
                   {"choices", choices},
                   {"unit", key.unit},
                   {"meaning", std::string(key.meaning) + key.also}});
  }
  return all.dump();
}

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
