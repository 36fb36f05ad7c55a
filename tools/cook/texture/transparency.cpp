#include "cook/texture/transparency.h"

#include "cook/recipe/drawn_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace coif::cook {
namespace {

/// Share of the texels that the hair uses: an opaque material with more clear ones may be a mistake of its author.
constexpr double kManyClearTexels = 0.02;

double share_from(const AlphaHistogram& histogram, double alpha) {
  const double total = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  const auto first = std::ptrdiff_t(std::ceil(std::clamp(alpha, 0.0, 1.0) * 255));
  return total > 0 ? std::accumulate(histogram.begin() + first, histogram.end(), 0.0) / total : 1;
}

Transparency as_opaque(const AlphaHistogram& histogram, Findings& findings) {
  Transparency result;
  result.ignores_alpha = true;
  findings.note("opaque threshold 0: the material is opaque");
  const double clear = 1 - share_from(histogram, 0.5);
  if (clear > kManyClearTexels) {
    findings.warn("C142", fmt::format("the material is opaque, but {:.0f} % of the texels that the hair uses have "
                                      "alpha below 0.5; to use it, export "
                                      "the material as blended or set \"material.opaque_threshold\"",
                                      100 * clear));
  }
  return result;
}

Transparency as_mask(double cutoff, Findings& findings) {
  Transparency result;
  result.opaque_threshold = result.discard_threshold = std::clamp(cutoff, 0.0, 1.0);
  findings.note(
      fmt::format("opaque threshold {:.2f}: the material's alpha cutoff; nothing is blended", result.opaque_threshold));
  return result;
}

Transparency as_recipe_says(const AlphaHistogram& histogram, const DrawnRecipe& recipe, Findings& findings) {
  Transparency result;
  result.opaque_threshold = recipe.opaque_threshold;
  result.discard_threshold = recipe.discard_threshold;
  const double drawn = share_from(histogram, recipe.discard_threshold);
  const double opaque = share_from(histogram, recipe.opaque_threshold);
  if (opaque < kFewOpaque * drawn) {
    findings.warn("C143",
                  fmt::format("only {:.1f} % of the hair's texels have alpha {} or more: without an opaque core hair "
                              "sorts badly; lower \"material.opaque_threshold\" or paint opaque cores",
                              100 * opaque / drawn, recipe.opaque_threshold));
  }
  return result;
}

Transparency as_painted(const AlphaHistogram& histogram, const DrawnRecipe& recipe, Findings& findings) {
  const OpaqueThreshold chosen = choose_opaque_threshold(histogram, recipe.discard_threshold);
  Transparency result;
  result.opaque_threshold = chosen.value;
  result.discard_threshold = std::min(recipe.discard_threshold, chosen.value);
  findings.note(fmt::format("opaque threshold {:.2f}: {}; {:.0f} % of the hair's texels are opaque", chosen.value,
                            chosen.reason, 100 * chosen.opaque_share));
  if (chosen.opaque_share < kFewOpaque) {
    findings.warn("C143", fmt::format("only {:.1f} % of the hair's texels have alpha {:.2f} or more: without an "
                                      "opaque core hair sorts badly; paint opaque cores",
                                      100 * chosen.opaque_share, chosen.value));
  }
  return result;
}

}  // namespace

Transparency choose_transparency(const BaseColor& color, const Image* image, const Image& used,
                                 const DrawnRecipe& recipe, Findings& findings) {
  const double factor = std::clamp(double(color.factor.w()) * recipe.base_color[3], 0.0, 1.0);
  AlphaHistogram histogram{};
  if (image != nullptr) histogram = alpha_histogram(*image, used, factor);
  if (image == nullptr) histogram[std::size_t(std::lround(factor * 255))] = 1;
  if (recipe.opaque_threshold > 0) return as_recipe_says(histogram, recipe, findings);
  if (color.alpha_use == importer::AlphaUse::kOpaque) return as_opaque(histogram, findings);
  if (color.alpha_use == importer::AlphaUse::kMask) return as_mask(color.alpha_cutoff, findings);
  return as_painted(histogram, recipe, findings);
}

