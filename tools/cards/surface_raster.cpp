#include "cards/surface_raster.h"

namespace coif::cards {

std::vector<std::vector<std::uint32_t>> triangles_by_band(const CardSurface& surface, const PictureFrame& frame,
                                                          std::uint32_t rows) {
  std::vector<std::vector<std::uint32_t>> bands((frame.size + rows - 1) / rows);
  for (std::uint32_t t = 0; 3 * std::size_t(t) < surface.triangles.size(); ++t) {
    const SeenTriangle seen(surface, frame, t);
    if (!seen.is_seen()) continue;
    const auto box = seen.box_within({frame.size, 0, frame.size});
    if (box.left > box.right) continue;
    for (int y = box.top; y <= box.bottom;) {
      const auto band = std::uint32_t(y) / rows;
      bands[band].push_back(t);
      y = int((band + 1) * rows);
    }
  }
  return bands;
}

}  // namespace coif::cards
