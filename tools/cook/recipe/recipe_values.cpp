#include "base/json.h"
#include "cook/recipe/recipe_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <type_traits>

namespace coif::cook {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;

std::string number_range(const RecipeKey& key) {
  return fmt::format("from {} to {}{}{}", key.low, key.high, *key.unit != 0 ? " " : "", key.unit);
}

bool allowed(const RecipeKey& key, const json& value) {
  return value.is_number() && value.get<double>() >= key.low && value.get<double>() <= key.high;
}

std::vector<std::string> words_of(const RecipeKey& key) {
  std::vector<std::string> words;
  std::istringstream list(key.choices);
  for (std::string word; std::getline(list, word, '|');) words.push_back(word);
  return words;
}

/// The place of the word among the choices of `key`.
tl::expected<std::size_t, std::string> read_choice(const RecipeKey& key, const json& value) {
  const std::vector<std::string> words = words_of(key);
  const auto found = value.is_string() ? std::ranges::find(words, value.get<std::string>()) : words.end();
  if (found != words.end()) return std::size_t(found - words.begin());
  return value.is_string() ? wants(fmt::format("one of {}", key.choices), value) : wants("a text", value);
}

Outcome read(const RecipeKey&, const json& value, bool& out) {
  if (!value.is_boolean()) return wants("true or false", value);
  out = value.get<bool>();
  return {};
}

Outcome read(const RecipeKey& key, const json& value, double& out) {
  if (!allowed(key, value)) return wants("a number " + number_range(key), value);
  out = value.get<double>();
  return {};
}

Outcome read(const RecipeKey& key, const json& value, std::uint32_t& out) {
  if (!allowed(key, value) || !value.is_number_integer()) return wants("a whole number " + number_range(key), value);
  out = value.get<std::uint32_t>();
  return {};
}

Outcome read(const RecipeKey& key, const json& value, std::string& out) {
  if (!value.is_string()) return wants("a text", value);
  if (key.choices != nullptr) {
    if (const auto choice = read_choice(key, value); !choice) return tl::unexpected(choice.error());
  }
  out = value.get<std::string>();
  return {};
}

Outcome read(const RecipeKey&, const json& value, std::vector<std::string>& out) {
  std::vector<std::string> texts;
  if (!value.is_array()) return wants("a list of names", value);
  for (const json& item : value) {
    if (!item.is_string()) return wants("a list of names", value);
    texts.push_back(item.get<std::string>());
  }
  out = std::move(texts);
  return {};
}

Outcome read(const RecipeKey& key, const json& value, std::vector<CurvePoint>& out) {
  const std::string what = "points [place 0..1, value " + number_range(key) + "] with ascending places";
  if (!value.is_array()) return wants(what, value);
  std::vector<CurvePoint> points;
  for (const json& item : value) {
    const bool pair = item.is_array() && item.size() == 2 && item[0].is_number() && allowed(key, item[1]);
    if (!pair) return wants(what, item);
    const CurvePoint point{item[0].get<double>(), item[1].get<double>()};
    const bool ascending = points.empty() || point.at > points.back().at;
    if (!(point.at >= 0 && point.at <= 1) || !ascending) return wants(what, item);
    points.push_back(point);
  }
  out = std::move(points);
  return {};
}

Outcome read(const RecipeKey& key, const json& value, NumberOrCurve& out) {
  if (value.is_array()) {
    std::vector<CurvePoint> points;
    if (Outcome outcome = read(key, value, points); !outcome) return outcome;
    if (points.empty()) return wants("at least one point, or a number " + number_range(key), value);
    out = std::move(points);
    return {};
  }
  if (!allowed(key, value)) {
    return wants(fmt::format("a number {}, or points [place 0..1, such a number]", number_range(key)), value);
  }
  out = value.get<double>();
  return {};
}

Outcome read(const RecipeKey&, const json& value, std::vector<std::array<double, 3>>& out) {
  constexpr std::size_t kMostPoints = 4096;
  const auto read_point = [](const json& item, std::array<double, 3>& point) -> Outcome {
    const auto numbers = read_numbers<3>(item);
    if (!numbers) return wants("a point [x, y, z] in metres", item);
    point = *numbers;
    return {};
  };
  return read_entries(value, "a list of points [x, y, z]", kMostPoints, read_point, out);
}

Outcome read(const RecipeKey&, const json& value, std::vector<PatchOverride>& out) {
  return read_overrides(value, out);
}

Outcome read(const RecipeKey&, const json& value, std::vector<RecipeBodyCollider>& out) {
  return read_body_colliders(value, out);
}

Outcome read(const RecipeKey&, const json& value, std::vector<RecipeBoneLimit>& out) {
  return read_bone_limits(value, out);
}

Outcome read(const RecipeKey&, const json& value, RecipeLinks& out) { return read_chain_links(value, out); }

Outcome read(const RecipeKey&, const json& value, RecipeTexture& out) { return read_recipe_texture(value, out); }

template <std::size_t kCount>
Outcome read(const RecipeKey& key, const json& value, std::array<double, kCount>& out) {
  const std::string what = fmt::format("{} numbers {}", kCount, number_range(key));
  if (!value.is_array() || value.size() != kCount) return wants(what, value);
  for (const json& item : value) {
    if (!allowed(key, item)) return wants(what, value);
  }
  for (std::size_t i = 0; i < kCount; ++i) out[i] = value[i].get<double>();
  return {};
}

template <typename Value>
Outcome read(const RecipeKey& key, const json& value, std::optional<Value>& out) {
  if (value.is_null()) {
    out.reset();
    return {};
  }
  Value given{};
  if (Outcome outcome = read(key, value, given); !outcome) return outcome;
  out = given;
  return {};
}

template <typename Value>
json write(const Value& value) {
  return value;
}

json write(const std::vector<CurvePoint>& points) {
  json list = json::array();
  for (const CurvePoint& point : points) list.push_back({point.at, point.value});
  return list;
}

json write(const NumberOrCurve& value) {
  return std::visit([](const auto& held) { return write(held); }, value);
}

json write(const std::vector<PatchOverride>& overrides) { return write_overrides(overrides); }

json write(const std::vector<RecipeBodyCollider>& colliders) { return write_body_colliders(colliders); }

json write(const std::vector<RecipeBoneLimit>& limits) { return write_bone_limits(limits); }

json write(const RecipeLinks& links) { return write_chain_links(links); }

json write(const RecipeTexture& texture) { return write_recipe_texture(texture); }

template <typename Value>
json write(const std::optional<Value>& value) {
  return value ? write(*value) : json(nullptr);
}

}  // namespace

