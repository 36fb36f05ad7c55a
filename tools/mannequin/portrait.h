#pragma once

#include "mannequin/surface_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::mannequin {

/// How finely the portrait is made.
struct PortraitDetail {
  double spacing = 1;          ///< Of vertices, in the sample's.
  std::uint32_t texels = 768;  ///< Of the skin's image, across.
  bool has_shoulders = true;   ///< Without them head and neck alone, for hair that would hang into them.
};

struct PortraitMaterial {
  double red = 1, green = 1, blue = 1;  ///< Linear base colour.
  double roughness = 0.6;
};

/// What has one material.
struct PortraitPart {
  std::string name;
  SurfaceMesh mesh;  ///< Without weights; portrait_head.h has its measures.
  PortraitMaterial material;
  std::optional<PaintedImage> image;  ///< Of the material.
};

/// A head with a face to show hair on: skin, eyes, lashes, and a shirt where there are shoulders.
[[nodiscard]] std::vector<PortraitPart> make_portrait_parts(const PortraitDetail& detail = {});

}  // namespace coif::mannequin
