#include "cook/recipe/decision.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace coif::cook {

double probability_of_odds(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

std::string certainty_text(double probability) { return fmt::format("{:.0f} %", 100 * std::min(probability, 0.99)); }

std::string Decision::text() const {
  return fmt::format("{}: {}, {} sure: {}", what, chosen, certainty_text(probability), reason);
}

std::string Decision::doubt() const {
  const char* then =
      what == "hair" ? "confirms it; 'coif cook --list candidates' shows what else it may be" : "says it";
  return fmt::format("in doubt: {}: {}, {} sure ({}); in the recipe, {} {}", what, chosen, certainty_text(probability),
                     reason, key, then);
}

bool Decision::asks() const { return probability < kAskBelow && (what == "hair" || what == "head"); }

const char* code_of_doubt(const Decision& decision) {
  constexpr std::array<std::pair<const char*, const char*>, 6> kCodes{
      {{"head", "S227"}, {"facing", "S228"}, {"roots", "S229"}, {"chains", "S230"}, {"size", "S208"}, {"up", "S210"}}};
  const auto found = std::ranges::find(kCodes, decision.what, [](const auto& code) { return code.first; });
  return found == kCodes.end() ? "S202" : found->second;
}

double Logistic::probability(const Features& features) const {
  double odds = bias;
  for (const auto& [name, value] : features) {
    const auto found = std::ranges::find(weights, name, [](const FeatureWeight& w) { return std::string(w.name); });
    if (found != weights.end()) odds += found->weight * value;
  }
  return probability_of_odds(odds);
}

void from_json(const nlohmann::json& in, Decision& decision) {
  in.at("what").get_to(decision.what);
  in.at("chosen").get_to(decision.chosen);
  in.at("reason").get_to(decision.reason);
  in.at("probability").get_to(decision.probability);
  in.at("key").get_to(decision.key);
  for (const auto& [name, value] : in.at("features").items()) decision.features.emplace_back(name, value);
}

}  // namespace coif::cook
