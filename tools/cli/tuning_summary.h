#pragma once

#include <coif/asset.h>

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// How the asset wants to be simulated, errors in percent of the chain's length; null where it was not tuned. The keys are stable.
[[nodiscard]] nlohmann::ordered_json tuning_json(const Asset& asset);

/// One entry for each frame rate and number of sub-steps that was measured. The keys are stable.
[[nodiscard]] nlohmann::ordered_json quality_json(const Asset& asset);

/// Both as lines for people; empty where the asset has neither.
[[nodiscard]] std::string tuning_text(const Asset& asset);

}  // namespace coif
