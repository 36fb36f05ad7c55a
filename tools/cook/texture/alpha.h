#pragma once

#include "cook/recipe/findings.h"
#include "cook/texture/image.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cook {

/// Which alphas of a texture are drawn how, 0..1; more than 1 where none is.
struct AlphaThresholds {
  double opaque = 0;   ///< From here on as solid.
  double discard = 0;  ///< Below, not at all; between the two, blended.
};

/// The least alpha of 255 that passes; a threshold is a single-precision number in an asset, and may lie a little
/// beside the texel's own.
[[nodiscard]] int least_passing(double threshold);

/// What an image's alpha covers of the surface that shows it, 0..1. "Seen" is what a sampler finds that filters between
/// texels, at four places around the middle of each.
struct AlphaCoverage {
  double opaque = 0;       ///< Share of the texels that is solid.
  double seen_opaque = 0;  ///< Share of the surface that is.
  double opacity =
      0;  ///< Mean of what is hidden behind, as seen: 1 where solid, alpha where blended, 0 where discarded.
};

/// Each texel counts as much as `used` says (one channel, the image's size); 0 where none counts.
[[nodiscard]] AlphaCoverage alpha_coverage(const Image& image, const Image& used, const AlphaThresholds& thresholds);

/// The material's thresholds, which are of the product of texel and factor, as alphas of texels.
[[nodiscard]] AlphaThresholds thresholds_in_texture(const MaterialRecord& material);

/// What each mip of an asset's base colour covers of the finest level of detail, largest mip first; empty without that
/// texture or a material.
[[nodiscard]] std::vector<AlphaCoverage> mip_coverage(const Asset& asset);

/// Gives every smaller mip the coverage of the largest: as many of the used texels pass the opaque threshold, and
/// what is hidden in all, blended texels included, is the same. Box-filtered strands lose most of their opaque texels
/// in a few levels where they are thin, and gain some where they are dense; hair would get bald or fat with distance.
/// Alpha keeps its order: what was more opaque than another texel still is. Texels of equal alpha differ by those
/// around them, then by chance from a fixed seed, so that a level of one grey keeps its share too. `used` has a mip
/// for each.
///
/// Goes further than Castaño 2010, "Computing alpha mipmaps", which scales alpha by one factor.
void keep_alpha_coverage(std::span<Image> mips, std::span<const Image> used, const AlphaThresholds& thresholds);

/// Base colour of `contents` as images, largest mip first; empty without such a texture.
[[nodiscard]] std::vector<Image> base_color_mips(const AssetContents& contents);

/// Those as keep_coverage() would leave them with this opaque threshold instead of the material's own.
[[nodiscard]] std::vector<Image> mips_for_threshold(std::span<const Image> used, const AssetContents& contents,
                                                    float opaque_threshold);

/// Gives the smaller mips of the base colour the coverage that the largest has at the material's thresholds (see
/// keep_alpha_coverage()). The last thing done to the texels: until here all mips have plainly averaged alpha, and
/// whoever chooses the threshold sees what the artist painted. `used` says for each mip which texels the hair shows;
/// empty where there is no texture.
void keep_coverage(std::span<const Image> used, AssetContents& contents);

/// Notes how near keep_coverage() came, and warns where hair will look thinner or fuller from afar.
void report_coverage(std::span<const Image> used, const AssetContents& contents, Findings& findings);

/// One channel of an image that repeats, for loops over neighbours: rows with one number more at either end.
struct AlphaPlane {
  AlphaPlane(const Image& image, std::uint32_t channel);

  [[nodiscard]] std::int16_t* row(std::uint32_t y) { return &numbers[std::size_t(y) * (width + 2) + 1]; }
  [[nodiscard]] const std::int16_t* row(std::uint32_t y) const { return &numbers[std::size_t(y) * (width + 2) + 1]; }
  /// Puts the last number of each row before its first, and the first behind its last.
  void close_rows();

  std::uint32_t width, height;
  std::vector<std::int16_t> numbers;
};

/// As that of images.
[[nodiscard]] AlphaCoverage alpha_coverage(const AlphaPlane& alpha, const AlphaPlane& used,
                                           const AlphaThresholds& thresholds);

}  // namespace coif::cook
