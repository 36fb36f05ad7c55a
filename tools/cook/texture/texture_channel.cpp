#include "cook/texture/recipe_maps.h"

#include <algorithm>

namespace coif::cook {
namespace {

std::uint8_t number_of(const std::uint8_t* texel, TextureChannel channel) {
  switch (channel) {
    case TextureChannel::kRed: return texel[0];
    case TextureChannel::kGreen: return texel[1];
    case TextureChannel::kBlue: return texel[2];
    case TextureChannel::kAlpha: return texel[3];
    default: return std::uint8_t((2126u * texel[0] + 7152u * texel[1] + 722u * texel[2] + 5000u) / 10000u);
  }
}

}  // namespace

TextureChannel channel_in(const Image& image, TextureChannel channel) {
  if (channel != TextureChannel::kAuto) return channel;
  for (std::size_t i = 3; i < image.texels.size(); i += 4) {
    if (image.texels[i] != 255) return TextureChannel::kAlpha;
  }
  return TextureChannel::kLuminance;
}

Image channel_of(const Image& image, TextureChannel channel, bool is_inverted) {
  const TextureChannel chosen = channel_in(image, channel);
  Image numbers{image.width, image.height, 1, {}};
  numbers.texels.reserve(image.texel_count());
  for (std::size_t i = 0; i < image.texels.size(); i += 4) {
    const std::uint8_t number = number_of(&image.texels[i], chosen);
    numbers.texels.push_back(is_inverted ? std::uint8_t(255 - number) : number);
  }
  return numbers;
}

Image with_alpha(const Image* base, const Image& alpha) {
  Image white{1, 1, 4, {255, 255, 255, 255}};
  const std::uint32_t width = std::max(base != nullptr ? base->width : 1, alpha.width);
  const std::uint32_t height = std::max(base != nullptr ? base->height : 1, alpha.height);
  Image image = base != nullptr ? *base : white;
  // The old alpha must not affect the averages of colours.
  for (std::size_t i = 3; i < image.texels.size(); i += 4) image.texels[i] = 255;
  image = enlarge(std::move(image), width, height, TexelMeaning::kSrgbColorAlpha);
  const Image numbers = enlarge(alpha, width, height, TexelMeaning::kNumbers);
  for (std::size_t i = 0; i < numbers.texels.size(); ++i) image.texels[4 * i + 3] = numbers.texels[i];
  return image;
}

Image as_chosen(Image image, const RecipeTexture& chosen) {
  if (chosen.channel == TextureChannel::kAuto && !chosen.is_inverted) return image;
  if (chosen.channel == TextureChannel::kAuto) {
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
      if (i % 4 != 3) image.texels[i] = std::uint8_t(255 - image.texels[i]);
    }
    return image;
  }
  const Image numbers = channel_of(image, chosen.channel, chosen.is_inverted);
  for (std::size_t i = 0; i < numbers.texels.size(); ++i) {
    std::fill_n(&image.texels[4 * i], 3, numbers.texels[i]);
    image.texels[4 * i + 3] = 255;
  }
  return image;
}

}  // namespace coif::cook
