#include "cook/select/hair_candidates.h"

#include "cook/recipe/decision.h"
#include "cook/select/hair_evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace coif::cook {

using importer::SourceMesh, importer::SourceModel;

const std::array<const char*, kFeatures> kFeatureNames{
    "called_hair", "called_other", "hair_bones", "eye_bones", "transparent", "on_head",     "crown",       "face",
    "middle",      "unlike_face",  "like_face",  "high",      "large",       "only_pieces", "beside_moved"};

namespace {

// A logistic regression on labelled files; tests/corpus/fit_candidates.py prints this table and how well it does on
// makers that it was not fitted to.
struct Weights {
  double bias = 0;
  std::array<double, kFeatures> weights{};
};

constexpr Weights kSeesHead{
    -2.69, {2.35, -0.94, 2.23, -0.33, 0.86, 0.80, 2.67, -2.36, -2.54, 0.04, 0.10, 0.01, 1.36, -1.94, 2.11}};
// Where no head is found only names speak; by hand.
constexpr Weights kSeesNone{0.0, {4.0, -4.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};

}  // namespace

double probability_of_hair(const std::array<double, kFeatures>& features, bool sees_head) {
  const Weights& table = sees_head ? kSeesHead : kSeesNone;
  double sum = table.bias;
  for (std::size_t f = 0; f < kFeatures; ++f) sum += table.weights[f] * features[f];
  return probability_of_odds(sum);
}

std::string name_of(const SourceModel& source, const HairCandidate& candidate) {
  const SourceMesh& mesh = source.meshes[candidate.mesh];
  return fmt::format("{}mesh '{}' (material '{}')",
                     candidate.is_whole_mesh ? "" : fmt::format("{} triangles of ", candidate.triangles), mesh.name,
                     importer::material_name(source, mesh));
}

std::string reason_for(const SourceModel& source, const HairCandidate& candidate) {
  std::vector<std::string> reasons;
  const auto share = [&](Feature feature) { return 100 * candidate.at(feature); };
  const HairNames names = names_of(source, source.meshes[candidate.mesh]);
  if (!names.why_hair.empty()) reasons.push_back(names.why_hair);
  if (names.say_otherwise) reasons.emplace_back("its name says something else");
  if (candidate.at(Feature::kHairBones) > 0) reasons.emplace_back("hair bones move it");
  if (candidate.at(Feature::kEyeBones) > kMovedByEyes) reasons.emplace_back("it moves with the eyes");
  if (candidate.at(Feature::kTransparent) > 0) reasons.emplace_back("it is transparent");
  if (candidate.at(Feature::kLarge) > 0) {
    reasons.push_back(fmt::format("it covers {:.0f} % of the crown and {:.0f} % of the face", share(Feature::kCrown),
                                  share(Feature::kFace)));
  } else {
    reasons.emplace_back("without a head bone its place says nothing");
  }
  if (candidate.at(Feature::kLikeFace) > 0) reasons.emplace_back("it has the colour of the face");
  if (candidate.at(Feature::kUnlikeFace) > 0.3) reasons.emplace_back("its colour is not that of the face");
  return fmt::format("{}", fmt::join(reasons, "; "));
}

double HairCandidate::share_of(const HairChoice& choice) const {
  std::size_t both = 0;
  for (std::size_t t = 0; t < taken.size(); ++t) both += taken[t] && choice.takes(mesh, t) ? 1 : 0;
  return triangles > 0 ? double(both) / double(triangles) : 0;
}

}  // namespace coif::cook
