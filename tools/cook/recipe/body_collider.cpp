#include "cook/recipe/body_collider.h"

#include "cook/recipe/recipe_keys.h"

#include <fmt/format.h>

namespace coif::cook {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;

constexpr const char* kBodyWords = "bone, center, tail, normal, radius, tail_radius, inside and hair";
constexpr std::size_t kMostBodyEntries = 32;
constexpr double kSmallestRadius = 1.0e-4, kLargestRadius = 1000;  // metres

Outcome read_point(const json& value, const char* what, std::optional<std::array<double, 3>>& out) {
  out = read_numbers<3>(value);
  return out ? Outcome{} : wants(what, value);
}

Outcome read_radius(const json& value, std::optional<double>& out) {
  const bool fits =
      value.is_number() && value.get<double>() >= kSmallestRadius && value.get<double>() <= kLargestRadius;
  if (!fits) return wants(fmt::format("a number from {} to {} m", kSmallestRadius, kLargestRadius), value);
  out = value.get<double>();
  return {};
}

Outcome read_word(const std::string& name, const json& value, RecipeBodyCollider& out) {
  constexpr const char* kPoint = "a point [x, y, z] in metres, Y up";
  if (name == "bone") {
    if (!value.is_string() || value.get<std::string>().empty()) return wants("the name of a bone", value);
    out.bone = value.get<std::string>();
    return {};
  }
  if (name == "center") return read_point(value, kPoint, out.center);
  if (name == "tail") return read_point(value, kPoint, out.tail);
  if (name == "normal") return read_point(value, "a direction [x, y, z], Y up", out.normal);
  if (name == "radius") return read_radius(value, out.radius);
  if (name == "tail_radius") return read_radius(value, out.tail_radius);
  if (name == "hair") return read_patterns(value, out.hair);
  if (name != "inside") return tl::unexpected(fmt::format("is no word of a body collider; there are {}", kBodyWords));
  if (!value.is_boolean()) return wants("true or false", value);
  out.inside = value.get<bool>();
  return {};
}

double square_of(const std::array<double, 3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// A sentence about values that contradict each other; empty if there are none.
std::string shape_fault(const RecipeBodyCollider& c) {
  if (c.bone.empty()) return "has no \"bone\"";
  if (c.normal && square_of(*c.normal) < 1.0e-12) return "has a \"normal\" without direction";
  if (c.normal && (c.tail || c.radius || c.tail_radius || c.inside)) {
    return "is a plane by its \"normal\", which has no tail, radius or inside";
  }
  if (!c.normal && !c.radius) return "has no \"radius\"; a plane has a \"normal\"";
  if (c.tail_radius && !c.tail) return "has a \"tail_radius\" and no \"tail\"";
  if (c.tail_radius && c.inside) return "cannot keep hair inside a capsule with two radii";
  return {};
}

Outcome read_body_collider(const json& values, RecipeBodyCollider& out) {
  if (!values.is_object()) return wants(fmt::format("an object of {}", kBodyWords), values);
  for (const auto& [name, value] : values.items()) {
    if (Outcome outcome = read_word(name, value, out); !outcome) {
      return tl::unexpected(fmt::format("\"{}\" {}", excerpt(name), outcome.error()));
    }
  }
  const std::string fault = shape_fault(out);
  return fault.empty() ? Outcome{} : tl::unexpected(fault);
}

json write_body_collider(const RecipeBodyCollider& c) {
  json values = {{"bone", c.bone}};
  if (c.center) values["center"] = *c.center;
  if (c.tail) values["tail"] = *c.tail;
  if (c.normal) values["normal"] = *c.normal;
  if (c.radius) values["radius"] = *c.radius;
  if (c.tail_radius) values["tail_radius"] = *c.tail_radius;
  if (c.inside) values["inside"] = true;
  if (!c.hair.empty()) values["hair"] = c.hair;
  return values;
}

}  // namespace

Outcome read_body_colliders(const json& value, std::vector<RecipeBodyCollider>& out) {
  return read_entries(value, "a list of {\"bone\": \"...\", \"radius\": 0.1, ...}", kMostBodyEntries,
                      read_body_collider, out);
}

json write_body_colliders(const std::vector<RecipeBodyCollider>& colliders) {
  json list = json::array();
  for (const RecipeBodyCollider& collider : colliders) list.push_back(write_body_collider(collider));
  return list;
}

}  // namespace coif::cook