tl::unexpected<std::string> wants(const std::string& what, const json& found) {
  return tl::unexpected(fmt::format("wants {}, found {}", what, excerpt(found.dump())));
}

Outcome read_patterns(const json& value, std::vector<std::string>& out) {
  const json list = value.is_string() ? json::array({value}) : value;
  std::vector<std::string> patterns;
  for (const json& item : list_of(list)) {
    if (item.is_string() && !item.get<std::string>().empty()) patterns.push_back(item.get<std::string>());
  }
  if (patterns.empty() || patterns.size() != list.size())
    return wants("a name or a list of names, * and ? are wildcards", value);
  out = std::move(patterns);
  return {};
}

Outcome read_value(const RecipeKey& key, const json& json, Recipe& recipe) {
  const auto read_field = [&](auto field) -> Outcome {
    if constexpr (std::is_same_v<decltype(field), ChoiceField>) {
      return read_choice(key, json).map([&](std::size_t choice) { field.set(recipe, choice); });
    } else {
      return read(key, json, recipe.*field);
    }
  };
  return std::visit(read_field, key.field);
}

json write_value(const RecipeKey& key, const Recipe& recipe) {
  const auto write_field = [&](auto field) -> json {
    if constexpr (std::is_same_v<decltype(field), ChoiceField>) {
      return words_of(key)[field.get(recipe)];
    } else {
      return write(recipe.*field);
    }
  };
  return std::visit(write_field, key.field);
}

}  // namespace coif::cook
