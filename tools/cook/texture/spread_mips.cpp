#include "cook/texture/image.h"

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

/// A mip of which next to nothing is left is noise of rounding: that is not made larger than this.
constexpr double kMostSpread = 6;

struct TexelSpread {
  double mean = 0, deviation = 0;
};

TexelSpread spread_of(const Image& mip, const Image& used, std::size_t channel) {
  double sum = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < used.texels.size(); ++i) {
    const double weight = used.texels[i], value = mip.texels[mip.channels * i + channel];
    count += weight;
    sum += weight * value;
    squares += weight * value * value;
  }
  if (count == 0) return {};
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

void stretch(Image& mip, std::size_t channel, const TexelSpread& now, double factor) {
  for (std::size_t i = channel; i < mip.texels.size(); i += mip.channels) {
    const double value = now.mean + factor * (double(mip.texels[i]) - now.mean);
    mip.texels[i] = std::uint8_t(std::lround(std::clamp(value, 0.0, 255.0)));
  }
}

}  // namespace

void keep_spread(std::span<Image> mips, Image used) {
  if (mips.empty()) return;
  std::vector<TexelSpread> wanted;
  for (std::size_t channel = 0; channel < mips[0].channels; ++channel) {
    wanted.push_back(spread_of(mips[0], used, channel));
  }
  for (Image& mip : mips.subspan(1)) {
    used = shrink(used, mip.width, mip.height, TexelMeaning::kNumbers);
    for (std::size_t channel = 0; channel < wanted.size(); ++channel) {
      const TexelSpread now = spread_of(mip, used, channel);
      if (now.deviation < 1) continue;  // a step of 255: one strand's number, or a mip of a few texels
      const double factor = wanted[channel].deviation / now.deviation;
      if (factor > 1) stretch(mip, channel, now, std::min(factor, kMostSpread));
    }
  }
}

}  // namespace coif::cook
