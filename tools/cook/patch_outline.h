#pragma once

#include "cook/patch_surface.h"

namespace coif {

/// Where a patch ends, and which of its points carry its shape.
struct PatchOutline {
  struct Edge {
    std::uint32_t a, b;      ///< Points, in the triangle's direction.
    std::uint32_t triangle;  ///< The only one at this edge.
  };
  std::vector<Edge> edges;
  std::vector<bool> on_border;  ///< Per point.
  /// Per point: corners of the outline (so the points and the ends of strips stay), and where more than two triangles or
  /// several borders meet.
  std::vector<bool> fixed;
};

[[nodiscard]] PatchOutline find_outline(const PatchSurface& surface);

}  // namespace coif
