#include "cook/select/hair_candidates.h"

#include <cmath>

namespace coif::cook {

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
    -2.67, {2.42, -0.95, 2.23, -0.34, 0.86, 0.81, 2.68, -2.40, -2.58, 0.02, 0.18, -0.00, 1.34, -1.95, 2.13}};
constexpr Weights kSeesNone{0.0, {4.0, -4.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};

}  // namespace

double probability_of_hair(const std::array<double, kFeatures>& features, bool sees_head) {
  const Weights& table = sees_head ? kSeesHead : kSeesNone;
  double sum = table.bias;
  for (std::size_t f = 0; f < kFeatures; ++f) sum += table.weights[f] * features[f];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace coif::cook
