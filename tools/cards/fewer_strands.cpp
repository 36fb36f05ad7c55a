#include "cards/fewer_strands.h"

#include <algorithm>
#include <cstdint>

namespace coif {

Groom fewer_strands(const Groom& groom, float width, std::size_t points) {
  const std::size_t each =
      std::max<std::size_t>((groom.points.size() + points - 1) / std::max<std::size_t>(points, 1), 1);
  Groom fewer;
  fewer.root_first = groom.root_first;
  fewer.begin.push_back(0);
  for (std::size_t i = 0; i < groom.strand_count(); i += each) {
    for (std::uint32_t p = groom.begin[i]; p < groom.begin[i + 1]; ++p) {
      fewer.points.push_back(groom.points[p]);
      fewer.widths.push_back(float(each) * (groom.widths.empty() ? width : groom.widths[p]));
    }
    fewer.begin.push_back(std::uint32_t(fewer.points.size()));
  }
  fewer.groups.push_back({"", 0, std::uint32_t(fewer.strand_count())});
  return fewer;
}

}  // namespace coif
