#include "cook/texture/texture_atlas.h"

#include "base/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

/// Alphas up to the first take all of their colour from others, from the second on none: below the usual threshold of
/// discarding nothing is seen, and where colour was painted it is kept.
constexpr float kClear = 8, kPainted = 16;

/// Values of some texels, with a weight of 0..1 for how far they are known.
template <std::size_t kChannels>
struct GapLayer {
  std::uint32_t width = 0, height = 0;
  std::vector<std::array<float, kChannels>> values;
  std::vector<float> weights;

  GapLayer(std::uint32_t w, std::uint32_t h)
      : width(w), height(h), values(std::size_t(w) * h), weights(std::size_t(w) * h, 0.0f) {}
  [[nodiscard]] std::size_t at(std::uint32_t x, std::uint32_t y) const { return std::size_t(y) * width + x; }
};

/// Half the size: means of known texels; two known texels make one that is fully known.
template <std::size_t kChannels>
GapLayer<kChannels> pushed(const GapLayer<kChannels>& fine) {
  GapLayer<kChannels> coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
  for (std::uint32_t y = 0; y < fine.height; ++y) {
    for (std::uint32_t x = 0; x < fine.width; ++x) {
      const std::size_t from = fine.at(x, y), to = coarse.at(x / 2, y / 2);
      coarse.weights[to] += fine.weights[from];
      for (std::size_t c = 0; c < kChannels; ++c) coarse.values[to][c] += fine.weights[from] * fine.values[from][c];
    }
  }
  for (std::size_t i = 0; i < coarse.weights.size(); ++i) {
    if (coarse.weights[i] > 0) {
      for (float& value : coarse.values[i]) value /= coarse.weights[i];
    }
    coarse.weights[i] = std::min(1.0f, 0.5f * coarse.weights[i]);
  }
  return coarse;
}

/// Fills the unknown texels of `fine` from `coarse`, which is completely known.
template <std::size_t kChannels>
void pull(const GapLayer<kChannels>& coarse, GapLayer<kChannels>& fine) {
  const auto beside = [](std::uint32_t place, std::uint32_t size) {
    const std::uint32_t own = place / 2;
    const std::uint32_t other = place % 2 == 0 ? std::max(own, 1u) - 1 : std::min(own + 1, size - 1);
    return std::pair(own, other);
  };
  for (std::uint32_t y = 0; y < fine.height; ++y) {
    const auto [row, other_row] = beside(y, coarse.height);
    for (std::uint32_t x = 0; x < fine.width; ++x) {
      const std::size_t to = fine.at(x, y);
      const float weight = fine.weights[to];
      if (weight >= 1) continue;
      const auto [column, other_column] = beside(x, coarse.width);
      for (std::size_t c = 0; c < kChannels; ++c) {
        const auto value = [&](std::uint32_t i, std::uint32_t j) { return coarse.values[coarse.at(i, j)][c]; };
        const float filtered = 0.5625f * value(column, row) + 0.0625f * value(other_column, other_row) +
                               0.1875f * (value(other_column, row) + value(column, other_row));
        fine.values[to][c] = weight * fine.values[to][c] + (1 - weight) * filtered;
      }
    }
  }
}

/// False where nothing is known.
template <std::size_t kChannels>
bool fill(GapLayer<kChannels>& layer) {
  std::vector<GapLayer<kChannels>> coarser;
  for (const GapLayer<kChannels>* last = &layer; last->width > 1 || last->height > 1; last = &coarser.back()) {
    GapLayer<kChannels> next = pushed(*last);
    coarser.push_back(std::move(next));
  }
  const GapLayer<kChannels>& top = coarser.empty() ? layer : coarser.back();
  if (!(top.weights[0] > 0)) return false;
  for (std::size_t i = coarser.size(); i-- > 1;) pull(coarser[i], coarser[i - 1]);
  if (!coarser.empty()) pull(coarser[0], layer);
  return true;
}

float light_of(std::uint8_t srgb) { return decode_srgb(float(srgb) / 255); }

std::uint8_t srgb_of(float light) {
  return std::uint8_t(std::lround(std::clamp(encode_srgb(light), 0.0f, 1.0f) * 255));
}

/// Used, or next to a used one: filtering in the largest mip reaches these, so they stay as painted.
std::vector<bool> reachable(const Image& used) {
  std::vector<bool> result(used.texel_count(), false);
  const std::uint32_t width = used.width, height = used.height;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      if (used.texels[std::size_t(y) * width + x] == 0) continue;
      for (const std::uint32_t j : {(y + height - 1) % height, y, (y + 1) % height}) {
        for (const std::uint32_t i : {(x + width - 1) % width, x, (x + 1) % width})
          result[std::size_t(j) * width + i] = true;
      }
    }
  }
  return result;
}

void fill_alpha(const Image& used, const std::vector<bool>& kept, Image& image) {
  GapLayer<1> alpha(image.width, image.height);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    alpha.values[i][0] = float(image.texels[4 * i + 3]);
    alpha.weights[i] = used.texels[i] != 0 ? 1.0f : 0.0f;
  }
  if (!fill(alpha)) return;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) image.texels[4 * i + 3] = std::uint8_t(std::lround(alpha.values[i][0]));
  }
}

void fill_color(const Image& used, const std::vector<bool>& kept, Image& image) {
  std::array<float, 256> light;
  for (int i = 0; i < 256; ++i) light[std::size_t(i)] = light_of(std::uint8_t(i));
  const auto painted = [&](std::size_t i) {
    return std::clamp((float(image.texels[4 * i + 3]) - kClear) / (kPainted - kClear), 0.0f, 1.0f);
  };
  GapLayer<3> color(image.width, image.height);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) color.values[i][c] = light[image.texels[4 * i + c]];
    if (used.texels[i] != 0) color.weights[i] = painted(i);
  }
  if (!fill(color)) return;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    // A used texel is mixed already.
    const float own = used.texels[i] == 0 && kept[i] ? painted(i) : 0.0f;
    if (color.weights[i] >= 1 || own >= 1) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& texel = image.texels[4 * i + c];
      texel = srgb_of(own * light[texel] + (1 - own) * color.values[i][c]);
    }
  }
}

}  // namespace

void fill_gaps(Image& image, const Image& used) {
  const std::vector<bool> kept = reachable(used);
  fill_alpha(used, kept, image);
  fill_color(used, kept, image);
}

}  // namespace coif::cook
