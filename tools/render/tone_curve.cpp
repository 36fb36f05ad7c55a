#include "render/picture_scene.h"

#include "base/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace coif::render {
namespace {

constexpr float kMostRadiance = 65504;  ///< Half floats hold infinities, too, which would spoil a whole mean.
constexpr float kShoulder = 0.75f;      ///< Share of white at which the curve leaves the straight line.

/// 0 where it is no number.
float bounded(float radiance) {
  const float least = radiance > 0 ? radiance : 0;
  return least < kMostRadiance ? least : kMostRadiance;
}

std::uint8_t to_srgb(float linear) {
  return std::uint8_t(std::lround(255 * encode_srgb(std::clamp(linear, 0.0f, 1.0f))));
}

/// to_srgb() by table, with the same results for numbers that are not negative.
class SrgbTable {
 public:
  SrgbTable() {
    for (std::size_t i = 0; i < kSteps; ++i) least_[i] = to_srgb(float(i) / kSteps);
    for (std::size_t value = 1; value < first_.size(); ++value) first_[value] = first_of(int(value));
  }

  [[nodiscard]] std::uint8_t operator()(float linear) const {
    if (!(linear < 1)) return linear >= 1 ? 255 : 0;
    std::size_t value = least_[std::size_t(linear * kSteps)];
    while (value < 255 && linear >= first_[value + 1]) ++value;
    return std::uint8_t(value);
  }

 private:
  static constexpr std::size_t kSteps = 4096;  // A power of two, so that an index is exact.

  /// The smallest number that is encoded as `value`, which is above 0: bits of positive floats are in their order.
  static float first_of(int value) {
    auto below = std::bit_cast<std::uint32_t>(0.0f), reached = std::bit_cast<std::uint32_t>(1.0f);
    while (reached - below > 1) {
      const std::uint32_t middle = below + (reached - below) / 2;
      (to_srgb(std::bit_cast<float>(middle)) >= value ? reached : below) = middle;
    }
    return std::bit_cast<float>(reached);
  }

  std::array<std::uint8_t, kSteps> least_{};
  std::array<float, 256> first_{};
};

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
  static const SrgbTable encoded;
  std::vector<std::uint8_t> pixels(std::size_t{4} * width * height);
  const std::size_t row = std::size_t{width} * oversampling;
  const float share = 1 / float(oversampling * oversampling);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::array<float, 4> mean{};
      for (std::size_t line = 0; line < oversampling; ++line) {
        const float* from = &samples[4 * ((y * oversampling + line) * row + x * oversampling)];
        for (const float* const end = from + std::size_t{4} * oversampling; from != end; from += 4) {
          std::array<float, 4> sample;
          for (std::size_t k = 0; k < 4; ++k) sample[k] = bounded(from[k]);
          if (std::max({sample[0], sample[1], sample[2]}) > kShoulder) apply_tone_curve(std::span(sample).first<3>());
          for (std::size_t k = 0; k < 4; ++k) mean[k] += share * sample[k];
        }
      }
      // Pictures with a transparent background hold plain colours, not premultiplied ones.
      const float covered = mean[3] > 0 ? std::min(mean[3], 1.0f) : 1;
      for (std::size_t k = 0; k < 3; ++k) mean[k] /= covered;
      std::uint8_t* pixel = &pixels[4 * (y * width + x)];
      for (std::size_t k = 0; k < 3; ++k) pixel[k] = encoded(mean[k]);
      pixel[3] = std::uint8_t(std::lround(255 * std::min(mean[3], 1.0f)));
    }
  }
  return pixels;
}

}  // namespace coif::render
