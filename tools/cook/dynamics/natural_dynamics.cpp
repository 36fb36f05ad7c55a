#include "cook/dynamics/natural_dynamics.h"

#include "cook/dynamics/bone_motion.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

namespace coif::cook {

void bake_natural_dynamics(const SaidMotion& said, AssetContents& contents, Findings& findings) {
  const lab::OpenedAsset opened(contents);
  if (!opened.asset().is_open()) return;
  const lab::Rig rig = lab::rig_of(opened.asset());
  const std::vector<lab::Carried> carried = lab::carried_at_rest(rig.bones);
  std::map<std::string_view, std::pair<const HairPreset*, std::size_t>> counts;
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const std::size_t b = rig.rigid_count + i;
    if (said.sources[b] != MotionSource::kPreset) continue;
    const HairPreset& preset = *said.presets[b];
    auto& [counted, count] = counts[preset.name];
    counted = &preset;
    ++count;
    const NaturalMotion motion{preset.bending_length, said.damping_ratios[b], said.is_tied(b)};
    bake_natural(rig, carried, i, motion, contents.dynamics[b]);
  }
  for (const auto& [name, counted] : counts) {
    findings.note(fmt::format("{} bones move as {} hair: what is longer than {:.0f} mm hangs", counted.second, name,
                              1000 * counted.first->bending_length));
  }
}

}  // namespace coif::cook
