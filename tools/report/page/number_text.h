#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// Two digits or three, more where they stand before the point: "0.0123", "4.57", "13240", "2.1e+09". "-" for what is
/// not finite.
[[nodiscard]] std::string number_text(double number);

/// number_text() with " %" behind it, or "-".
[[nodiscard]] std::string percent_text(double percent);

/// Null for what is not finite.
[[nodiscard]] nlohmann::ordered_json number_json(double number);

}  // namespace coif
