#pragma once

#include "base/json.h"
#include "cook/recipe/recipe.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace coif::cook {

/// A value that is one of a few words: an enumeration, whose numbers are the places of the words in RecipeKey::choices.
struct ChoiceField {
  std::size_t (*get)(const Recipe&);
  void (*set)(Recipe&, std::size_t);
};

template <auto kMember>
inline constexpr ChoiceField choice_of = {[](const Recipe& recipe) { return std::size_t(recipe.*kMember); },
                                          [](Recipe& recipe, std::size_t choice) {
                                            using Choice = std::remove_reference_t<decltype(recipe.*kMember)>;
                                            recipe.*kMember = Choice(choice);
                                          }};

using RecipeField =
    std::variant<bool Recipe::*, double Recipe::*, std::uint32_t Recipe::*, std::string Recipe::*,
                 std::vector<std::string> Recipe::*, std::vector<CurvePoint> Recipe::*, std::array<double, 3> Recipe::*,
                 std::vector<std::array<double, 3>> Recipe::*, std::array<double, 4> Recipe::*,
                 std::optional<double> Recipe::*, std::optional<NumberOrCurve> Recipe::*,
                 std::optional<std::array<double, 3>> Recipe::*, std::optional<std::array<double, 2>> Recipe::*,
                 std::optional<std::uint32_t> Recipe::*, std::vector<PatchOverride> Recipe::*,
                 std::vector<RecipeBodyCollider> Recipe::*, std::vector<RecipeBoneLimit> Recipe::*,
                 RecipeLinks Recipe::*, RecipeTexture Recipe::*, ChoiceField>;

/// One key of a recipe, with everything that reading, checking and printing it needs.
struct RecipeKey {
  const char* section;
  const char* name;
  RecipeField field;
  const char* default_json;
  double low;  ///< Smallest and largest number allowed, where the value has numbers.
  double high;
  const char* choices;    ///< Words allowed, separated by '|'; null: any text.
  const char* unit;       ///< "" if it has none.
  const char* meaning;    ///< Its effect for the artist, one line.
  const char* also = "";  ///< What more it may be, a clause that follows; no part of canonical_recipe().

  /// The value is the path of a file: a text or, in an object, the member "file", empty for none. Only a recipe on the
  /// disk may have such a key (view/server), and no output may be that file.
  bool names_file = false;
  /// canonical_recipe() writes this for null, the default; for a key that once could not be null.
  const char* canonical_null = nullptr;
  bool is_later = false;     ///< Added later: canonical_recipe() has it only where it differs from its default.
  bool shapes_asset = true;  ///< false: the asset's bytes do not depend on it, and it is no part of canonical_recipe().

  [[nodiscard]] std::string path() const { return std::string(section) + "." + name; }
};

/// All keys, section by section.
[[nodiscard]] std::span<const RecipeKey> recipe_keys();
/// The keys of "grow".
[[nodiscard]] std::span<const RecipeKey> grow_keys();

/// The files that a recipe names, as it writes them: paths relative to its folder.
[[nodiscard]] std::vector<std::string> files_named_by(const Recipe& recipe);

// JSON <-> one value of a recipe. The only place that knows how each type of value is written.

/// "wants a number from 0 to 1, found \"much\"": the message about a wrong value.
[[nodiscard]] tl::unexpected<std::string> wants(const std::string& what, const nlohmann::json& found);

/// Reads `json` into the field of `recipe`. The error is the rest of a sentence that starts with the key:
/// "wants a number from 0 to 1, found \"much\"".
tl::expected<void, std::string> read_value(const RecipeKey& key, const nlohmann::json& json, Recipe& recipe);

[[nodiscard]] nlohmann::json write_value(const RecipeKey& key, const Recipe& recipe);

/// `count` finite numbers in the range of coordinates.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> read_numbers(const nlohmann::json& value) {
  constexpr double kFarthest = 1.0e5;
  std::array<double, kCount> numbers{};
  if (!value.is_array() || value.size() != kCount) return std::nullopt;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (!value[i].is_number() || !(std::abs(value[i].template get<double>()) <= kFarthest)) return std::nullopt;
    numbers[i] = value[i].template get<double>();
  }
  return numbers;
}

/// A list of names with wildcards, not empty, or a single name.
tl::expected<void, std::string> read_patterns(const nlohmann::json& value, std::vector<std::string>& out);

/// A list of at most `most` entries, each read by `read(json, entry)`; the error names the entry.
template <typename Entry, typename Read>
tl::expected<void, std::string> read_entries(const nlohmann::json& value, const char* what, std::size_t most,
                                             const Read& read, std::vector<Entry>& out) {
  if (!value.is_array()) return wants(what, value);
  if (value.size() > most) return wants("at most " + std::to_string(most) + " entries", value.size());
  std::vector<Entry> entries;
  for (const nlohmann::json& item : value) {
    if (auto outcome = read(item, entries.emplace_back()); !outcome) {
      return tl::unexpected("[" + std::to_string(entries.size() - 1) + "]: " + outcome.error());
    }
  }
  out = std::move(entries);
  return {};
}

/// The reader of "patches.overrides".
tl::expected<void, std::string> read_overrides(const nlohmann::json& json, std::vector<PatchOverride>& out);
[[nodiscard]] nlohmann::json write_overrides(const std::vector<PatchOverride>& overrides);
/// The reader of "body.colliders".
tl::expected<void, std::string> read_body_colliders(const nlohmann::json& json, std::vector<RecipeBodyCollider>& out);
[[nodiscard]] nlohmann::json write_body_colliders(const std::vector<RecipeBodyCollider>& colliders);
/// The reader of "dynamics.limits".
tl::expected<void, std::string> read_bone_limits(const nlohmann::json& json, std::vector<RecipeBoneLimit>& out);
[[nodiscard]] nlohmann::json write_bone_limits(const std::vector<RecipeBoneLimit>& limits);
/// The reader of the keys of "textures" that name an image.
tl::expected<void, std::string> read_recipe_texture(const nlohmann::json& json, RecipeTexture& out);
[[nodiscard]] nlohmann::json write_recipe_texture(const RecipeTexture& texture);
/// The reader of "dynamics.links".
tl::expected<void, std::string> read_chain_links(const nlohmann::json& json, RecipeLinks& out);
[[nodiscard]] nlohmann::json write_chain_links(const RecipeLinks& links);

}  // namespace coif::cook
