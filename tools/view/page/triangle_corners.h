#pragma once

#include "view/page/hair_views.h"

#include <coif/asset.h>
#include <coif/drawing.h>
#include <coif/skinning.h>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::view {

/// One corner of a triangle in the GPU's form.
struct TriangleCorner {
  Vec3 position;  ///< Head space, metres.
  float uv[2];
  std::uint8_t color[4];  ///< sRGB, the whole triangle's; the last is not used.
};

/// Triangles of an asset, each with its own corners, so that each can have a colour: WebGL 2 does not give a shader the
/// triangle's number. Allocates its memory once.
class TriangleCorners {
 public:
  /// The asset must outlive this object and have a mesh.
  explicit TriangleCorners(const Asset& asset);

  /// The corners of the head's level, in the order in which HairRenderer draws it: `order` is VisibleCrowd::Group's.
  /// Valid until the next call; empty where the palette is not the asset's.
  [[nodiscard]] std::span<const TriangleCorner> of(HairView view, const HairInstance& head, std::uint32_t order);

  /// The largest number that of() returns.
  [[nodiscard]] std::size_t most() const { return corners_.size(); }
  [[nodiscard]] const DrawnHair& hair() const { return hair_; }

 private:
  [[nodiscard]] ScreenColor color_of(HairView view, std::uint32_t triangle, double share) const;

  const Asset& asset_;
  DrawnHair hair_;
  std::vector<ScreenColor> patch_colors_;  ///< One per triangle, in stored order.
  std::vector<SkinnedVertex> skinned_;
  std::vector<TriangleCorner> corners_;
};

}  // namespace coif::view
