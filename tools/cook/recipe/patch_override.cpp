#include "cook/recipe/patch_override.h"

#include "cook/recipe/recipe_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

namespace coif::cook {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;
using R = Recipe;

constexpr std::size_t kMostOverrides = 4096;

// Words that patches have and the whole hair has not. Their fields are borrowed.
constexpr RecipeKey kRoot{"", "root", &R::strand_root, "", 0, 0, "auto|low_u|high_u|low_v|high_v|swap", "", ""};
constexpr RecipeKey kChain{"", "chain", &R::strand_root, "", 0, 0, "auto|none", "", ""};

const RecipeKey& key_at(const char* path) {
  return *std::ranges::find_if(recipe_keys(), [path](const RecipeKey& key) { return key.path() == path; });
}

/// A word of an override, for a value that the whole recipe has too.
struct OverrideKey {
  const char* name;
  const RecipeKey& (*key)();  ///< The key by which it is read, checked and written.
  bool of_motion;
  void (*take)(Recipe& from, PatchOverride& to);
  bool (*give)(const PatchOverride& from, Recipe& to);  ///< False: the override does not give it.
  void (*add)(const PatchOverride& later, PatchOverride& to);
};

template <auto kInRecipe, auto kInOverride>
OverrideKey override_key(const char* name, const RecipeKey& (*key)(), bool of_motion) {
  return {name,
          key,
          of_motion,
          [](Recipe& from, PatchOverride& to) { to.*kInOverride = std::move(from.*kInRecipe); },
          [](const PatchOverride& from, Recipe& to) {
            if (from.*kInOverride) to.*kInRecipe = *(from.*kInOverride);
            return bool(from.*kInOverride);
          },
          [](const PatchOverride& later, PatchOverride& to) {
            if (later.*kInOverride) to.*kInOverride = later.*kInOverride;
          }};
}

using O = PatchOverride;

const OverrideKey kOverrideKeys[] = {
    override_key<&R::strand_root, &O::root>(
        "root", []() -> const RecipeKey& { return kRoot; }, false),
    override_key<&R::strand_root, &O::chain>(
        "chain", []() -> const RecipeKey& { return kChain; }, false),
    override_key<&R::resistance, &O::resistance>(
        "resistance", []() -> const RecipeKey& { return key_at("dynamics.resistance"); }, true),
    override_key<&R::dynamics_preset, &O::preset>(
        "preset", []() -> const RecipeKey& { return key_at("dynamics.preset"); }, true),
    override_key<&R::liveliness, &O::liveliness>(
        "liveliness", []() -> const RecipeKey& { return key_at("dynamics.liveliness"); }, true),
    override_key<&R::friction, &O::friction>(
        "friction", []() -> const RecipeKey& { return key_at("dynamics.friction"); }, true),
    override_key<&R::gravity_scale, &O::gravity_scale>(
        "gravity_scale", []() -> const RecipeKey& { return key_at("dynamics.gravity_scale"); }, true),
    override_key<&R::damping_ratio, &O::damping_ratio>(
        "damping_ratio", []() -> const RecipeKey& { return key_at("dynamics.damping_ratio"); }, true),
    override_key<&R::angle_limit, &O::angle_limit>(
        "angle_limit", []() -> const RecipeKey& { return key_at("dynamics.angle_limit"); }, true),
    override_key<&R::parent_share, &O::parent_share>(
        "parent_share", []() -> const RecipeKey& { return key_at("dynamics.parent_share"); }, true),
};

Outcome read_name(const json& value, std::string& name) {
  if (!value.is_string() || value.get<std::string>().empty()) return wants("a name, * and ? are wildcards", value);
  name = value.get<std::string>();
  return {};
}

/// A number or a list of numbers.
Outcome read_indices(const json& value, std::vector<std::uint32_t>& indices) {
  const json list = value.is_array() ? value : json::array({value});
  for (const json& item : list) {
    if (!item.is_number_unsigned() || item.get<std::uint64_t>() > 0xFFFFFFFEu) {
      return wants("a number as 'coif cook --list patches' prints it, or a list of them", value);
    }
    indices.push_back(item.get<std::uint32_t>());
  }
  return indices.empty() ? wants("at least one number", value) : Outcome{};
}

Outcome read_box(const json& value, PatchSelection& select) {
  const auto corner = [&](std::size_t i) {
    return value.is_array() && value.size() == 2 ? read_numbers<3>(value[i]) : std::nullopt;
  };
  const auto low = corner(0), high = corner(1);
  if (!low || !high) return wants("two corners [[x, y, z], [x, y, z]] in metres, Y up", value);
  for (std::size_t k = 0; k < 3; ++k) {
    if ((*low)[k] > (*high)[k]) return wants("its lowest corner first", value);
  }
  select.box = {(*low)[0], (*low)[1], (*low)[2], (*high)[0], (*high)[1], (*high)[2]};
  return {};
}

Outcome read_select(const json& values, PatchSelection& select) {
  constexpr const char* kWords = "mesh, material, island, index, box, near and within";
  if (!values.is_object()) return wants(fmt::format("an object of {}", kWords), values);
  for (const auto& [name, value] : values.items()) {
    Outcome outcome;
    if (name == "mesh" || name == "material") {
      outcome = read_name(value, name == "mesh" ? select.mesh : select.material);
    } else if (name == "island" || name == "index") {
      outcome = read_indices(value, name == "index" ? select.indices : select.islands);
    } else if (name == "box") {
      outcome = read_box(value, select);
    } else if (name == "near") {
      select.near = read_numbers<3>(value);
      if (!select.near) outcome = wants("a point [x, y, z] in metres, Y up", value);
    } else if (name == "within") {
      if (!value.is_number() || !(value.get<double>() > 0))
        outcome = wants("metres around the point of \"near\"", value);
      if (outcome) select.within = value.get<double>();
    } else {
      return tl::unexpected(fmt::format("\"{}\" selects nothing; there are {}", excerpt(name), kWords));
    }
    if (!outcome) return tl::unexpected(fmt::format("\"{}\" {}", name, outcome.error()));
  }
  if (select.within && !select.near) return tl::unexpected(std::string("\"within\" needs the point of \"near\""));
  if (select.is_empty()) return tl::unexpected(fmt::format("selects all patches; say which, by {}", kWords));
  return {};
}

Outcome read_said(const std::string& name, const json& value, PatchOverride& said) {
  if (name == "keep") {
    if (!value.is_boolean()) return wants("true or false", value);
    said.keep = value.get<bool>();
    return {};
  }
  const auto found = std::ranges::find_if(kOverrideKeys, [&](const OverrideKey& key) { return key.name == name; });
  if (found == std::end(kOverrideKeys)) {
    std::vector<const char*> names;
    for (const OverrideKey& key : kOverrideKeys) names.push_back(key.name);
    return tl::unexpected(
        fmt::format("cannot be said of patches alone; there are select, keep, {}", fmt::join(names, ", ")));
  }
  Recipe scratch;
  if (Outcome outcome = read_value(found->key(), value, scratch); !outcome) return outcome;
  found->take(scratch, said);
  return {};
}

Outcome read_override(const json& values, PatchOverride& said) {
  if (!values.is_object() || !values.contains("select")) return wants("an object with \"select\"", values);
  if (values.size() < 2) return tl::unexpected(std::string("says nothing of the patches that it selects"));
  for (const auto& [name, value] : values.items()) {
    Outcome outcome = name == "select" ? read_select(value, said.select) : read_said(name, value, said);
    if (!outcome) return tl::unexpected(fmt::format("\"{}\" {}", excerpt(name), outcome.error()));
  }
  return {};
}

json write_select(const PatchSelection& select) {
  json values = json::object();
  if (!select.mesh.empty()) values["mesh"] = select.mesh;
  if (!select.material.empty()) values["material"] = select.material;
  if (!select.islands.empty()) values["island"] = select.islands;
  if (!select.indices.empty()) values["index"] = select.indices;
  if (select.box) {
    const auto& b = *select.box;
    values["box"] = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  }
  if (select.near) values["near"] = *select.near;
  if (select.within) values["within"] = *select.within;
  return values;
}

}  // namespace

void PatchOverride::add_motion(const PatchOverride& later) {
  for (const OverrideKey& key : kOverrideKeys) {
    if (key.of_motion) key.add(later, *this);
  }
}

void PatchOverride::apply_motion(RigRecipe& recipe) const {
  Recipe whole;
  RigRecipe& of_rig = whole;
  of_rig = std::move(recipe);
  for (const OverrideKey& key : kOverrideKeys) {
    if (key.of_motion) key.give(*this, whole);
  }
  recipe = std::move(of_rig);
}

Outcome read_overrides(const json& value, std::vector<PatchOverride>& out) {
  return read_entries(value, "a list of {\"select\": {...}, ...}", kMostOverrides, read_override, out);
}

json write_overrides(const std::vector<PatchOverride>& overrides) {
  json list = json::array();
  for (const PatchOverride& said : overrides) {
    json values = {{"select", write_select(said.select)}};
    if (said.keep) values["keep"] = *said.keep;
    for (const OverrideKey& key : kOverrideKeys) {
      Recipe scratch;
      if (key.give(said, scratch)) values[key.name] = write_value(key.key(), scratch);
    }
    list.push_back(std::move(values));
  }
  return list;
}

}  // namespace coif::cook
