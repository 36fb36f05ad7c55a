#pragma once
// What goes to the standard output.

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace coif {

/// Indented JSON with a final newline. Names from artists' files need not be UTF-8; offending bytes are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

void print_result(std::string_view text);

/// "1 patch", "2 patches".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace coif
