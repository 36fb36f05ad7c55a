#pragma once

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {

/// Numbers by name, each about 0..1, from which a probability follows.
using Features = std::vector<std::pair<std::string, double>>;

/// 0..1, from the logarithm of the odds.
[[nodiscard]] double probability_of_odds(double log_odds);

/// "96 %", but never "100 %": what nobody said is not certain.
[[nodiscard]] std::string certainty_text(double probability);

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

/// What a cook decided where neither the file nor the recipe says it, and how sure it is of that.
struct Decision {
  std::string what;        ///< "hair", "head", "facing", "roots", "chains", "size" or "up".
  std::string chosen;      ///< "mesh 'Face'", "+Z".
  std::string reason;      ///< What speaks for it and against it.
  double probability = 1;  ///< That a person would say the same, 0..1: calibrated on labelled files.
  std::string key;         ///< The line of a recipe that decides it: "\"head.center\" and \"head.radii\"".
  Features features;       ///< From which the probability was computed; for fitting its weights.

  /// "head: (0.000, 1.644, 0.043) m, 96 % sure: a joint and 2296 vertices"
  [[nodiscard]] std::string text() const;
  /// So much in doubt that the cook should stop: without the right hair or head nothing else is right. What else is in
  /// doubt can be looked at in the asset.
  [[nodiscard]] bool asks() const;
  /// What a warning or an error says where it is in doubt; it ends with the recipe's line.
  [[nodiscard]] std::string doubt() const;
};

/// Below the first, a decision is warned of; below the second, the cook may stop and ask (bad input).
inline constexpr double kSureEnough = 0.8, kAskBelow = 0.25;

/// The code of the warning of a decision in doubt: S202 for "hair", S227 for "head", S228 "facing", S229 "roots",
/// S230 "chains", S208 "size", S210 "up".
[[nodiscard]] const char* code_of_doubt(const Decision& decision);

// {"what", "chosen", "reason", "probability", "key", "features": {name: value}}

template <class Json>
void to_json(Json& out, const Decision& decision) {
  out = {{"what", decision.what},     {"chosen", decision.chosen},
         {"reason", decision.reason}, {"probability", decision.probability},
         {"key", decision.key},       {"features", Json::object()}};
  for (const auto& [name, value] : decision.features) out["features"][name] = value;
}

/// Throws nlohmann::json::exception where `in` is no decision.
void from_json(const nlohmann::json& in, Decision& decision);

}  // namespace coif::cook
