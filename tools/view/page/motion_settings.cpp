#include "view/page/tunable_motion.h"

#include <cstddef>
#include <optional>

namespace coif::view {
namespace {

/// The preset with the choice's number; null: none.
const cook::HairPreset* preset_of(const ViewSettings& settings) {
  const auto presets = cook::hair_presets();
  const bool is_one = settings.preset >= 1 && settings.preset <= float(presets.size());
  return is_one ? &presets[std::size_t(settings.preset) - 1] : nullptr;
}

}  // namespace

ViewSettings with_motion(ViewSettings s, const AssetMotion& motion) {
  const MeanMotion& mean = motion.mean();
  if (motion.is_empty()) return s;
  if (motion.preset() != nullptr) s.preset = float(motion.preset() - cook::hair_presets().data()) + 1;
  s.liveliness = float(mean.liveliness);
  s.gravity_scale = float(mean.gravity_scale);
  s.friction = float(mean.friction);
  s.air_follow = float(mean.air_follow);
  s.angle_limit = float(mean.angle_limit);
  return s;
}

MotionTuning tuning_between(const ViewSettings& before, const ViewSettings& s) {
  const auto changed = [](float from, float to) { return from != to ? std::optional(double(to)) : std::nullopt; };
  MotionTuning tuning;
  if (s.preset != before.preset) tuning.preset = preset_of(s);
  tuning.liveliness = changed(before.liveliness, s.liveliness);
  tuning.friction = changed(before.friction, s.friction);
  tuning.gravity_scale = changed(before.gravity_scale, s.gravity_scale);
  tuning.air_follow = changed(before.air_follow, s.air_follow);
  tuning.angle_limit = changed(before.angle_limit, s.angle_limit);
  return tuning;
}

}  // namespace coif::view
