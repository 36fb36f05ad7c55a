#include "cook/alpha_mips.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

/// Of 255: what a threshold loses as a single-precision number of the asset.
constexpr double kRounding = 1.0e-3;
constexpr double kMaxScale = 4;  ///< A level that would need more has lost its strands.

std::uint8_t scaled(std::uint8_t alpha, double scale) {
  return std::uint8_t(std::min(255.0, std::floor(double(alpha) * scale + 0.5)));
}

double coverage_at_scale(const Image& image, const Image& used, double threshold, double scale) {
  std::uint64_t passing = 0, all = 0;
  for (std::size_t i = 0; i < image.texel_count(); ++i) {
    all += used.texels[i];
    if (double(scaled(image.texels[4 * i + 3], scale)) >= threshold * 255 - kRounding) passing += used.texels[i];
  }
  return all > 0 ? double(passing) / double(all) : 0;
}

}  // namespace

double alpha_coverage(const Image& image, const Image& used, double threshold) {
  return coverage_at_scale(image, used, threshold, 1);
}

void keep_alpha_coverage(std::span<Image> mips, std::span<const Image> used, double threshold) {
  const double wanted = alpha_coverage(mips[0], used[0], threshold);
  if (wanted <= 0 || wanted >= 1) return;
  for (std::size_t level = 1; level < mips.size(); ++level) {
    Image& mip = mips[level];
    double low = 1, high = kMaxScale;
    if (coverage_at_scale(mip, used[level], threshold, low) >= wanted) continue;
    for (int step = 0; step < 12; ++step) {
      const double middle = 0.5 * (low + high);
      (coverage_at_scale(mip, used[level], threshold, middle) < wanted ? low : high) = middle;
    }
    for (std::size_t i = 3; i < mip.texels.size(); i += 4) mip.texels[i] = scaled(mip.texels[i], high);
  }
}

void fill_color_under_alpha(std::span<Image> mips) {
  // From the smallest level up: each empty texel takes the colour of the texel above it, which is already filled.
  for (std::size_t level = mips.size() - 1; level-- > 0;) {
    Image& fine = mips[level];
    const Image& coarse = mips[level + 1];
    for (std::uint32_t y = 0; y < fine.height; ++y) {
      for (std::uint32_t x = 0; x < fine.width; ++x) {
        std::uint8_t* texel = &fine.texels[4 * (std::size_t(y) * fine.width + x)];
        if (texel[3] != 0) continue;
        const std::uint32_t cx = std::min(x / 2, coarse.width - 1), cy = std::min(y / 2, coarse.height - 1);
        std::copy_n(&coarse.texels[4 * (std::size_t(cy) * coarse.width + cx)], 3, texel);
      }
    }
  }
}

}  // namespace coif
