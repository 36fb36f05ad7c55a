#include "cook/dynamics/choose_model.h"

#include "cook/dynamics/bone_motion.h"
#include "cook/recipe/rig_recipe.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::cook {
namespace {

void set_models(const RigRecipe& recipe, std::span<const ChainModel> models, AssetContents& contents,
                Findings& findings) {
  for (std::size_t c = 0; c < models.size(); ++c) {
    ChainRecord& chain = contents.chains[c];
    chain.model = models[c];
    if (models[c] == ChainModel::kCascade || recipe.torsion) continue;
    for (std::uint32_t i = 0; i < chain.bone_count; ++i) contents.dynamics[chain.first_bone + i].torsion = kShortestArc;
  }
  const bool any_passive = std::ranges::find(models, ChainModel::kPassive) != models.end();
  if (any_passive && recipe.torsion && *recipe.torsion < double(kShortestArc)) {
    findings.warn("C136",
                  "\"dynamics.torsion\": the passive model has no twist; for one say \"dynamics.model\": \"cascade\"");
  }
}

}  // namespace

void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings) {
  const lab::OpenedAsset opened(contents);
  if (!opened.asset().is_open()) return;
  const lab::Rig rig = lab::rig_of(opened.asset());
  const std::vector<bool> of_rig(takes.begin() + rig.rigid_count, takes.end());
  const std::size_t stiffened = lean_against_weight(rig, std::span(contents.bones).subspan(rig.rigid_count), of_rig,
                                                    std::span(contents.dynamics).subspan(rig.rigid_count));
  if (stiffened > 0) {
    findings.note(fmt::format("{} bones were made stiffer, so that they carry the shape that was modelled", stiffened));
  }
}

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

void settle_model(const RigRecipe& recipe, const SaidMotion& said, std::span<const ChainModel> models,
                  AssetContents& contents, Findings& findings) {
  std::vector<bool> keeps_shape;
  for (const MotionSource source : said.sources) {
    keeps_shape.push_back(source == MotionSource::kPreset || source == MotionSource::kCurve);
  }
  set_models(recipe, models, contents, findings);
  bake_natural_dynamics(said, contents, findings);
  if (!recipe.sags) keep_rest_shape(keeps_shape, contents, findings);
}

}  // namespace coif::cook
