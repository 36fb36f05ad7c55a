#include "cook/recipe/bone_limit.h"

#include "cook/recipe/recipe_keys.h"

#include <fmt/format.h>

namespace coif::cook {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;

constexpr const char* kLimitWords = "bones, kind, angle, yaw and axis";
constexpr std::size_t kMostLimits = 4096;

Outcome read_degrees(const json& value, double most, double& out) {
  const bool fits = value.is_number() && value.get<double>() >= 0 && value.get<double>() <= most;
  if (!fits) return wants(fmt::format("a number from 0 to {} degrees", most), value);
  out = value.get<double>();
  return {};
}

Outcome read_kind(const json& value, std::string& out) {
  for (const char* kind : {"cone", "hinge", "spherical", "none"}) {
    if (value == json(kind)) out = kind;
  }
  return value == json(out) ? Outcome{} : wants("one of cone|hinge|spherical|none", value);
}

Outcome read_axis(const json& value, std::array<double, 3>& out) {
  const auto axis = read_numbers<3>(value);
  const bool fits = axis && (*axis)[0] * (*axis)[0] + (*axis)[1] * (*axis)[1] + (*axis)[2] * (*axis)[2] > 1.0e-12;
  if (!fits) return wants("a direction [x, y, z], Y up", value);
  out = *axis;
  return {};
}

Outcome read_limit_word(const std::string& name, const json& value, RecipeBoneLimit& out) {
  if (name == "bones") return read_patterns(value, out.bones);
  if (name == "kind") return read_kind(value, out.kind);
  if (name == "angle") return read_degrees(value, 180, out.angle);
  if (name == "yaw") return read_degrees(value, 90, out.yaw);
  if (name == "axis") return read_axis(value, out.axis);
  return tl::unexpected(fmt::format("is no word of a limit; there are {}", kLimitWords));
}

Outcome read_bone_limit(const json& values, RecipeBoneLimit& out) {
  if (!values.is_object()) return wants(fmt::format("an object of {}", kLimitWords), values);
  for (const auto& [name, value] : values.items()) {
    if (Outcome outcome = read_limit_word(name, value, out); !outcome) {
      return tl::unexpected(fmt::format("\"{}\" {}", excerpt(name), outcome.error()));
    }
  }
  const bool has_angle = values.contains("angle"), has_yaw = values.contains("yaw");
  const auto fault = [](const char* what) { return tl::unexpected(std::string(what)); };
  if (out.bones.empty()) return fault("has no \"bones\"");
  if (out.kind.empty()) return fault("has no \"kind\"");
  if (has_angle != (out.kind != "none")) return fault(has_angle ? "is none, and has an \"angle\"" : "has no \"angle\"");
  if (has_yaw != (out.kind == "spherical")) {
    return fault(has_yaw ? "has a \"yaw\", which belongs to a spherical limit" : "is spherical and has no \"yaw\"");
  }
  return {};
}

}  // namespace

Outcome read_bone_limits(const json& value, std::vector<RecipeBoneLimit>& out) {
  return read_entries(value, "a list of {\"bones\": [...], \"kind\": \"cone\", \"angle\": 30}", kMostLimits,
                      read_bone_limit, out);
}

json write_bone_limits(const std::vector<RecipeBoneLimit>& limits) {
  json list = json::array();
  for (const RecipeBoneLimit& limit : limits) {
    json values = {{"bones", limit.bones}, {"kind", limit.kind}};
    if (limit.kind != "none") values["angle"] = limit.angle;
    if (limit.kind == "spherical") values["yaw"] = limit.yaw;
    if (limit.axis != RecipeBoneLimit{}.axis) values["axis"] = limit.axis;
    list.push_back(std::move(values));
  }
  return list;
}

}  // namespace coif::cook
