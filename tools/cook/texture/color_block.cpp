#include "cook/texture/color_block.h"

#include "cook/texture/eac_block.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace coif::cook {
namespace {

constexpr std::size_t kHalfTexels = 8, kColors = 3;
constexpr int kLightSteps[8][2] = {{2, 8}, {5, 17}, {9, 29}, {13, 42}, {18, 60}, {24, 80}, {33, 106}, {47, 183}};
/// Texels without alpha show between their neighbours' colours, so they count a little.
constexpr float kLeastWeight = 1.0f / 32;

struct WeighedTexel {
  std::array<float, kColors> color;
  float weight;
  std::uint8_t place;  ///< The bit of the texel's index: column by column.
};

using Half = std::array<WeighedTexel, kHalfTexels>;

/// A colour of a half and its steps lighter and darker.
struct HalfCode {
  std::array<int, kColors> color{};  ///< In four or five bits.
  int table = 0;
  float error = INFINITY;  ///< Sum of squares by weight.
};

/// Bits of the texels of a half: bit 0..15 the lower one, 16..31 the higher one.
struct CodedHalf {
  HalfCode code;
  std::uint32_t indices = 0;
};

int widened(int value, int bits) { return value << (8 - bits) | value >> (2 * bits - 8); }

/// What a half is from the colour: per texel the sum and the squares of its differences.
struct Differences {
  std::array<float, kHalfTexels> sum{}, squares{};
};

Differences differences(const Half& half, const std::array<int, kColors>& color, int bits) {
  Differences result;
  for (std::size_t t = 0; t < kHalfTexels; ++t) {
    for (std::size_t k = 0; k < kColors; ++k) {
      const float d = half[t].color[k] - float(widened(color[k], bits));
      result.sum[t] += d;
      result.squares[t] += d * d;
    }
  }
  return result;
}

/// The error of a texel that all channels are moved by `step`, where none of them leaves 0..255.
float error_after(const Differences& from, std::size_t texel, float step) {
  return from.squares[texel] - 2 * step * from.sum[texel] + float(kColors) * step * step;
}

/// The step for a texel as the index that stands for it: 0 and 1 lighter, 2 and 3 darker.
std::uint32_t nearest_step(const Differences& from, std::size_t texel, int table) {
  const float small = float(kLightSteps[table][0]), large = float(kLightSteps[table][1]);
  const bool darker = from.sum[texel] < 0;
  const float size = std::abs(from.sum[texel]);
  return (darker ? 2u : 0u) + (2 * size > float(kColors) * (small + large) ? 1u : 0u);
}

float step_of_index(std::uint32_t index, int table) {
  const float step = float(kLightSteps[table][index & 1]);
  return (index & 2) != 0 ? -step : step;
}

HalfCode best_table(const Half& half, const std::array<int, kColors>& color, int bits) {
  const Differences from = differences(half, color, bits);
  HalfCode best;
  for (int table = 0; table < 8; ++table) {
    float error = 0;
    for (std::size_t t = 0; t < kHalfTexels; ++t)
      error += half[t].weight * error_after(from, t, step_of_index(nearest_step(from, t, table), table));
    if (error < best.error) best = {color, table, error};
  }
  return best;
}

std::array<float, kColors> mean_of(const Half& half) {
  std::array<float, kColors> mean{};
  float weight = 0;
  for (const WeighedTexel& texel : half) {
    for (std::size_t k = 0; k < kColors; ++k) mean[k] += texel.weight * texel.color[k];
    weight += texel.weight;
  }
  for (float& channel : mean) channel /= weight;
  return mean;
}

/// The half's mean and its neighbours that are a little lighter or darker.
std::array<HalfCode, 3> candidates(const Half& half, int bits) {
  const int most = (1 << bits) - 1;
  const auto mean = mean_of(half);
  std::array<HalfCode, 3> found;
  for (int shift = -1; shift <= 1; ++shift) {
    std::array<int, kColors> color{};
    for (std::size_t k = 0; k < kColors; ++k)
      color[k] = std::clamp(int(std::lround(mean[k] * float(most) / 255)) + shift, 0, most);
    found[std::size_t(shift + 1)] = best_table(half, color, bits);
  }
  return found;
}

/// Both halves in one of the modes of ETC1.
struct HalvesCode {
  std::array<HalfCode, 2> half;
  bool is_flipped = false, is_differential = false;
  float error = INFINITY;
};

bool may_follow(const HalfCode& first, const HalfCode& second) {
  for (std::size_t k = 0; k < kColors; ++k) {
    const int difference = second.color[k] - first.color[k];
    if (difference < -4 || difference > 3) return false;
  }
  return true;
}

using Halves = std::array<Half, 2>;

void try_halves(const Halves& halves, bool is_flipped, HalvesCode& best) {
  for (const bool is_differential : {true, false}) {
    const int bits = is_differential ? 5 : 4;
    const auto first = candidates(halves[0], bits), second = candidates(halves[1], bits);
    for (const HalfCode& a : first) {
      for (const HalfCode& b : second) {
        if (is_differential && !may_follow(a, b)) continue;
        if (a.error + b.error < best.error) best = {{a, b}, is_flipped, is_differential, a.error + b.error};
      }
    }
  }
}

Halves halves_of(const ColorBlock& block, bool is_flipped) {
  Halves halves;
  std::size_t count[2] = {};
  for (std::size_t x = 0; x < 4; ++x) {
    for (std::size_t y = 0; y < 4; ++y) {
      const auto& from = block[4 * y + x];
      const std::size_t side = (is_flipped ? y : x) / 2;
      halves[side][count[side]++] = {{float(from[0]), float(from[1]), float(from[2])},
                                     std::max(float(from[3]) / 255, kLeastWeight),
                                     std::uint8_t(4 * x + y)};
    }
  }
  return halves;
}

std::uint64_t indices_of(const Half& half, const HalfCode& code, int bits) {
  const Differences from = differences(half, code.color, bits);
  std::uint64_t indices = 0;
  for (std::size_t t = 0; t < kHalfTexels; ++t) {
    const std::uint32_t index = nearest_step(from, t, code.table);
    indices |= std::uint64_t(index & 1) << half[t].place | std::uint64_t(index >> 1) << (16 + half[t].place);
  }
  return indices;
}

std::uint64_t bits_of(const Halves& halves, const HalvesCode& code) {
  const int bits = code.is_differential ? 5 : 4;
  std::uint64_t word = std::uint64_t(code.half[0].table) << 37 | std::uint64_t(code.half[1].table) << 34 |
                       std::uint64_t(code.is_differential) << 33 | std::uint64_t(code.is_flipped) << 32;
  for (std::size_t k = 0; k < kColors; ++k) {
    const auto first = std::uint64_t(code.half[0].color[k]), second = std::uint64_t(code.half[1].color[k]);
    const std::uint64_t channel = code.is_differential ? first << 3 | ((second - first) & 7) : first << 4 | second;
    word |= channel << (56 - 8 * k);
  }
  for (std::size_t side = 0; side < 2; ++side) word |= indices_of(halves[side], code.half[side], bits);
  return word;
}

/// A plane through colours at the block's corner, four texels right of it and four below.
struct PlaneCode {
  std::array<std::array<int, kColors>, 3> corner{};  ///< In six, seven and six bits.
  float error = INFINITY;
};

constexpr int kPlaneBits[kColors] = {6, 7, 6};

/// Least squares by weight: a + b x + c y.
std::optional<std::array<float, 3>> fit_plane(const Halves& halves, std::size_t channel) {
  float m[3][4] = {};
  for (const Half& half : halves) {
    for (const WeighedTexel& texel : half) {
      const float row[4] = {1, float(texel.place / 4), float(texel.place % 4), texel.color[channel]};
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 4; ++j) m[i][j] += texel.weight * row[i] * row[j];
      }
    }
  }
  for (int i = 0; i < 3; ++i) {
    if (!(m[i][i] > 1e-6f)) return std::nullopt;
    for (int j = i + 1; j < 3; ++j) {
      const float factor = m[j][i] / m[i][i];
      for (int k = i; k < 4; ++k) m[j][k] -= factor * m[i][k];
    }
  }
  std::array<float, 3> solved{};
  for (int i = 2; i >= 0; --i) {
    float rest = m[i][3];
    for (int j = i + 1; j < 3; ++j) rest -= m[i][j] * solved[std::size_t(j)];
    solved[std::size_t(i)] = rest / m[i][i];
  }
  return solved;
}

