#pragma once

#include "cook/select/hair_mesh.h"
#include "cook/texture/base_color.h"
#include "cook/texture/image.h"

#include <array>
#include <string>

namespace coif::cook {

struct DrawnRecipe;

/// Which texels of an image the hair shows: one channel, 255 where a triangle touches the texel, else 0. Coordinates
/// outside 0..1 wrap. An atlas may hold a face too; what is measured of a hair texture is measured over these.
[[nodiscard]] Image used_texels(const HairMesh& hair, std::uint32_t width, std::uint32_t height);

/// How many texels have which alpha, in 256 steps.
using AlphaHistogram = std::array<double, 256>;

/// Of the texels with a weight in `used` (one channel, the image's size), each multiplied by `factor`, 0..1.
[[nodiscard]] AlphaHistogram alpha_histogram(const Image& image, const Image& used, double factor);

/// With a smaller share of opaque texels among the drawn ones hair counts as without an opaque core.
inline constexpr double kFewOpaque = 0.1;

struct OpaqueThreshold {
  double value = 0;         ///< 0: everything is opaque.
  double opaque_share = 1;  ///< Of the texels that are drawn at all.
  std::string reason;       ///< Part of a sentence.
};

/// From which alpha on texels are drawn as opaque. What the opaque pass draws is sorted exactly by depth, what is
/// blended is sorted per strip only; but a soft texel drawn as opaque gets a hard edge. The opaque cores of strands are
/// the histogram's uppermost mode, so the threshold is that mode's foot: as low as it can be without taking soft
/// texels. Where so few texels are opaque that blending would decide the picture, it goes lower, until a quarter is
/// opaque, but never below 0.5. It stays below 0.95: filtering takes a little of the alpha even of cores. Texels under
/// `discard` are never drawn and do not count.
[[nodiscard]] OpaqueThreshold choose_opaque_threshold(const AlphaHistogram& histogram, double discard);

/// From which alpha on the hair is drawn, and from which on as opaque: texture times factors, as the renderer compares.
struct Transparency {
  double opaque_threshold = 0;   ///< 0: all of it is opaque, and one pass draws it.
  double discard_threshold = 0;  ///< Equal to the other: nothing is blended, and one pass draws it.
  bool ignores_alpha = false;    ///< The file says opaque; alpha in the image means something else.
};

/// The recipe's thresholds, else what the file says: an opaque material ignores alpha, a masked one has its cutoff for
/// both thresholds. Else chosen from the alpha of the texels in `used` (see choose_opaque_threshold). `image` may be
/// null: one alpha everywhere. Warns of hair without an opaque core, which no drawing order shows well.
[[nodiscard]] Transparency choose_transparency(const BaseColor& color, const Image* image, const Image& used,
                                               const DrawnRecipe& recipe, Findings& findings);

}  // namespace coif::cook
