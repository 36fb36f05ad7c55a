#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// Indented JSON with a final newline. Names from artists' files need not be UTF-8; offending bytes are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace coif
