#pragma once

#include "cook/select/hair_mesh.h"
#include "cook/texture/base_color.h"
#include "cook/texture/image.h"

#include <array>
#include <string>

namespace coif::cook {

struct DrawnRecipe;

/// The texels of an image that the hair shows: one channel, 255 where a triangle touches the texel, else 0. Coordinates
/// outside 0..1 wrap. Measurements of a hair texture use only these texels, since an atlas may hold a face too.
[[nodiscard]] Image used_texels(const HairMesh& hair, std::uint32_t width, std::uint32_t height);

/// Number of texels of each alpha, in 256 steps.
using AlphaHistogram = std::array<double, 256>;

/// The histogram of the texels with a weight in `used` (one channel, the image's size), each multiplied by `factor`,
/// 0..1.
[[nodiscard]] AlphaHistogram alpha_histogram(const Image& image, const Image& used, double factor);

/// Share of opaque texels among the drawn ones below which hair has no opaque core.
inline constexpr double kFewOpaque = 0.1;

struct OpaqueThreshold {
  double value = 0;         ///< 0: everything is opaque.
  double opaque_share = 1;  ///< Share among the drawn texels.
  std::string reason;       ///< Part of a sentence.
};

/// Chooses the alpha from which on texels are drawn as opaque. Texels of the opaque pass are sorted exactly by depth,
/// blended ones only per strip; but a soft texel drawn as opaque gets a hard edge. The opaque cores of strands are the
/// histogram's uppermost mode, so the threshold is the foot of that mode: as low as possible without soft texels. If so
/// few texels are opaque that blending would decide the picture, it goes lower, until a quarter is opaque, but never
/// below 0.5. It stays below 0.95, since filtering reduces even the alpha of cores. Texels under `discard` are never
/// drawn and do not count.
[[nodiscard]] OpaqueThreshold choose_opaque_threshold(const AlphaHistogram& histogram, double discard);

/// The alphas from which on the hair is drawn, and from which on as opaque: texture times factors, as the renderer
/// compares.
struct Transparency {
  double opaque_threshold = 0;   ///< 0: all of it is opaque, and one pass draws it.
  double discard_threshold = 0;  ///< Equal to the other: nothing is blended, and one pass draws it.
  bool ignores_alpha = false;    ///< The file says opaque; the image's alpha has another meaning.
};

/// The recipe's thresholds, else the file's: an opaque material ignores alpha, a masked one uses its cutoff for both
/// thresholds. Else they are chosen from the alpha of the texels in `used` (see choose_opaque_threshold()). `image` may
/// be null: one alpha everywhere. Warns of hair without an opaque core, which looks bad in every draw order.
[[nodiscard]] Transparency choose_transparency(const BaseColor& color, const Image* image, const Image& used,
                                               const DrawnRecipe& recipe, Findings& findings);

}  // namespace coif::cook
