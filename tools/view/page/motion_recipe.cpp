// asset_motion.h in the words of recipes and of the page.

#include "view/page/asset_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace coif::view {
namespace {

constexpr std::size_t kMostPoints = 6;
/// The page draws both curves by these exponents (control_curve.js); equal looks must mean equal values.
constexpr double kResistanceSeen = 1.0 / 3, kRatioSeen = 0.5;
constexpr std::size_t kMostShown = 400;

/// A number with this many significant digits.
std::string digits(double value, int count) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", count, value);
  return text;
}

std::string in_json(std::span<const cook::CurvePoint> points) {
  std::string text = "[";
  for (const cook::CurvePoint& point : points) {
    text.append(text.size() > 1 ? ", [" : "[")
        .append(digits(point.at, 4))
        .append(", ")
        .append(digits(point.value, 5))
        .append("]");
  }
  return text + "]";
}

/// Removes points with equal places and values.
std::vector<cook::CurvePoint> told_apart(std::vector<cook::CurvePoint> points) {
  for (cook::CurvePoint& point : points) {
    point.at = std::round(point.at * 500) / 500;
    point.value = std::strtod(digits(point.value, 3).c_str(), nullptr);
  }
  const auto order = [](const cook::CurvePoint& a, const cook::CurvePoint& b) {
    return std::pair(a.at, a.value) < std::pair(b.at, b.value);
  };
  std::sort(points.begin(), points.end(), order);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() > kMostShown) points.resize(kMostShown);
  return points;
}

class JsonObject {
 public:
  void add(std::string_view name, std::string_view json) {
    text_.append(text_.empty() ? "\"" : ", \"").append(name).append("\": ").append(json);
  }
  void add(std::string_view name, const std::optional<double>& value) {
    if (value) add(name, digits(*value, 6));
  }
  void add(std::string_view name, bool value) { add(name, std::string_view(value ? "true" : "false")); }
  [[nodiscard]] std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string curve_json(std::span<const cook::CurvePoint> points, std::vector<cook::CurvePoint> bones) {
  JsonObject curve;
  curve.add("points", in_json(points));
  curve.add("bones", in_json(told_apart(std::move(bones))));
  return curve.text();
}

}  // namespace

std::vector<cook::CurvePoint> AssetMotion::resistances() const {
  std::vector<cook::CurvePoint> values;
  for (const Bone& bone : bones_) values.push_back({bone.place, bone.own.resistance});
  return values;
}

std::vector<cook::CurvePoint> AssetMotion::ratios(double Bone::*ratio) const {
  std::vector<cook::CurvePoint> values;
  for (const Bone& bone : bones_) values.push_back({bone.place, bone.*ratio});
  return values;
}

/// Adds the values that the cook would choose anew beside a resistance.
MotionTuning AssetMotion::completed(MotionTuning tuning) const {
  if (!goes_by_curve(tuning)) return tuning;
  if (tuning.resistance.empty()) tuning.resistance = reduced_curve(resistances(), kResistanceSeen, kMostPoints);
  if (tuning.damping_ratio.empty() && !tuning.liveliness && says_ratio())
    tuning.damping_ratio = reduced_curve(ratios(&Bone::curve_ratio), kRatioSeen, kMostPoints);
  tuning.friction = tuning.friction.value_or(mean_.friction);
  tuning.air_follow = tuning.air_follow.value_or(mean_.air_follow);
  if (has_springs_) tuning.gravity_scale = tuning.gravity_scale.value_or(mean_.gravity_scale);
  tuning.preset = nullptr;
  return tuning;
}

std::string AssetMotion::recipe(const MotionTuning& said) const {
  if (is_empty()) return "{}";
  const MotionTuning tuning = completed(said);
  const bool by_curve = !tuning.resistance.empty();
  JsonObject recipe;
  if (by_curve) {
    if (has_springs_) recipe.add("source", std::string_view("\"curves\""));
    const ChainModel model = rig_.bones[0].model;
    const auto is_same = [&](const lab::RigBone& bone) { return bone.model == model; };
    const bool is_one = std::all_of(rig_.bones.begin(), rig_.bones.end(), is_same);
    if (is_one) recipe.add("model", std::string_view(model == ChainModel::kPassive ? "\"passive\"" : "\"cascade\""));
    recipe.add("resistance", in_json(tuning.resistance));
    if (has_springs_) recipe.add("sags", true);
  } else if (tuning.preset != nullptr) {
    if (preset_ == nullptr) {  // Otherwise the present preset would stay in force.
      recipe.add("source", std::string_view("\"curves\""));
      recipe.add("resistance", std::string_view("[]"));
    }
    recipe.add("preset", std::string("\"").append(tuning.preset->name).append("\""));
  }
  if (!tuning.damping_ratio.empty()) {
    recipe.add("damping_ratio", in_json(tuning.damping_ratio));
  } else if (tuning.liveliness) {
    recipe.add("liveliness", tuning.liveliness);
    if (says_ratio()) recipe.add("damping_ratio", std::string_view("null"));  // which would hold before it
  }
  recipe.add("friction", tuning.friction);
  recipe.add("air_follow", tuning.air_follow);
  recipe.add("gravity_scale", tuning.gravity_scale);
  recipe.add("angle_limit", tuning.angle_limit);
  return recipe.text();
}

std::string AssetMotion::json() const {
  JsonObject all;
  all.add("moves", !is_empty());
  all.add("preset", preset_ != nullptr);
  all.add("springs", has_springs_);
  const auto is_changed = [](const lab::RigBone& bone) { return bone.asked.has_value(); };
  all.add("conditioned", std::any_of(rig_.bones.begin(), rig_.bones.end(), is_changed));
  all.add("resistance", curve_json(reduced_curve(resistances(), kResistanceSeen, kMostPoints), resistances()));
  const std::vector<cook::CurvePoint> shown = ratios(&Bone::shown_ratio);
  all.add("damping_ratio", curve_json(reduced_curve(shown, kRatioSeen, kMostPoints), shown));
  return all.text();
}

}  // namespace coif::view
