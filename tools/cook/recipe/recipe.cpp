#include "cook/recipe/recipe.h"

#include "base/hair_runtime.h"
#include "base/json.h"
#include "base/text.h"
#include "base/words.h"
#include "cook/recipe/recipe_keys.h"
#include "cook/recipe/recipe_preset.h"
#include "payload_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <sstream>

namespace coif::cook {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxRecipeBytes = 1 << 20;
constexpr std::size_t kLongestKey = 100;  // nothing longer was meant to be one of ours, and comparing takes time

tl::unexpected<ToolError> bad_recipe(const std::string& name, const std::string& what) {
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, name + ": " + what});
}

const RecipeKey* find_key(const std::string& path) {
  for (const RecipeKey& key : recipe_keys()) {
    if (key.path() == path) return &key;
  }
  return nullptr;
}

std::string unknown_key(const std::string& path) {
  std::vector<std::string> paths;
  for (const RecipeKey& key : recipe_keys()) paths.push_back(key.path());
  const std::string nearest = path.size() < kLongestKey ? nearest_word(path, paths) : "";
  const std::string cure =
      nearest.empty() ? "'coif cook --print-recipe' lists all keys" : fmt::format("did you mean \"{}\"?", nearest);
  return fmt::format("\"{}\" is not a key; {}", excerpt(path), cure);
}

/// Reads one section's keys into `recipe`; the error is a sentence without the file's name.
tl::expected<void, std::string> read_section(const std::string& section, const json& values, Recipe& recipe) {
  for (const auto& [name, value] : values.items()) {
    const std::string path = section + "." + name;
    const RecipeKey* key = find_key(path);
    if (key == nullptr) return tl::unexpected(unknown_key(path));
    if (auto outcome = read_value(*key, value, recipe); !outcome) {
      return tl::unexpected(fmt::format("\"{}\" {}", path, outcome.error()));
    }
  }
  return {};
}

/// Reads all sections of a document into `recipe`.
tl::expected<void, std::string> read_document(const json& document, Recipe& recipe) {
  for (const auto& [section, values] : document.items()) {
    const bool is_list = section == "patches" && values.is_array();  // short for its "overrides"
    if (!values.is_object() && !is_list) return tl::unexpected(unknown_key(section));
    auto outcome = read_section(section, is_list ? json{{"overrides", values}} : values, recipe);
    if (!outcome) return outcome;
  }
  return {};
}

/// The word that chooses a preset: `said` if not empty, else the document's value. Null: none.
json chosen_word(const json& document, const char* section, const char* key, const std::string& said) {
  return said.empty() ? member(member(document, section), key) : json(said);
}

/// The preset that a document names. An empty object where it names none.
tl::expected<json, std::string> find_preset(const json& document, const std::string& said, Recipe& recipe) {
  const json chosen = chosen_word(document, "look", "preset", said);
  if (chosen.is_null()) return json::object();
  if (auto outcome = read_section("look", {{"preset", chosen}}, recipe); !outcome)
    return tl::unexpected(outcome.error());
  for (const RecipePreset& preset : recipe_presets()) {
    if (recipe.look_preset == preset.name) return json::parse(preset.keys);
  }
  return json::object();
}

/// The keys of the built-in style that a document names.
tl::expected<void, std::string> begin_from_style(const json& chosen, Recipe& recipe) {
  if (chosen.is_null()) return {};
  if (auto outcome = read_section("grow", {{"style", chosen}}, recipe); !outcome) return outcome;
  for (const BuiltInStyle& built_in : built_in_styles()) {
    if (recipe.grow_style == built_in.name) return read_section("grow", json::parse(built_in.keys), recipe);
  }
  return {};
}

/// A document that gives numbers of highlights as published, and names no model, means the thesis's.
bool means_published(std::initializer_list<const json*> documents) {
  bool gives_highlights = false;
  for (const json* const document : documents) {
    const json material = member(*document, "material");
    if (material.is_object() && material.contains("shading")) return false;
    for (const auto& [key, value] : material.items()) {
      gives_highlights = gives_highlights || key.starts_with("primary_") || key.starts_with("secondary_");
    }
  }
  return gives_highlights;
}