namespace {

constexpr int kLowest = 128;   ///< 0.5: half transparent texels drawn as solid are the worst edge to accept.
constexpr int kHighest = 242;  ///< 0.95.
constexpr int kSmoothing = 6;  ///< Texels of one painted alpha spread about this far by filtering and compression.
constexpr double kFootShare = 0.25;  ///< Share of the mode's height; texels below it do not belong to the core.
constexpr double kModeShare = 0.1;   ///< Share of the drawn texels within the mode's width; fewer are no core.
constexpr double kWantedOpaque = 0.25;
constexpr int kSolid = 250;  ///< An alpha from here on was probably solid before lossy compression.

/// Mean over the bins within kSmoothing; at the ends over existing ones.
AlphaHistogram smoothed(const AlphaHistogram& histogram) {
  AlphaHistogram result{};
  for (int bin = 0; bin < 256; ++bin) {
    const int first = std::max(0, bin - kSmoothing), last = std::min(255, bin + kSmoothing);
    result[std::size_t(bin)] = std::accumulate(&histogram[std::size_t(first)], &histogram[std::size_t(last)] + 1, 0.0) /
                               double(last - first + 1);
  }
  return result;
}

double share_from(const AlphaHistogram& histogram, int bin, double total) {
  return std::accumulate(histogram.begin() + bin, histogram.end(), 0.0) / total;
}

/// The uppermost local maximum of at least half alpha that holds enough texels; -1 without one.
int find_core(const AlphaHistogram& smooth, double total) {
  for (int bin = 255; bin >= kLowest; --bin) {
    const double here = smooth[std::size_t(bin)];
    const int first = std::max(0, bin - kSmoothing), last = std::min(255, bin + kSmoothing);
    const bool highest = std::all_of(&smooth[std::size_t(first)], &smooth[std::size_t(last)] + 1,
                                     [&](double other) { return other <= here; });
    if (highest && here * (last - first + 1) >= kModeShare * total) return bin;
  }
  return -1;
}

int find_foot(const AlphaHistogram& smooth, int core) {
  int foot = core;
  while (foot > kLowest && smooth[std::size_t(foot - 1)] >= kFootShare * smooth[std::size_t(core)] &&
         // Rising again: the mode below begins.
         smooth[std::size_t(foot - 1)] <= smooth[std::size_t(foot)]) {
    --foot;
  }
  return foot;
}

}  // namespace

AlphaHistogram alpha_histogram(const Image& image, const Image& used, double factor) {
  AlphaHistogram histogram{};
  for (std::size_t i = 0; i < image.texel_count(); ++i) {
    if (used.texels[i] == 0) continue;
    const double alpha = image.texels[4 * i + 3] * std::clamp(factor, 0.0, 1.0);
    histogram[std::size_t(std::lround(alpha))] += used.texels[i] / 255.0;
  }
  return histogram;
}

OpaqueThreshold choose_opaque_threshold(const AlphaHistogram& histogram, double discard) {
  AlphaHistogram drawn = histogram;
  const int faintest = std::clamp(int(std::ceil(discard * 255)), 1, 255);
  std::fill_n(drawn.begin(), faintest, 0.0);
  const double total = std::accumulate(drawn.begin(), drawn.end(), 0.0);
  const double hidden = std::accumulate(histogram.begin(), histogram.end(), 0.0) - total;
  const double solid = std::accumulate(drawn.begin() + kSolid, drawn.end(), 0.0);
  if (hidden <= 0 && solid >= total) return {0, 1, "nothing is transparent"};
  if (total <= 0) return {kHighest / 255.0, 0, "nothing is visible"};

  const AlphaHistogram smooth = smoothed(drawn);
  const int core = find_core(smooth, total);
  int bin = core < 0 ? kHighest : std::min(find_foot(smooth, core), kHighest);
  const bool enough = share_from(drawn, bin, total) >= kWantedOpaque;
  while (bin > kLowest && share_from(drawn, bin, total) < kWantedOpaque) --bin;
  const std::string reason = core < 0 ? "no opaque core stands out, so as low as a quarter of the texels asks for"
                             : enough ? fmt::format("the foot of the opaque core around alpha {:.2f}", core / 255.0)
                                      : "lower than the small opaque core, so that a quarter of the texels is opaque";
  return {bin / 255.0, share_from(drawn, bin, total), reason};
}

