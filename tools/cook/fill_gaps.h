#pragma once

#include "cook/image.h"

namespace coif {

/// Gives texels that nothing shows what is around those that hair shows, so that no filter mixes in a foreign colour:
///
/// - Texels that the hair does not use (0 in `used`, one channel, the image's size), from the second one away on,
///   take alpha and colour of the used ones near them. Else smaller mips would mix in the background, or a face on
///   the same image.
/// - Used texels that are as good as clear keep their alpha and take the colour of the opaque ones near them:
///   exporters and paint programs leave black or white under alpha 0, which filtering would bring back as a seam.
///
/// From near to far by pyramids of averages in linear light, weighted by alpha (Gortler et al. 1996, "The lumigraph",
/// push-pull). An image without a used texel stays.
void fill_gaps(Image& image, const Image& used);

}  // namespace coif
