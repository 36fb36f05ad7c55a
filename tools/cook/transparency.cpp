#include "cook/transparency.h"

#include "cook/opaque_threshold.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif {
namespace {

/// Of the texels that the hair uses; where an opaque material has more of them clear, its author may not have meant it.
constexpr double kManyClearTexels = 0.02;

double share_from(const AlphaHistogram& histogram, double alpha) {
  const double total = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  const auto first = std::ptrdiff_t(std::ceil(std::clamp(alpha, 0.0, 1.0) * 255));
  return total > 0 ? std::accumulate(histogram.begin() + first, histogram.end(), 0.0) / total : 1;
}

Transparency as_opaque(const AlphaHistogram& histogram) {
  Transparency result;
  result.ignores_alpha = true;
  result.notes.push_back("opaque threshold 0: the material is opaque");
  const double clear = 1 - share_from(histogram, 0.5);
  if (clear > kManyClearTexels) {
    result.warnings.push_back(fmt::format(
        "the material is opaque, but {:.0f} % of the texels that the hair uses have alpha below 0.5; to use it, export "
        "the material as blended or set \"material.opaque_threshold\"",
        100 * clear));
  }
  return result;
}

Transparency as_mask(double cutoff) {
  Transparency result;
  result.opaque_threshold = result.discard_threshold = std::clamp(cutoff, 0.0, 1.0);
  result.notes.push_back(
      fmt::format("opaque threshold {:.2f}: the material's alpha cutoff; nothing is blended", result.opaque_threshold));
  return result;
}

Transparency as_recipe_says(const AlphaHistogram& histogram, const Recipe& recipe) {
  Transparency result;
  result.opaque_threshold = recipe.opaque_threshold;
  result.discard_threshold = recipe.discard_threshold;
  const double drawn = share_from(histogram, recipe.discard_threshold);
  const double opaque = share_from(histogram, recipe.opaque_threshold);
  if (opaque < kFewOpaque * drawn) {
    result.warnings.push_back(
        fmt::format("only {:.1f} % of the hair's texels have alpha {} or more: without an opaque core hair "
                    "sorts badly; lower \"material.opaque_threshold\" or paint opaque cores",
                    100 * opaque / drawn, recipe.opaque_threshold));
  }
  return result;
}

Transparency as_painted(const AlphaHistogram& histogram, const Recipe& recipe) {
  const OpaqueThreshold chosen = choose_opaque_threshold(histogram, recipe.discard_threshold);
  Transparency result;
  result.opaque_threshold = chosen.value;
  result.discard_threshold = std::min(recipe.discard_threshold, chosen.value);
  result.notes.push_back(fmt::format("opaque threshold {:.2f}: {}; {:.0f} % of the hair's texels are opaque",
                                     chosen.value, chosen.reason, 100 * chosen.opaque_share));
  if (chosen.opaque_share < kFewOpaque) {
    result.warnings.push_back(
        fmt::format("only {:.1f} % of the hair's texels have alpha {:.2f} or more: without an "
                    "opaque core hair sorts badly; paint opaque cores",
                    100 * chosen.opaque_share, chosen.value));
  }
  return result;
}

}  // namespace

Transparency choose_transparency(const BaseColor& color, const Image* image, const Image& used, const Recipe& recipe) {
  const double factor = std::clamp(double(color.factor.w()) * recipe.base_color[3], 0.0, 1.0);
  AlphaHistogram histogram{};
  if (image != nullptr) histogram = alpha_histogram(*image, used, factor);
  if (image == nullptr) histogram[std::size_t(std::lround(factor * 255))] = 1;
  if (recipe.opaque_threshold > 0) return as_recipe_says(histogram, recipe);
  if (color.alpha_use == AlphaUse::kOpaque) return as_opaque(histogram);
  if (color.alpha_use == AlphaUse::kMask) return as_mask(color.alpha_cutoff);
  return as_painted(histogram, recipe);
}

}  // namespace coif
