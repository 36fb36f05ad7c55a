#pragma once

#include "cook/base_color.h"

namespace coif {

/// From which alpha on the hair is drawn, and from which on as opaque: texture times factors, as the renderer compares.
struct Transparency {
  double opaque_threshold = 0;   ///< 0: all of it is opaque, and one pass draws it.
  double discard_threshold = 0;  ///< Equal to the other: nothing is blended, and one pass draws it.
  bool ignores_alpha = false;    ///< The file says opaque; alpha in the image means something else.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

/// The recipe's thresholds, else what the file says: an opaque material ignores alpha, a masked one has its cutoff for both
/// thresholds. Else chosen from the alpha of the texels in `used` (see choose_opaque_threshold). `image` may be null: one
/// alpha everywhere. Warns of hair without an opaque core, which no drawing order shows well.
[[nodiscard]] Transparency choose_transparency(const BaseColor& color, const Image* image, const Image& used,
                                               const Recipe& recipe);

}  // namespace coif
