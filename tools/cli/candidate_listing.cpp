#include "cli/asset_summary.h"

#include "base/json.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cli {
namespace {

using cook::HairCandidate, cook::HairCandidates;
using importer::SourceMesh, importer::SourceModel;

constexpr std::size_t kMiddles = 400;  ///< Triangles of a part whose middles are in the JSON.

/// Middles of triangles spread over a part, metres.
nlohmann::ordered_json middles_of(const SourceModel& model, const HairCandidate& part) {
  auto list = nlohmann::ordered_json::array();
  const SourceMesh& mesh = model.meshes[part.mesh];
  const std::size_t step = std::max<std::size_t>(1, part.triangles / kMiddles);
  std::size_t number = 0;
  for (std::size_t t = 0; t < part.taken.size(); ++t) {
    if (!part.taken[t] || number++ % step != 0) continue;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) sum += mesh.positions[mesh.triangles[3 * t + k]];
    list.push_back({sum.x() / 3, sum.y() / 3, sum.z() / 3});
  }
  return list;
}

}  // namespace

std::string candidates_text(const SourceModel& model, const HairCandidates& candidates) {
  std::string text = fmt::format("{}: {} that may be hair, likeliest first{}\n", model.path,
                                 counted(candidates.list.size(), "part", "parts"),
                                 candidates.sees_head ? "" : "; no head was found, so that only names speak");
  for (const HairCandidate& part : candidates.list) {
    text += fmt::format("{:>6}  {}{}\n        {}\n        {}\n", cook::certainty_text(part.probability),
                        printable_text(cook::name_of(model, part)),
                        part.is_whole_mesh ? ", " + counted(part.triangles, "triangle", "triangles") : "",
                        printable_text(cook::reason_for(model, part)),
                        printable_text(cook::recipe_line(model, part, candidates)));
  }
  return text;
}

std::string candidates_json(const SourceModel& model, const HairCandidates& candidates) {
  auto list = nlohmann::ordered_json::array();
  for (const HairCandidate& part : candidates.list) {
    nlohmann::ordered_json features;
    for (std::size_t f = 0; f < cook::kFeatures; ++f) features[cook::kFeatureNames[f]] = part.features[f];
    const SourceMesh& mesh = model.meshes[part.mesh];
    list.push_back({{"mesh", mesh.name},
                    {"material", importer::material_name(model, mesh)},
                    {"node", model.nodes[mesh.node].name},
                    {"whole", part.is_whole_mesh},
                    {"triangles", part.triangles},
                    {"probability", part.probability},
                    {"reason", cook::reason_for(model, part)},
                    {"recipe", cook::recipe_line(model, part, candidates)},
                    {"features", std::move(features)},
                    {"middles", middles_of(model, part)}});
  }
  return json_text({{"path", model.path}, {"sees_head", candidates.sees_head}, {"candidates", std::move(list)}});
}

}  // namespace coif::cli
