#include "cook/bake_dynamics.h"

namespace coif {

double evaluate_curve(std::span<const CurvePoint> curve, double at) {
  if (at <= curve.front().at) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (at > curve[i].at) continue;
    const double share = (at - curve[i - 1].at) / (curve[i].at - curve[i - 1].at);
    return curve[i - 1].value + share * (curve[i].value - curve[i - 1].value);
  }
  return curve.back().value;
}

std::vector<DynamicsRecord> bake_dynamics(const Skeleton& skeleton, const Recipe& recipe) {
  std::vector<DynamicsRecord> records;
  if (skeleton.chains.empty()) return records;
  for (const SkeletonBone& bone : skeleton.bones) {
    const double root_place = bone.kind == BoneKind::kSimulated ? skeleton.bones[bone.parent].place : 0;
    const double resistance = evaluate_curve(recipe.resistance, 0.5 * (root_place + bone.place));
    records.push_back(
        {float(resistance), float(recipe.friction), float(recipe.gravity_scale), float(recipe.authoring_rate)});
  }
  return records;
}

}  // namespace coif
