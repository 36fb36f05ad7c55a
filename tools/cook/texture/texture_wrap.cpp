#include "cook/texture/base_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif::cook {
namespace {

/// In repeats beyond 0..1: an atlas's tile has room for this much around its image.
constexpr float kFarthestClamped = 0.45f;
constexpr float kSameBorder = 1.0e-4f;  ///< In repeats: a coordinate that is nearer than this lies on a border.

/// Distance of coordinates below 0 after they were folded between two borders by a triangle wave: 1.25 becomes 0.75.
float folded(float u) {
  const float two = u - 2 * std::floor(u / 2);
  return two <= 1 ? two : 2 - two;
}

/// The vertices of one look's triangles, once each, and whether any triangle crosses a border along an axis.
struct LookCoordinates {
  std::vector<std::uint32_t> vertices;
  std::array<bool, 2> crosses_integer{}, crosses_image{}, leaves_image{};
};

LookCoordinates coordinates_of(const SurfaceLooks& looks, std::uint32_t look, const HairMesh& hair) {
  LookCoordinates out;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    if (looks.of_triangle[t] != look) continue;
    const std::uint32_t* const v = &hair.triangles[3 * t];
    out.vertices.insert(out.vertices.end(), v, v + 3);
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] = std::minmax({hair.uvs[v[0]][axis], hair.uvs[v[1]][axis], hair.uvs[v[2]][axis]});
      const auto crosses = [&](float border) { return low < border - kSameBorder && high > border + kSameBorder; };
      auto at = std::size_t(axis);
      out.crosses_integer[at] = out.crosses_integer[at] || crosses(std::floor(high - kSameBorder));
      out.crosses_image[at] = out.crosses_image[at] || crosses(0) || crosses(1);
      out.leaves_image[at] = out.leaves_image[at] || low < -kSameBorder || high > 1 + kSameBorder;
    }
  }
  std::ranges::sort(out.vertices);
  out.vertices.erase(std::ranges::unique(out.vertices).begin(), out.vertices.end());
  return out;
}

/// The image with its mirror image beside it (axis 0) or below it (axis 1).
Image with_mirror_image(const Image& image, int axis) {
  Image both{image.width * (axis == 0 ? 2 : 1), image.height * (axis == 1 ? 2 : 1), image.channels, {}};
  both.texels.resize(both.texel_count() * both.channels);
  const auto from = [](std::uint32_t at, std::uint32_t size) { return at < size ? at : 2 * size - 1 - at; };
  for (std::uint32_t y = 0; y < both.height; ++y) {
    for (std::uint32_t x = 0; x < both.width; ++x) {
      const std::size_t source = std::size_t(from(y, image.height)) * image.width + from(x, image.width);
      std::copy_n(&image.texels[source * image.channels], image.channels,
                  &both.texels[(std::size_t(y) * both.width + x) * both.channels]);
    }
  }
  return both;
}

bool can_be_doubled(const SurfaceLook& look, int axis) {
  for (const Image* image : {look.image, look.normals, look.strands}) {
    if (image == nullptr) continue;
    const bool fits =
        (axis == 0 ? image->width : image->height) <= kMaxImageSide / 2 && image->texel_count() <= kMaxImageTexels / 2;
    if (!fits) return false;
  }
  return true;
}

void mirror(SurfaceLooks& looks, SurfaceLook& look, const LookCoordinates& at, int axis, HairMesh& hair,
            Findings& findings) {
  if (!at.crosses_integer[std::size_t(axis)] || !can_be_doubled(look, axis)) {
    if (at.crosses_integer[std::size_t(axis)]) {
      findings.warn(
          "C153",
          fmt::format(
              "material '{}': its texture is mirrored and too large to be stored with its mirror image; strips that "
              "cross its border show it wrongly; reduce it",
              look.name));
    }
    for (const std::uint32_t v : at.vertices) hair.uvs[v][axis] = folded(hair.uvs[v][axis]);
    return;
  }
  for (const Image** image : {&look.image, &look.normals, &look.strands}) {
    if (*image != nullptr) *image = &looks.made.emplace_back(with_mirror_image(**image, axis));
  }
  for (const std::uint32_t v : at.vertices) hair.uvs[v][axis] *= 0.5f;
  findings.note(fmt::format("material '{}': its texture is mirrored along {}, and stored with its mirror image",
                            look.name, axis == 0 ? 'U' : 'V'));
}

/// Half a texel inside the image, so that filtering does not reach over to its other side.
float texel_margin(const SurfaceLook& look, int axis) {
  if (look.image == nullptr) return 0;
  return 0.5f / float(axis == 0 ? look.image->width : look.image->height);
}

/// False where the look needs a tile of its own.
bool clamp(const SurfaceLook& look, const LookCoordinates& at, int axis, HairMesh& hair, Findings& findings) {
  const bool is_crossed = at.crosses_image[std::size_t(axis)];
  const float margin = is_crossed ? -kFarthestClamped : texel_margin(look, axis);
  std::size_t moved = 0;
  for (const std::uint32_t v : at.vertices) {
    float& u = hair.uvs[v][axis];
    const float inside = std::clamp(u, margin, 1 - margin);
    moved += inside != u ? 1 : 0;
    u = inside;
  }
  if (is_crossed && moved > 0) {
    findings.warn(
        "C153",
        fmt::format(
            "material '{}': its texture is clamped, and {} vertices lie more than {} of it outside along {}: they "
            "are moved nearer, which shifts the texture there; cut the strips where the texture ends",
            look.name, moved, kFarthestClamped, axis == 0 ? 'U' : 'V'));
  }
  return !is_crossed;
}

}  // namespace

void settle_wraps(SurfaceLooks& looks, HairMesh& hair, Findings& findings) {
  if (hair.uvs.empty()) return;
  for (std::uint32_t i = 0; i < looks.looks.size(); ++i) {
    SurfaceLook& look = looks.looks[i];
    if (look.wrap[0] == importer::TextureWrap::kRepeat && look.wrap[1] == importer::TextureWrap::kRepeat) continue;
    const LookCoordinates at = coordinates_of(looks, i, hair);
    for (int axis = 0; axis < 2; ++axis) {
      importer::TextureWrap& wrap = look.wrap[axis];
      const bool is_clamp = wrap == importer::TextureWrap::kClamp;
      if (wrap == importer::TextureWrap::kMirror && at.leaves_image[std::size_t(axis)])
        mirror(looks, look, at, axis, hair, findings);
      if (!is_clamp || look.image == nullptr || clamp(look, at, axis, hair, findings))
        wrap = importer::TextureWrap::kRepeat;
    }
  }
}

}  // namespace coif::cook
