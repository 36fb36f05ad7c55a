#include "cook/texture/alpha.h"
#include "cook/texture/transparency.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace coif {
namespace {

constexpr double kRounding = 1.0e-3;  ///< Of 255.
constexpr std::uint16_t kShares =
    16;                      ///< Of a sample: nine of its texel, three of two neighbours each, one of the third.
constexpr int kSamples = 4;  ///< Of a texel.

/// Alphas of a row of texels, and of those beside it: the last one before the first, and the first after the last.
using AlphaRow = std::vector<std::uint16_t>;

AlphaRow alpha_row(const Image& image, std::uint32_t y) {
  AlphaRow row(image.width + 2);
  const std::uint8_t* const texels = &image.texels[4 * std::size_t(y) * image.width];
  for (std::uint32_t x = 0; x < image.width; ++x) row[x + 1] = texels[4 * std::size_t(x) + 3];
  row.front() = row[image.width];
  row.back() = row[1];
  return row;
}

class Sums {
 public:
  explicit Sums(const AlphaThresholds& thresholds)
      : opaque_(std::uint16_t(least_passing(thresholds.opaque))),
        discard_(std::uint16_t(least_passing(thresholds.discard))) {}

  void add_texels(const AlphaRow& row, const std::uint8_t* weights) {
    std::uint32_t weight = 0, opaque = 0;
    for (std::size_t x = 0; x + 2 < row.size(); ++x) {
      weight += weights[x];
      opaque += row[x + 1] >= opaque_ ? weights[x] : 0u;
    }
    weight_ += weight;
    opaque_texels_ += opaque;
  }

  /// Samples a quarter of a texel off the texels' middles, towards the row beside and both sides.
  void add_samples(const AlphaRow& row, const AlphaRow& beside, const std::uint8_t* weights) {
    add_samples(row, beside, weights, 0);
    add_samples(row, beside, weights, 2);
  }

  [[nodiscard]] AlphaCoverage result() const {
    if (weight_ == 0) return {};
    const double texels = double(weight_), samples = kSamples * texels;
    const double seen = double(opaque_samples_) / samples;
    return {double(opaque_texels_) / texels, seen, seen + double(blended_) / (255 * kShares * samples)};
  }

 private:
  /// In a plain loop of small numbers, which compilers make vector operations of.
  void add_samples(const AlphaRow& row, const AlphaRow& beside, const std::uint8_t* weights, std::size_t side) {
    const auto opaque = std::uint16_t(opaque_ * kShares), discard = std::uint16_t(discard_ * kShares);
    std::uint32_t opaque_sum = 0;
    std::uint64_t blended = 0;
    constexpr std::size_t kBatch = 1024;  // sums of so many fit 32 bits
    for (std::size_t begin = 0; begin + 2 < row.size(); begin += kBatch) {
      const std::size_t end = std::min(begin + kBatch, row.size() - 2);
      std::uint32_t batch = 0;
      for (std::size_t x = begin; x < end; ++x) {
        const auto alpha = std::uint16_t(9 * row[x + 1] + 3 * (row[x + side] + beside[x + 1]) + beside[x + side]);
        const bool is_opaque = alpha >= opaque, is_drawn = alpha >= discard;
        opaque_sum += is_opaque ? weights[x] : 0u;
        batch += is_drawn && !is_opaque ? std::uint32_t(weights[x]) * alpha : 0u;
      }
      blended += batch;
    }
    opaque_samples_ += opaque_sum;
    blended_ += blended;
  }

  std::uint16_t opaque_, discard_;
  std::uint64_t weight_ = 0, opaque_texels_ = 0, opaque_samples_ = 0, blended_ = 0;
};

}  // namespace

int least_passing(double threshold) { return int(std::clamp(std::ceil(threshold * 255 - kRounding), 0.0, 256.0)); }

AlphaCoverage alpha_coverage(const Image& image, const Image& used, const AlphaThresholds& thresholds) {
  Sums sums(thresholds);
  const std::uint32_t height = image.height;
  if (height == 0) return {};
  AlphaRow above = alpha_row(image, height - 1), row = alpha_row(image, 0);
  for (std::uint32_t y = 0; y < height; ++y) {
    AlphaRow below = alpha_row(image, (y + 1) % height);
    const std::uint8_t* const weights = &used.texels[std::size_t(y) * image.width];
    sums.add_texels(row, weights);
    sums.add_samples(row, above, weights);
    sums.add_samples(row, below, weights);
    above = std::exchange(row, std::move(below));
  }
  return sums.result();
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
    const auto texels = asset.texels(*texture, level);
    for (const auto texel : texels) mip.texels.push_back(std::uint8_t(texel));
    result.push_back(alpha_coverage(mip, used[level], thresholds));
  }
  return result;
}

}  // namespace coif