PlaneCode best_plane(const Halves& halves) {
  PlaneCode code;
  for (std::size_t k = 0; k < kColors; ++k) {
    const auto plane = fit_plane(halves, k);
    if (!plane) return {};
    const int most = (1 << kPlaneBits[k]) - 1;
    const float corner[3] = {(*plane)[0], (*plane)[0] + 4 * (*plane)[1], (*plane)[0] + 4 * (*plane)[2]};
    for (std::size_t i = 0; i < 3; ++i)
      code.corner[i][k] = std::clamp(int(std::lround(corner[i] * float(most) / 255)), 0, most);
  }
  code.error = 0;
  for (const Half& half : halves) {
    for (const WeighedTexel& texel : half) {
      const int x = texel.place / 4, y = texel.place % 4;
      for (std::size_t k = 0; k < kColors; ++k) {
        const int origin = widened(code.corner[0][k], kPlaneBits[k]);
        const int right = widened(code.corner[1][k], kPlaneBits[k]), below = widened(code.corner[2][k], kPlaneBits[k]);
        const int value = std::clamp((x * (right - origin) + y * (below - origin) + 4 * origin + 2) >> 2, 0, 255);
        const float d = texel.color[k] - float(value);
        code.error += texel.weight * d * d;
      }
    }
  }
  return code;
}

