#pragma once

#include "cook/recipe/decision.h"

#include <span>

namespace coif::cook {

/// A feature's weight in the logarithm of the odds.
struct FeatureWeight {
  const char* name;
  double weight;
};

/// A table of weights that tests/corpus/fit_decisions.py fitted.
struct Logistic {
  double bias;
  std::span<const FeatureWeight> weights;

  /// 0..1; features without a weight count for nothing.
  [[nodiscard]] double probability(const Features& features) const;
};

}  // namespace coif::cook
