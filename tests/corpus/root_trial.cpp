// coif_root_trial WEIGHTS.json STYLES [FILE...]: how strands run with each set of weights of the table in
// strand_evidence.h. WEIGHTS.json is a list of objects, {"height": 0.5, ...}; what is left out keeps its value. Prints
// one JSON line for each style of the first STYLES ones, {"style", "right": [strips, for each set], "all"}, and for
// each file {"file", "head": [center, radii], "rows": [for each set: [area, x, y, z, direction x, y, z, place] of each
// triangle]}, both with "doubts": [RootDoubts for each set]. fit_roots.py runs it.

#include "cook/built_models.h"
#include "cook/hair_styles.h"
#include "cook/recipe/recipe.h"
#include "cook/select/select_hair.h"
#include "cook/strands/patches.h"
#include "cook/strands/strand_direction.h"
#include "cook/texture/strand_lines.h"
#include "import/import.h"
#include "platform/job.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace coif::cook {
namespace {

using nlohmann::json;

RootWeights weights_from(const json& said) {
  RootWeights w;
  const std::pair<const char*, float*> names[] = {{"distance", &w.distance},   {"bones", &w.bones},
                                                  {"height", &w.height},       {"shell_height", &w.shell_height},
                                                  {"taper", &w.taper},         {"tied", &w.tied},
                                                  {"fade", &w.fade},           {"neighbour", &w.neighbour},
                                                  {"mirror", &w.mirror},       {"island", &w.island},
                                                  {"common", &w.common},       {"habit", &w.habit},
                                                  {"longer", &w.longer},       {"lines", &w.lines},
                                                  {"ends", &w.ends},           {"common_axis", &w.common_axis},
                                                  {"unwrapped", &w.unwrapped}, {"mirrored_axis", &w.mirrored_axis}};
  for (const auto& [name, value] : names) *value = said.value(name, *value);
  return w;
}

/// As the cook finds them, without the bones of the hair.
HairStrips find(HairMesh mesh, const BaseColor& color, const FittedHead& head, std::size_t nodes,
                const RootWeights& weights) {
  HairStrips hair;
  hair.mesh = std::move(mesh);
  hair.welded = weld_places(hair.mesh.positions, 0);
  const ExtractedPatches extracted = find_patches(hair, Connectivity::kAuto, unheard());
  StrandSettings settings;
  settings.weights = weights;
  settings.trust_texture = extracted.chosen != Connectivity::kPosition;
  settings.depth_of_node.assign(nodes, 0.0f);
  if (settings.trust_texture) (void)split_folds(hair, unheard());
  hair.complete_normals();
  const auto find_strands = [&] {
    settings.seen = find_strand_lines(hair, color, 2);
    hair.strands = find_strand_direction(hair, head, settings, unheard());
  };
  find_strands();
  const std::vector<std::string> roots(hair.patches.count, "auto");
  if (split_partings(hair, head, roots, unheard()) > 0) find_strands();
  return hair;
}

json doubts_of(const HairStrips& hair) {
  const RootDoubts& d = hair.strands.doubts;
  return {d.unsure, d.rises, d.rises_above, d.against_neighbour, d.against_mirror, d.against_ends};
}

void try_style(std::uint32_t seed, const std::vector<RootWeights>& sets) {
  const StyledHair style = make_style(seed);
  const HairMesh mesh = hair_from(style.source.meshes.front());
  importer::SourceModel source = style.source;
  source.nodes.resize(1);
  const FittedHead head = fit_head(source, mesh, {}, default_recipe(), unheard());
  BaseColor color;
  color.image = style.image;
  json line = {{"style", style.family}, {"right", json::array()}};
  for (const RootWeights& weights : sets) {
    const HairStrips hair = find(mesh, color, head, 1, weights);
    line["doubts"].push_back(doubts_of(hair));
    std::size_t right = 0, all = 0;
    for (const PatchView& view : hair.views()) {
      double sum = 0, area = 0;
      for (const std::size_t t : view.triangles) {
        Eigen::Vector3f way = Eigen::Vector3f::Zero(), tangent = way;
        for (std::size_t k = 0; k < 3; ++k) {
          way += style.growth[hair.mesh.triangles[t + k]];
          tangent += hair.strands.tangent[hair.mesh.triangles[t + k]];
        }
        const double weight = double(doubled_area(hair.mesh, t));
        sum += weight * double(tangent.stableNormalized().dot(way.stableNormalized()));
        area += weight;
      }
      if (!(area > 0)) continue;
      ++all;
      right += sum > 0.5 * area ? 1 : 0;
    }
    line["right"].push_back(right);
    line["all"] = all;
  }
  fmt::print("{}\n", line.dump());
}

json rows_of(const HairStrips& hair) {
  json rows = json::array();
  for (std::size_t t = 0; t < hair.mesh.triangles.size(); t += 3) {
    Eigen::Vector3f middle = Eigen::Vector3f::Zero(), way = middle;
    float place = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = hair.mesh.triangles[t + k];
      middle += hair.mesh.positions[v] / 3;
      way += hair.strands.tangent[v] / 3;
      place += hair.strands.place[v] / 3;
    }
    rows.push_back(
        {0.5f * doubled_area(hair.mesh, t), middle.x(), middle.y(), middle.z(), way.x(), way.y(), way.z(), place});
  }
  return rows;
}

bool try_file(const char* path, const std::vector<RootWeights>& sets) {
  const auto source = importer::import_model(path);
  if (!source) return false;
  const Recipe recipe = default_recipe();
  auto mesh = select_hair(*source, recipe, unheard());
  if (!mesh) return false;
  const auto color = find_base_color(*source, *mesh, recipe, {}, unheard());
  const auto bone = find_head_bone(*source, *mesh, "");
  if (!color || !bone) return false;
  const FittedHead head = fit_head(*source, *mesh, *bone, recipe, unheard());
  json line = {{"file", path}, {"rows", json::array()}};
  line["head"] = {head.center.x(), head.center.y(), head.center.z(), head.radii.x(), head.radii.y(), head.radii.z()};
  for (const RootWeights& weights : sets) {
    const HairStrips hair = find(*mesh, *color, head, source->nodes.size(), weights);
    line["rows"].push_back(rows_of(hair));
    line["doubts"].push_back(doubts_of(hair));
  }
  fmt::print("{}\n", line.dump());
  return true;
}

}  // namespace
}  // namespace coif::cook

int main(int count, char** said) {
  coif::platform::run_named_job(count, said);
  if (count < 3) {
    fmt::print(stderr, "coif_root_trial WEIGHTS.json STYLES [FILE...]\n");
    return 1;
  }
  std::ifstream file(said[1]);
  std::vector<coif::cook::RootWeights> sets;
  for (const auto& of_set : nlohmann::json::parse(file)) sets.push_back(coif::cook::weights_from(of_set));
  const auto styles = std::uint32_t(std::strtoul(said[2], nullptr, 10));
  for (std::uint32_t seed = 0; seed < styles; ++seed) coif::cook::try_style(seed, sets);
  for (int k = 3; k < count; ++k) {
    if (!coif::cook::try_file(said[k], sets)) fmt::print(stderr, "{}: not read\n", said[k]);
  }
  return 0;
}
