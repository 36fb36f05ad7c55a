#include "cli/results.h"

#include <cstdio>

namespace coif {

void print_result(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

}  // namespace coif
