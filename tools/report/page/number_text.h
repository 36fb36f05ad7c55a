#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// Two digits or three, more where they stand before the point: "0.0123", "4.57", "13240", "2.1e+09". "<0.0001" for
/// what is closer to 0 than that, which in a percentage is rounding noise; "-" for what is not finite.
[[nodiscard]] std::string number_text(double number);

/// number_text() with " %" behind it, or "-".
[[nodiscard]] std::string percent_text(double percent);

/// Null for what is not finite.
[[nodiscard]] nlohmann::ordered_json number_json(double number);

}  // namespace coif
