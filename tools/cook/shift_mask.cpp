#include "cook/shift_mask.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

// Fine across the strands, where each hair differs from the next; coarse along them.
constexpr std::uint32_t kAcross = 512;
constexpr std::uint32_t kAlong = 128;

/// A well-mixed 32-bit value for each lattice point; integer arithmetic, so equal on every machine. Shifts and odd
/// multipliers are those published for the lowbias32 mixer (Wellons, "hash-prospector").
std::uint32_t mix(std::uint32_t x) {
  x = (x ^ x >> 16) * 0x7FEB352Du;
  x = (x ^ x >> 15) * 0x846CA68Bu;
  return x ^ x >> 16;
}

double lattice(std::uint32_t seed, std::uint32_t x, std::uint32_t y) {
  return double(mix(seed ^ mix(x + 0x9E3779B9u * mix(y)))) / 4294967295.0;
}

/// Value noise on a lattice of `nx` by `ny` cells that repeats; x and y in 0..1.
double noise(std::uint32_t seed, double x, double y, std::uint32_t nx, std::uint32_t ny) {
  const auto ease = [](double t) { return t * t * (3 - 2 * t); };
  const double gx = x * nx, gy = y * ny;
  const auto ix = std::uint32_t(gx), iy = std::uint32_t(gy);
  const double fx = ease(gx - ix), fy = ease(gy - iy);
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return lattice(seed, (ix + i) % nx, (iy + j) % ny); };
  const double low = at(0, 0) + fx * (at(1, 0) - at(0, 0));
  const double high = at(0, 1) + fx * (at(1, 1) - at(0, 1));
  return low + fy * (high - low);
}

std::uint8_t to_byte(double value) { return std::uint8_t(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

}  // namespace

Image generate_shift_mask(std::uint32_t seed, bool along_u) {
  Image image{along_u ? kAlong : kAcross, along_u ? kAcross : kAlong, 2, {}};
  image.texels.resize(image.texel_count() * 2);
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const double u = (column + 0.5) / image.width, v = (row + 0.5) / image.height;
      const double across = along_u ? v : u, along = along_u ? u : v;
      // Single strands over thin locks over wide ones.
      const double shift = 0.5 * noise(seed, across, along, 320, 4) + 0.35 * noise(seed + 1, across, along, 96, 3) +
                           0.15 * noise(seed + 4, across, along, 24, 2);
      const double sparkle = noise(seed + 2, across, along, 320, 24) * noise(seed + 3, across, along, 64, 8);
      std::uint8_t* texel = &image.texels[2 * (std::size_t(row) * image.width + column)];
      texel[0] = to_byte(0.5 + 0.7 * (shift - 0.5));
      texel[1] = to_byte(0.15 + 1.4 * sparkle);
    }
  }
  return image;
}

Image combine_shift_mask(const Image* shift, const Image* mask, std::uint32_t seed, bool along_u) {
  Image combined = generate_shift_mask(seed, along_u);
  for (const Image* source : {shift, mask}) {
    if (source == nullptr) continue;
    combined.width = std::max(combined.width, source->width);
    combined.height = std::max(combined.height, source->height);
  }
  const Image generated = generate_shift_mask(seed, along_u);
  combined.texels.resize(combined.texel_count() * 2);
  for (std::uint32_t y = 0; y < combined.height; ++y) {
    for (std::uint32_t x = 0; x < combined.width; ++x) {
      // Nearest texel: both images and the generated one repeat over the same unit square.
      const auto pick = [&](const Image* image, std::uint32_t channel) {
        const Image& from = image != nullptr ? *image : generated;
        const std::size_t sx = std::size_t(x) * from.width / combined.width;
        const std::size_t sy = std::size_t(y) * from.height / combined.height;
        return from.texels[(sy * from.width + sx) * from.channels + (image != nullptr ? 0 : channel)];
      };
      std::uint8_t* texel = &combined.texels[2 * (std::size_t(y) * combined.width + x)];
      texel[0] = pick(shift, 0);
      texel[1] = pick(mask, 1);
    }
  }
  return combined;
}

}  // namespace coif