/// `says_all`: with RecipeKey::also, keys that the asset does not depend on, and keys of later versions at their
/// defaults.
std::string commented(const Recipe& recipe, bool says_all) {
  std::string text = "{";
  const char* section = "";
  for (const RecipeKey& key : recipe_keys()) {
    if (!says_all && !key.shapes_asset) continue;
    const json given = write_value(key, recipe);
    if (!says_all && key.is_later && given == json::parse(key.default_json)) continue;
    const bool first = std::strcmp(section, key.section) != 0;
    if (first) text += fmt::format("{}\n  \"{}\": {{", *section != 0 ? "\n  }," : "", key.section);
    section = key.section;
    const std::string value = given.dump();
    const auto shown = [&](const std::string& written) {
      return !says_all && key.canonical_null != nullptr && written == "null" ? std::string(key.canonical_null)
                                                                             : written;
    };
    std::string facts = fmt::format("default {}", shown(key.default_json));
    if (key.choices != nullptr) facts += fmt::format(", one of {}", key.choices);
    if (key.low < key.high)
      facts += fmt::format(", {} to {}{}{}", key.low, key.high, *key.unit != 0 ? " " : "", key.unit);
    text += fmt::format("{}\n    // {}{} ({})\n    \"{}\": {}", first ? "" : ",", key.meaning, says_all ? key.also : "",
                        facts, key.name, shown(value));
  }
  return text + "\n  }\n}\n";
}

}  // namespace

Recipe default_recipe() {
  Recipe recipe;
  for (const RecipeKey& key : recipe_keys()) {
    // The table is our own: tests check that each default is in its range.
    (void)read_value(key, json::parse(key.default_json), recipe);
  }
  return recipe;
}

Recipe draft_of(Recipe recipe) {
  // A volume without occlusion is lit as if its inside lay open, and fine strands need texels.
  const bool is_volume = recipe.shading == name_of(ShadingModel::kVolume);
  const std::uint32_t draft_texels = is_volume ? 1024 : 512;
  recipe.order_method = OrderMethod::kHead;
  recipe.lod_levels = 1;
  recipe.texture_max_size = std::min(texture_limit(recipe), draft_texels);
  recipe.shift_mask_format = ShiftMaskFormat::kRg8;
  recipe.color_format = ColorFormat::kRgba8;
  if (!is_volume) recipe.occlusion_strength = 0;
  recipe.cards_rounds = std::min(recipe.cards_rounds, 1u);
  return recipe;
}

tl::expected<Recipe, ToolError> parse_recipe(const std::string& text, const std::string& name,
                                             const RecipeBeginning& beginning) {
  Recipe recipe = default_recipe();
  const auto document = parse_shallow_json(text);
  if (!document) return bad_recipe(name, document.error());
  if (!document->is_object()) return bad_recipe(name, "a recipe is a JSON object, such as {\"dynamics\": {...}}");
  const auto preset = find_preset(*document, beginning.preset, recipe);
  if (!preset) return bad_recipe(name, preset.error());
  json style = chosen_word(*document, "grow", "style", beginning.style);
  if (style.is_null()) style = chosen_word(*preset, "grow", "style", "");
  if (auto outcome = begin_from_style(style, recipe); !outcome) return bad_recipe(name, outcome.error());
  for (const json* const layer : {&*preset, &*document}) {
    if (auto outcome = read_document(*layer, recipe); !outcome) return bad_recipe(name, outcome.error());
  }
  if (means_published({&*preset, &*document})) recipe.shading = name_of(ShadingModel::kThesis);
  if (!beginning.preset.empty()) recipe.look_preset = beginning.preset;
  if (!beginning.style.empty()) recipe.grow_style = beginning.style;
  if (recipe.head_center.has_value() != recipe.head_radii.has_value()) {
    return bad_recipe(name, "\"head.center\" and \"head.radii\" come together; give both or neither");
  }
  return recipe;
}

tl::expected<std::string, ToolError> read_recipe_text(const std::filesystem::path& path) {
  const auto unreadable = [&](const std::string& why) {
    return tl::unexpected(ToolError{ToolError::Kind::kFileAccess, fmt::format("{}: {}", path.string(), why)});
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return unreadable("cannot open: is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) return unreadable(fmt::format("cannot open: {}", std::strerror(errno)));
  if (std::filesystem::file_size(path, error) > kMaxRecipeBytes)
    return unreadable("too large for a recipe (over 1 MiB)");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

tl::expected<Recipe, ToolError> read_recipe(const std::filesystem::path& path, const RecipeBeginning& beginning) {
  const auto text = read_recipe_text(path);
  if (!text) return tl::unexpected(text.error());
  return parse_recipe(*text, path.string(), beginning);
}

bool is_recipe_file(const std::filesystem::path& path) { return path.filename().string().ends_with(".recipe.json"); }

std::string print_recipe(const Recipe& recipe) { return commented(recipe, true); }

std::string canonical_recipe(const Recipe& recipe) { return commented(recipe, false); }

std::uint64_t recipe_hash(const Recipe& recipe) {
  const std::string text = canonical_recipe(recipe);
  return xxh64(std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace coif::cook
