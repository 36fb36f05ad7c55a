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
    -2.69, {2.35, -0.94, 2.23, -0.33, 0.86, 0.80, 2.67, -2.36, -2.54, 0.04, 0.10, 0.01, 1.36, -1.94, 2.11}};
// Where no head is found only names speak; by hand.
constexpr Weights kSeesNone{0.0, {4.0, -4.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};

}  // namespace

double probability_of_hair(const std::array<double, kFeatures>& features, bool sees_head) {
  const Weights& table = sees_head ? kSeesHead : kSeesNone;
  double sum = table.bias;
  for (std::size_t f = 0; f < kFeatures; ++f) sum += table.weights[f] * features[f];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace coif::cook