namespace {

using Eigen::Vector2d;
using Corners = std::array<Vector2d, 3>;  ///< In texels.

/// A triangle that repeats the texture this often shows all of it, whatever its shape.
constexpr double kManyRepeats = 4;

struct Range {
  double low = INFINITY;
  double high = -INFINITY;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// The part of the triangle between the rows `top` and `top + 1`; empty (low > high) where there is none.
Range columns_in_row(const Corners& corners, double top) {
  Range range;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d &a = corners[k], &b = corners[(k + 1) % 3];
    if (a.y() >= top && a.y() <= top + 1) range.include(a.x());
    for (const double line : {top, top + 1}) {
      if (std::min(a.y(), b.y()) > line || std::max(a.y(), b.y()) < line || a.y() == b.y()) continue;
      range.include(a.x() + (b.x() - a.x()) * (line - a.y()) / (b.y() - a.y()));
    }
  }
  return range;
}

std::uint32_t wrapped(double coordinate, std::uint32_t size) {
  return std::min(std::uint32_t(coordinate - std::floor(coordinate / size) * size), size - 1);
}

/// The texel behind the last that a part from `low` to `high` shows: one that ends where a texel begins shows nothing
/// of that texel.
double end_of_texels(double low, double high) { return std::max(std::ceil(high), std::floor(low) + 1); }

void mark_row(double low, double high, std::uint32_t y, Image& used) {
  std::uint8_t* row = &used.texels[std::size_t(y) * used.width];
  const auto count = std::uint32_t(std::min<double>(end_of_texels(low, high) - std::floor(low), used.width));
  const std::uint32_t first = wrapped(std::floor(low), used.width);
  const std::uint32_t to_end = std::min(count, used.width - first);
  std::fill_n(row + first, to_end, std::uint8_t{255});
  std::fill_n(row, count - to_end, std::uint8_t{255});  // The part that continues from the other side.
}

/// Returns false once no other triangle can add to the used texels: broken files repeat a large texture in every
/// triangle.
bool mark_triangle(const Corners& corners, Image& used) {
  Range x, y;
  for (const Vector2d& corner : corners) {
    if (!corner.allFinite()) return true;
    x.include(corner.x());
    y.include(corner.y());
  }
  if (x.high - x.low > kManyRepeats * used.width || y.high - y.low > kManyRepeats * used.height) {
    std::ranges::fill(used.texels, std::uint8_t{255});
    return false;
  }
  for (double row = std::floor(y.low), end = end_of_texels(y.low, y.high); row < end; ++row) {
    const Range columns = columns_in_row(corners, row);
    if (columns.low <= columns.high) mark_row(columns.low, columns.high, wrapped(row, used.height), used);
  }
  return true;
}

}  // namespace

Image used_texels(const HairMesh& hair, std::uint32_t width, std::uint32_t height) {
  Image used{width, height, 1, std::vector<std::uint8_t>(std::size_t(width) * height, 0)};
  if (hair.uvs.empty()) return used;
  const Vector2d size(width, height);
  for (std::size_t t = 0; t < hair.triangles.size(); t += 3) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = hair.uvs[hair.triangles[t + k]].cast<double>().cwiseProduct(size);
    }
    if (!mark_triangle(corners, used)) break;
  }
  return used;
}

}  // namespace coif::cook
