#include "render/picture_scene.h"

#include "base/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace coif::render {
namespace {

constexpr float kMostRadiance = 65504;  ///< Half floats hold infinities, too, which would spoil a whole mean.
constexpr float kShoulder = 0.75f;      ///< Share of white at which the curve leaves the straight line.

std::uint8_t to_srgb(float linear) {
  return std::uint8_t(std::lround(255 * encode_srgb(std::clamp(linear, 0.0f, 1.0f))));
}

}  // namespace

void apply_tone_curve(std::span<float, 3> radiance) {
  const float most = std::max({radiance[0], radiance[1], radiance[2]});
  if (!(most > kShoulder)) return;
  const float room = 1 - kShoulder;
  const float shown = kShoulder + room * (1 - std::exp((kShoulder - most) / room));
  for (float& channel : radiance) channel *= shown / most;
}

LinearPicture light_of(std::vector<float> samples, std::uint32_t width, std::uint32_t height,
                       std::uint32_t oversampling) {
  for (float& sample : samples) sample = std::clamp(sample, 0.0f, kMostRadiance);
  return reduced({width * oversampling, height * oversampling, std::move(samples)}, oversampling);
}

std::vector<std::uint8_t> develop(std::span<const float> samples, std::uint32_t width, std::uint32_t height,
                                  std::uint32_t oversampling) {
  std::vector<std::uint8_t> pixels(std::size_t{4} * width * height);
  const std::size_t row = std::size_t{width} * oversampling;
  const float share = 1 / float(oversampling * oversampling);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::array<float, 4> mean{};
      for (std::size_t s = 0; s < std::size_t{oversampling} * oversampling; ++s) {
        const std::size_t at = (y * oversampling + s / oversampling) * row + x * oversampling + s % oversampling;
        std::array<float, 4> sample;
        for (std::size_t k = 0; k < 4; ++k) sample[k] = std::clamp(samples[4 * at + k], 0.0f, kMostRadiance);
        apply_tone_curve(std::span(sample).first<3>());
        for (std::size_t k = 0; k < 4; ++k) mean[k] += share * sample[k];
      }
      // Pictures with a transparent background hold plain colours, not premultiplied ones.
      const float covered = mean[3] > 0 ? std::min(mean[3], 1.0f) : 1;
      for (std::size_t k = 0; k < 3; ++k) mean[k] /= covered;
      std::uint8_t* pixel = &pixels[4 * (y * width + x)];
      for (std::size_t k = 0; k < 3; ++k) pixel[k] = to_srgb(mean[k]);
      pixel[3] = std::uint8_t(std::lround(255 * std::min(mean[3], 1.0f)));
    }
  }
  return pixels;
}

}  // namespace coif::render
