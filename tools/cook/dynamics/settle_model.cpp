#include "cook/dynamics/settle_model.h"

#include "cook/dynamics/natural_dynamics.h"
#include "cook/dynamics/rest_shape.h"
#include "cook/recipe/rig_recipe.h"

#include <algorithm>
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
