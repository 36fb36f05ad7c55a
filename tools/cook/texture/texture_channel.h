#pragma once

#include "cook/recipe/recipe_texture.h"
#include "cook/texture/image.h"

namespace coif::cook {

/// kAuto decided for an RGBA image: alpha where any of it is not opaque, else the luminance.
[[nodiscard]] TextureChannel channel_in(const Image& image, TextureChannel channel);

/// One channel of an RGBA image as an image of one channel; luminance by the weights of BT.709, of the numbers as they
/// are.
[[nodiscard]] Image channel_of(const Image& image, TextureChannel channel, bool is_inverted);

/// `base` with the one-channel image as its alpha, at the larger of both sizes; white where `base` is null.
[[nodiscard]] Image with_alpha(const Image* base, const Image& alpha);

/// An image that the recipe names, as it says: grey of one channel where it names one, or turned over.
[[nodiscard]] Image as_chosen(Image image, const RecipeTexture& chosen);

}  // namespace coif::cook