std::uint64_t bits_of(const PlaneCode& code) {
  const auto& [origin, right, below] = code.corner;
  const auto part = [](int value, int from, int count, int to) {
    return std::uint64_t(unsigned(value) >> from & ((1u << count) - 1)) << to;
  };
  std::uint64_t word = part(origin[0], 0, 6, 57) | part(origin[1], 6, 1, 56) | part(origin[1], 0, 6, 49) |
                       part(origin[2], 5, 1, 48) | part(origin[2], 3, 2, 43) | part(origin[2], 0, 3, 39) |
                       part(right[0], 1, 5, 34) | std::uint64_t{1} << 33 | part(right[0], 0, 1, 32) |
                       part(right[1], 0, 7, 25) | part(right[2], 0, 6, 19) | part(below[0], 0, 6, 13) |
                       part(below[1], 0, 7, 6) | part(below[2], 0, 6, 0);
  // Unused bits say which mode it is: red and green stay in range, blue leaves it.
  const auto signed_three = [&](int from) { return int(word >> from & 7) - ((word >> from & 4) != 0 ? 8 : 0); };
  for (const int channel : {59, 51}) {
    const int value = int(word >> channel & 15);
    if (value + signed_three(channel - 3) < 0) word |= std::uint64_t{1} << (channel + 4);
  }
  const bool overflows = int(word >> 43 & 3) + int(word >> 40 & 3) >= 4;
  return word | (overflows ? std::uint64_t{7} << 45 : std::uint64_t{1} << 42);
}

}  // namespace

void encode_color_block(const ColorBlock& block, std::uint8_t* out) {
  EacBlock alpha;
  for (std::size_t x = 0; x < 4; ++x) {
    for (std::size_t y = 0; y < 4; ++y) alpha.set(4 * x + y, block[4 * y + x][3]);
  }
  encode_eac_block(alpha, EacValues::kAlpha, out);

  const std::array<Halves, 2> cuts{halves_of(block, false), halves_of(block, true)};
  HalvesCode halves;
  for (const bool is_flipped : {false, true}) try_halves(cuts[is_flipped ? 1 : 0], is_flipped, halves);
  const PlaneCode plane = best_plane(cuts[0]);
  const std::uint64_t word =
      plane.error <= halves.error ? bits_of(plane) : bits_of(cuts[halves.is_flipped ? 1 : 0], halves);
  for (std::size_t byte = 0; byte < 8; ++byte) out[8 + byte] = std::uint8_t(word >> (56 - 8 * byte));
}

}  // namespace coif::cook
