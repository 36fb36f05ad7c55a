#include "cli/results.h"

#include <fmt/format.h>

#include <cstdio>

namespace coif {

void print_result(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace coif
