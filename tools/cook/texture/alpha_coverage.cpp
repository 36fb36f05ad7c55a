#include "cook/texture/alpha.h"

#include "base/color_texels.h"
#include "cook/texture/transparency.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace coif::cook {
namespace {

constexpr double kRounding = 1.0e-3;  ///< In steps of 255.
constexpr int kShares = 16;  ///< Parts of a sample: nine of its texel, three of two neighbours each, one of the third.
constexpr int kSamples = 4;  ///< Samples per texel.

class Sums {
 public:
  explicit Sums(const AlphaThresholds& thresholds)
      : opaque_(std::int16_t(least_passing(thresholds.opaque))),
        discard_(std::int16_t(least_passing(thresholds.discard))) {}

  /// A plain loop over small numbers, which compilers vectorise; so is that of add_samples().
  void add_texels(const std::int16_t* row, std::span<const std::int16_t> weights) {
    std::int32_t weight = 0, opaque = 0;
    for (std::size_t x = 0; x < weights.size(); ++x) {
      const auto passing = std::int16_t(row[x] >= opaque_ ? weights[x] : 0);
      weight += weights[x];
      opaque += passing;
    }
    weight_ += std::uint64_t(weight);
    opaque_texels_ += std::uint64_t(opaque);
  }

  /// Adds samples a quarter of a texel off the texels' middles, towards the next row and both sides.
  void add_samples(const std::int16_t* row, const std::int16_t* beside, std::span<const std::int16_t> weights) {
    add_samples(row, beside, weights, -1);
    add_samples(row, beside, weights, 1);
  }

  [[nodiscard]] AlphaCoverage result() const {
    if (weight_ == 0) return {};
    const double texels = double(weight_), samples = kSamples * texels;
    const double seen = double(opaque_samples_) / samples;
    return {double(opaque_texels_) / texels, seen, seen + double(blended_) / (255 * kShares * samples)};
  }

 private:
  void add_samples(const std::int16_t* row, const std::int16_t* beside, std::span<const std::int16_t> weights,
                   std::ptrdiff_t side) {
    const auto opaque = std::int16_t(opaque_ * kShares), discard = std::int16_t(discard_ * kShares);
    constexpr std::size_t kBatch = 1024;  // Sums of this many fit 32 bits.
    for (std::size_t begin = 0; begin < weights.size(); begin += kBatch) {
      const std::size_t end = std::min(begin + kBatch, weights.size());
      const std::int16_t *to_side = row + side, *beside_to_side = beside + side;
      std::int32_t opaque_sum = 0, blended = 0;
      for (std::size_t x = begin; x < end; ++x) {
        const auto alpha = std::int16_t(9 * row[x] + 3 * (to_side[x] + beside[x]) + beside_to_side[x]);
        const auto solid_weight = std::int16_t(alpha >= opaque ? weights[x] : 0);
        const auto blended_alpha = std::int16_t(alpha >= discard && alpha < opaque ? alpha : 0);
        opaque_sum += solid_weight;
        blended += std::int32_t(weights[x]) * std::int32_t(blended_alpha);
      }
      opaque_samples_ += std::uint64_t(opaque_sum);
      blended_ += std::uint64_t(blended);
    }
  }

  std::int16_t opaque_, discard_;
  std::uint64_t weight_ = 0, opaque_texels_ = 0, opaque_samples_ = 0, blended_ = 0;
};

}  // namespace

AlphaPlane::AlphaPlane(const Image& image, std::uint32_t channel)
    : width(image.width), height(image.height), numbers(std::size_t(image.width + 2) * image.height) {
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::uint8_t* const texels = &image.texels[std::size_t(image.channels) * y * width];
    std::int16_t* const to = row(y);
    for (std::uint32_t x = 0; x < width; ++x) to[x] = texels[std::size_t(image.channels) * x + channel];
  }
  close_rows();
}

void AlphaPlane::close_rows() {
  if (width == 0) return;
  for (std::uint32_t y = 0; y < height; ++y) {
    std::int16_t* const texels = row(y);
    texels[-1] = texels[width - 1];
    texels[width] = texels[0];
  }
}

int least_passing(double threshold) { return int(std::clamp(std::ceil(threshold * 255 - kRounding), 0.0, 256.0)); }

AlphaCoverage alpha_coverage(const AlphaPlane& alpha, const AlphaPlane& used, const AlphaThresholds& thresholds) {
  Sums sums(thresholds);
  for (std::uint32_t y = 0; y < alpha.height; ++y) {
    const std::span weights(used.row(y), alpha.width);
    sums.add_texels(alpha.row(y), weights);
    sums.add_samples(alpha.row(y), alpha.row((y + alpha.height - 1) % alpha.height), weights);
    sums.add_samples(alpha.row(y), alpha.row((y + 1) % alpha.height), weights);
  }
  return sums.result();
}

AlphaCoverage alpha_coverage(const Image& image, const Image& used, const AlphaThresholds& thresholds) {
  return alpha_coverage(AlphaPlane(image, 3), AlphaPlane(used, 0), thresholds);
}

namespace {

Image used_by_finest(const Asset& asset, const TextureRecord& texture) {
  HairMesh hair;
  for (const VertexRecord& vertex : asset.vertices()) hair.uvs.emplace_back(vertex.uv[0], vertex.uv[1]);
  const auto indices = asset.lod_indices(0);
  hair.triangles.assign(indices.begin(), indices.end());
  return used_texels(hair, texture.width, texture.height);
}

}  // namespace

AlphaThresholds thresholds_in_texture(const MaterialRecord& material) {
  const double factor = double(material.base_color[3]);
  if (!(factor > 0)) return {2, 2};
  return {double(material.opaque_threshold) / factor, double(material.discard_threshold) / factor};
}

std::vector<AlphaCoverage> mip_coverage(const Asset& asset) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr || asset.material() == nullptr || asset.vertices().empty()) return {};
  const auto used = make_mips(used_by_finest(asset, *texture), kMaxImageSide, TexelMeaning::kNumbers);
  const AlphaThresholds thresholds = thresholds_in_texture(*asset.material());
  std::vector<AlphaCoverage> result;
  for (std::uint32_t level = 0; level < texture->mip_count; ++level) {
    Image mip{used[level].width, used[level].height, 4, {}};
    const auto texels = color_texels(asset, *texture, level);
    for (const auto texel : texels) mip.texels.push_back(std::uint8_t(texel));
    result.push_back(alpha_coverage(mip, used[level], thresholds));
  }
  return result;
}

}  // namespace coif::cook
