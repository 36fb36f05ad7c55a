#pragma once

#include "visibility/fragment_view.h"
#include "visibility/hair_light.h"
#include "visibility/order_error.h"

#include <coif/math.h>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::visibility {

/// A fragment with its colour in a picture.
struct SeenLayer {
  Eigen::Array3f color;  ///< Linear, lit.
  float alpha = 0;
  std::uint32_t triangle : 31 = 0;
  std::uint32_t is_front : 1 = 0;
};

/// Pixels of one view in which hair is seen, each with its layers, nearest first: all that any way to draw them may
/// show.
struct SeenLines {
  [[nodiscard]] std::size_t size() const { return behind.size(); }
  [[nodiscard]] std::span<const SeenLayer> line(std::size_t index) const {
    return std::span(layers).subspan(begin[index], begin[index + 1] - begin[index]);
  }

  std::vector<std::uint32_t> begin = {0};  ///< Per line and one more: its first layer.
  std::vector<SeenLayer> layers;
  std::vector<Eigen::Array3f> behind;  ///< Per line: linear, the head or the backdrop.
};

/// Hair that pictures of are judged.
struct SeenHair {
  /// The asset must have a mesh; keeps nothing of it.
  explicit SeenHair(const Asset& asset) : surface(asset), light(asset) {}
  HairSurface surface;
  HairLight light;
};

/// An intersection of a line with the hair, with everything that a picture may show except the alpha, which depends on
/// the texture's mips.
struct SeenHit {
  Eigen::Array3f color;  ///< Linear, lit.
  Eigen::Vector2f uv;
  MipChoice mip;
  std::uint32_t triangle : 31 = 0;
  std::uint32_t is_front : 1 = 0;
};

/// Pixels of one view in which hair may be seen, each with its hits, nearest first: the slow part, independent of the
/// mips' alpha and the threshold.
struct SeenHits {
  std::vector<std::uint32_t> begin = {0};  ///< Per line and one more: its first hit.
  std::vector<SeenHit> hits;
  std::vector<Eigen::Array3f> behind;  ///< As in SeenLines.
};

/// Looks at the hair at `positions` from `towards_eye`, along lines this many metres apart, with the mips of a picture
/// that the hair fills with 160 pixels, as in `coif report order`. Hits behind so many layers that they are hidden with
/// any mips are left out.
[[nodiscard]] SeenHits see_hits(const SeenHair& hair, std::span<const Eigen::Vector3f> positions,
                                const Eigen::Vector3f& towards_eye, float spacing);

/// The hits with this alpha. `opaque_threshold`: the smallest with which lines will be drawn; layers behind one that
/// hides everything in that picture and in the exact one are left out.
[[nodiscard]] SeenLines lines_of(const SeenHits& hits, const AlphaTexture& alpha, float opaque_threshold);

/// Both steps at once, with the hair's own alpha.
[[nodiscard]] SeenLines see_lines(const SeenHair& hair, std::span<const Eigen::Vector3f> positions,
                                  const Eigen::Vector3f& towards_eye, float spacing, float opaque_threshold);

/// Spread of colours that a picture in the tools' light does not show but another light would, RMS, of 1.
inline constexpr double kOtherLightSpread = 0.01;

/// Squared difference (of encoded channels, 0..1, mean of the three), summed over lines, between the exact picture, in
/// which every pixel is sorted by depth and every alpha is its own, and the one drawn by the rule. `rank`: of each
/// triangle, lower ones drawn first; empty: all layers sorted by depth, the best that any order could do.
[[nodiscard]] double picture_error(const SeenLines& lines, std::span<const std::uint32_t> rank, const DrawRule& rule);

/// The cost of drawing a view's lines by the rule, in blended layers per line. Solid layers, and layers behind a solid
/// one, which the depth test rejects, do not count.
[[nodiscard]] double blended_layers(const SeenLines& lines, const DrawRule& rule);

}  // namespace coif::visibility
