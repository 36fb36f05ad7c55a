#include "cook/dynamics/natural_dynamics.h"

#include "cook/dynamics/bake_dynamics.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace coif {
namespace {

/// The resistance that Algorithm 1 needs for this stiffness at this rate.
double resistance_for(double stiffness, double rate) {
  const double pull = stiffness / (rate * rate);
  return pull / (1 + pull);
}

}  // namespace

void bake_natural_dynamics(const SaidMotion& said, AssetContents& contents, Findings& findings) {
  const OpenedAsset opened(contents);
  if (!opened.asset().is_open()) return;
  const Rig rig = rig_of(opened.asset());
  const std::vector<Carried> carried = carried_at_rest(rig.bones);
  std::map<std::string_view, std::pair<const HairPreset*, std::size_t>> counts;
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const RigBone& bone = rig.bones[i];
    const std::size_t b = rig.rigid_count + i;
    if (said.sources[b] != MotionSource::kPreset) continue;
    const HairPreset& preset = *said.presets[b];
    auto& [counted, count] = counts[preset.name];
    counted = &preset;
    ++count;
    // A root does not turn: its hair is bent from the scalp on, over half a bone.
    const double span =
        bone.parent < 0 ? bone.length / 2 : 0.5 * (bone.length + rig.bones[std::size_t(bone.parent)].length);
    const double stiffness = kGravity * std::pow(preset.bending_length, 3) / span / carried[i].inertia;
    DynamicsRecord& record = contents.dynamics[b];
    record.stiffness = float(std::min(stiffness, kMostStiffness));
    const double swing = std::sqrt(double(record.stiffness) +
                                   kGravity * std::abs(bone.gravity_scale) * carried[i].arm / carried[i].inertia);
    record.damping = float(std::min(2 * said.damping_ratios[b] * swing, kMostDamping));
    record.resistance = float(resistance_for(double(record.stiffness), double(record.authoring_rate)));
  }
  for (const auto& [name, counted] : counts) {
    findings.note(fmt::format("{} bones move as {} hair: what is longer than {:.0f} mm hangs", counted.second, name,
                              1000 * counted.first->bending_length));
  }
}

}  // namespace coif
