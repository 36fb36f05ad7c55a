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

/// How each alpha of a texture is drawn, 0..1; more than 1 where no alpha is.
struct AlphaThresholds {
  double opaque = 0;   ///< From here on texels are solid.
  double discard = 0;  ///< Below, not at all; between the two, blended.
};

/// The smallest alpha of 255 that passes. A threshold is a single-precision number in an asset, and may differ a little
/// from the texel's alpha.
[[nodiscard]] int least_passing(double threshold);

/// The part of a surface that an image's alpha covers, 0..1. "Seen" means as a sampler that filters between texels
/// finds it, at four places around the middle of each.
struct AlphaCoverage {
  double opaque = 0;       ///< Share of the texels that is solid.
  double seen_opaque = 0;  ///< Share of the surface that is.
  /// Mean share of the background that is hidden: 1 where solid, alpha where blended, 0 where discarded.
  double opacity = 0;
};

/// Each texel has the weight of `used` (one channel, the image's size); 0 where no texel counts.
[[nodiscard]] AlphaCoverage alpha_coverage(const Image& image, const Image& used, const AlphaThresholds& thresholds);

/// The material's thresholds, which are of the product of texel and factor, as alphas of texels.
[[nodiscard]] AlphaThresholds thresholds_in_texture(const MaterialRecord& material);

/// The coverage of each mip of an asset's base colour on the finest level of detail, largest mip first; empty without
/// that texture or a material.
[[nodiscard]] std::vector<AlphaCoverage> mip_coverage(const Asset& asset);

/// Gives every smaller mip the coverage of the largest: as many of the used texels pass the opaque threshold, and the
/// total share that is hidden, blended texels included, is the same. Box-filtered strands lose most of their opaque
/// texels in a few levels where they are thin, and gain some where they are dense; with distance hair would get bald or
/// fat. The order of alphas is kept: a texel that was more opaque than another still is. Texels of equal alpha are
/// ranked by the texels around them, then at random from a fixed seed, so that a level of one grey keeps its share too.
/// `used` has a mip for each.
///
/// Goes further than Castaño 2010, "Computing alpha mipmaps", which scales alpha by one factor.
void keep_alpha_coverage(std::span<Image> mips, std::span<const Image> used, const AlphaThresholds& thresholds);

/// Base colour of `contents` as images, largest mip first; empty without such a texture.
[[nodiscard]] std::vector<Image> base_color_mips(const AssetContents& contents);

/// base_color_mips() after keep_coverage() with this opaque threshold instead of the material's own.
[[nodiscard]] std::vector<Image> mips_for_threshold(std::span<const Image> used, const AssetContents& contents,
                                                    float opaque_threshold);

/// Gives the smaller mips of the base colour the coverage of the largest at the material's thresholds (see
/// keep_alpha_coverage()). This is the last change of the texels: until here all mips have averaged alpha, so the
/// threshold is chosen from the artist's own alpha. `used` has for each mip the texels that the hair shows; empty where
/// there is no texture.
void keep_coverage(std::span<const Image> used, AssetContents& contents);

/// Notes how near keep_coverage() came, and warns where hair will look thinner or fuller from afar.
void report_coverage(std::span<const Image> used, const AssetContents& contents, Findings& findings);

/// One channel of an image that repeats, for loops over neighbours: rows have one more number at either end.
struct AlphaPlane {
  AlphaPlane(const Image& image, std::uint32_t channel);

  [[nodiscard]] std::int16_t* row(std::uint32_t y) { return &numbers[std::size_t(y) * (width + 2) + 1]; }
  [[nodiscard]] const std::int16_t* row(std::uint32_t y) const { return &numbers[std::size_t(y) * (width + 2) + 1]; }
  /// Copies the last number of each row before its first, and the first after its last.
  void close_rows();

  std::uint32_t width, height;
  std::vector<std::int16_t> numbers;
};

/// As alpha_coverage() of an image.
[[nodiscard]] AlphaCoverage alpha_coverage(const AlphaPlane& alpha, const AlphaPlane& used,
                                           const AlphaThresholds& thresholds);

}  // namespace coif::cook
