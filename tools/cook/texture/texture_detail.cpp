#include "cook/texture/image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

constexpr double kMostTexelRms = 1;    ///< In steps of 255: 48 dB, about the error of one more rounding.
constexpr double kMostTexelError = 6;  ///< In steps of 255, for any texel.

/// Two neighbours along one axis of an image that repeats, and how much the second one counts.
struct Between {
  std::uint32_t low = 0, high = 0;
  float share = 0;
};

/// For each texel of `fine` along one side the place of its middle in texels of `coarse`.
std::vector<Between> places_in(std::uint32_t coarse, std::uint32_t fine) {
  std::vector<Between> places;
  for (std::uint32_t i = 0; i < fine; ++i) {
    const float at = (float(i) + 0.5f) * float(coarse) / float(fine) - 0.5f;
    const float low = std::floor(at);
    const auto index = [coarse](float k) { return std::uint32_t((std::int64_t(k) + coarse) % coarse); };
    places.push_back({index(low), index(low + 1), at - low});
  }
  return places;
}

/// Colour as it is blended over black, and alpha; or plain numbers.
template <TexelMeaning kMeaning>
std::array<float, 4> shown(const Image& image, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* c = &image.texels[image.channels * (std::size_t(y) * image.width + x)];
  if constexpr (kMeaning == TexelMeaning::kSrgbColorAlpha) {
    const float alpha = float(c[3]) / 255;
    return {alpha * float(c[0]), alpha * float(c[1]), alpha * float(c[2]), float(c[3])};
  }
  std::array<float, 4> numbers{};
  for (std::size_t k = 0; k < image.channels; ++k) numbers[k] = float(c[k]);
  return numbers;
}

/// The distance of `coarse`, sampled between its texels, from `fine` where that is used; stops where that is too much.
template <TexelMeaning kMeaning>
std::optional<TexelError> error_within_limits(const Image& coarse, const Image& fine, const Image& used) {
  const std::vector<Between> across = places_in(coarse.width, fine.width), down = places_in(coarse.height, fine.height);
  TexelError error;
  double squares = 0, count = 0;
  for (std::uint32_t y = 0; y < fine.height; ++y) {
    for (std::uint32_t x = 0; x < fine.width; ++x) {
      if (used.texels[std::size_t(y) * used.width + x] == 0) continue;
      const Between &u = across[x], &v = down[y];
      const auto a = shown<kMeaning>(coarse, u.low, v.low), b = shown<kMeaning>(coarse, u.high, v.low);
      const auto c = shown<kMeaning>(coarse, u.low, v.high), d = shown<kMeaning>(coarse, u.high, v.high),
                 exact = shown<kMeaning>(fine, x, y);
      for (std::size_t k = 0; k < fine.channels; ++k) {
        const float upper = a[k] + u.share * (b[k] - a[k]), lower = c[k] + u.share * (d[k] - c[k]);
        const double off = std::abs(double(upper + v.share * (lower - upper) - exact[k]));
        if (off > kMostTexelError) return std::nullopt;
        error.most = std::max(error.most, off);
        squares += off * off;
      }
      count += fine.channels;
    }
  }
  error.rms = count > 0 ? std::sqrt(squares / count) : 0;
  return error.rms <= kMostTexelRms ? std::optional(error) : std::nullopt;
}

}  // namespace

DetailedImage reduce_to_detail(Image image, const Image& used, TexelMeaning meaning) {
  const auto error_of = meaning == TexelMeaning::kNumbers ? error_within_limits<TexelMeaning::kNumbers>
                                                          : error_within_limits<TexelMeaning::kSrgbColorAlpha>;
  DetailedImage result{image, {}};
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const bool across : {true, false}) {
      const Image& now = result.image;
      if ((across ? now.width : now.height) == 1) continue;
      Image half = shrink(image, across ? now.width / 2 : now.width, across ? now.height : now.height / 2, meaning);
      const auto error = error_of(half, image, used);
      if (!error) continue;
      result = {std::move(half), *error};
      smaller = true;
    }
  }
  return result;
}

}  // namespace coif::cook
