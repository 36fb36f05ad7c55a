#pragma once
// What goes to the standard output.

#include <cstddef>
#include <string>
#include <string_view>

namespace coif {

void print_result(std::string_view text);

/// "1 patch", "2 patches".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace coif
