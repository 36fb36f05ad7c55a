#include "report/shadow/shadow_points.h"

#include <cmath>

namespace coif {

std::vector<ShadowPoint> shadow_points(const FragmentView& seen) {
  std::vector<ShadowPoint> points;
  for (std::size_t line = 0; line < seen.line_count(); ++line) {
    const float solid = seen.solid_depth(line);
    float passes = 1;
    for (const Fragment& fragment : seen.line(line)) {
      if (fragment.depth > solid) break;
      points.push_back({seen.place(line, fragment.depth), passes, fragment.alpha, false});
      passes *= 1 - fragment.alpha;
    }
    if (std::isfinite(solid)) points.push_back({seen.place(line, solid), passes, 1, true});
  }
  return points;
}

}  // namespace coif
