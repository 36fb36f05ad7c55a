#pragma once
// What goes to the standard output.

#include <string_view>

namespace coif {

void print_result(std::string_view text);

}  // namespace coif
