#include "cook/dynamics/settle_model.h"

#include "cook/dynamics/natural_dynamics.h"
#include "cook/dynamics/rest_shape.h"

#include <algorithm>

namespace coif {

void settle_model(const Recipe& recipe, const std::vector<MotionSource>& sources,
                  std::span<const double> damping_ratios, AssetContents& contents, Findings& findings) {
  std::vector<bool> by_preset, keeps_shape;
  for (const MotionSource source : sources) {
    by_preset.push_back(source == MotionSource::kPreset);
    keeps_shape.push_back(source == MotionSource::kPreset || source == MotionSource::kCurve);
  }
  const bool any_preset = std::ranges::find(by_preset, true) != by_preset.end();
  const bool passive = recipe.dynamics_model == "passive" || (recipe.dynamics_model == "auto" && any_preset);
  if (passive) {
    contents.skeleton.flags |= kSkeletonPassive;
    if (recipe.torsion && *recipe.torsion < double(kShortestArc)) {
      findings.warn(
          "\"dynamics.torsion\": the passive model has no twist; for one say \"dynamics.model\": \"cascade\"");
    }
    if (!recipe.torsion) {
      for (DynamicsRecord& record : contents.dynamics) record.torsion = kShortestArc;
    }
  }
  if (any_preset) bake_natural_dynamics(preset_of(recipe), damping_ratios, by_preset, contents, findings);
  if (!recipe.sags) keep_rest_shape(keeps_shape, contents, findings);
}

}  // namespace coif
