#include "cook/recipe/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace coif {

std::string LeftOut::text() const {
  std::vector<std::string> savings;
  if (bytes > 0) savings.push_back(fmt::format("{} bytes", bytes));
  if (bytes_per_head > 0) savings.push_back(fmt::format("{} bytes a head", bytes_per_head));
  if (ns_per_frame > 0) savings.push_back(fmt::format("{:.0f} ns a frame", ns_per_frame));
  return fmt::format("{}: {}{}", what, why, savings.empty() ? "" : fmt::format(" ({})", fmt::join(savings, ", ")));
}

}  // namespace coif
