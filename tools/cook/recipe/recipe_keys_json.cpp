#include "cook/recipe/recipe_keys_json.h"

#include "cook/recipe/recipe_keys.h"

#include <string>
#include <variant>

namespace coif::cook {
namespace {

const char* kind_of(const RecipeKey& key) {
  const auto holds = [&]<typename Field>() { return std::holds_alternative<Field Recipe::*>(key.field); };
  if (holds.operator()<bool>()) return "switch";
  if (holds.operator()<double>() || holds.operator()<std::optional<double>>()) return "number";
  if (holds.operator()<std::uint32_t>() || holds.operator()<std::optional<std::uint32_t>>()) return "whole";
  return key.choices != nullptr ? "choice" : "other";
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

}  // namespace coif::cook
