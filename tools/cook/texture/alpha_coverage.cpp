#include "cook/texture/alpha.h"
#include "cook/texture/transparency.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr double kRounding = 1.0e-3;  ///< Of 255.
constexpr int kShares = 16;  ///< Of a sample: nine of its texel, three of two neighbours each, one of the third.
constexpr int kSamples = 4;  ///< Of a texel.

class Sums {
 public:
  explicit Sums(const AlphaThresholds& thresholds)
      : opaque_(least_passing(thresholds.opaque)), discard_(least_passing(thresholds.discard)) {}

  void add_texel(int alpha, std::uint64_t weight) {
    weight_ += weight;
    if (alpha >= opaque_) opaque_texels_ += weight;
  }

  /// `alpha` of kShares times 255.
  void add_sample(int alpha, std::uint64_t weight) {
    if (alpha >= opaque_ * kShares) {
      opaque_samples_ += weight;
    } else if (alpha >= discard_ * kShares) {
      blended_ += weight * std::uint64_t(alpha);
    }
  }

  [[nodiscard]] AlphaCoverage result() const {
    if (weight_ == 0) return {};
    const double texels = double(weight_), samples = kSamples * texels;
    const double seen = double(opaque_samples_) / samples;
    return {double(opaque_texels_) / texels, seen, seen + double(blended_) / (255 * kShares * samples)};
  }

 private:
  int opaque_, discard_;
  std::uint64_t weight_ = 0, opaque_texels_ = 0, opaque_samples_ = 0, blended_ = 0;
};

}  // namespace

int least_passing(double threshold) { return int(std::clamp(std::ceil(threshold * 255 - kRounding), 0.0, 256.0)); }

AlphaCoverage alpha_coverage(const Image& image, const Image& used, const AlphaThresholds& thresholds) {
  Sums sums(thresholds);
  const std::uint32_t width = image.width, height = image.height;
  const auto alpha = [&](std::uint32_t x, std::uint32_t y) {
    return int(image.texels[4 * (std::size_t(y) * width + x) + 3]);
  };
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::uint32_t beside_y[] = {y > 0 ? y - 1 : height - 1, y + 1 < height ? y + 1 : 0};
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint8_t weight = used.texels[std::size_t(y) * width + x];
      if (weight == 0) continue;
      const std::uint32_t beside_x[] = {x > 0 ? x - 1 : width - 1, x + 1 < width ? x + 1 : 0};
      sums.add_texel(alpha(x, y), weight);
      // A quarter of a texel off its middle, towards each corner.
      for (const std::uint32_t j : beside_y) {
        for (const std::uint32_t i : beside_x) {
          sums.add_sample(9 * alpha(x, y) + 3 * (alpha(i, y) + alpha(x, j)) + alpha(i, j), weight);
        }
      }
    }
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
