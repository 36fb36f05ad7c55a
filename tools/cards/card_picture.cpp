#include "cards/hair_picture.h"

#include "base/parallel_for.h"
#include "cards/surface_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace coif::cards {
namespace {

constexpr std::uint32_t kCardBand = 8;

/// A card's values at a sample.
struct Fragment {
  std::uint32_t sample = 0;
  float depth = 0, opacity = 0, shade = 0;
};

/// The sine of the angle between the strand of a texel and the line of sight.
float shade_at(const CardSurface& surface, const PictureFrame& frame, const SurfacePoint& point) {
  const Eigen::Vector2f on_card =
      surface.direction.empty() ? Eigen::Vector2f(0, 1) : bilinear(surface, surface.direction, point.uv);
  const Eigen::Vector3f along = frame.axes * (on_card.x() * point.across + on_card.y() * point.along);
  return along.squaredNorm() > 0 ? shade_of(along.normalized()) : 1.0f;
}

/// Fragments of one band's samples, in the order of the triangles. Mips are those of pixels with `side` x `side`
/// samples.
std::vector<Fragment> fragments_of(const CardSurface& surface, const PictureFrame& frame, const SampleRows& rows,
                                   std::span<const std::uint32_t> triangles, std::uint32_t side) {
  std::vector<Fragment> fragments;
  for (const std::uint32_t triangle : triangles) {
    const bool has_mips = !surface.smaller_opacity.empty();
    const float level =
        has_mips ? std::log2(float(side) * SeenTriangle(surface, frame, triangle).texels_of_pixel(surface)) : 0.0f;
    for_each_sample(surface, frame, rows, triangle, [&](std::uint32_t x, std::uint32_t y, const SurfacePoint& point) {
      const float found = opacity_at(surface, point.uv, level);
      if (!(found > 0) || found < surface.discard_below) return;
      const float opacity = found >= surface.opaque_from ? 1.0f : found;
      fragments.push_back({(y - rows.first) * rows.width + x, point.depth, opacity, shade_at(surface, frame, point)});
    });
  }
  return fragments;
}

/// Sorts by sample, and front to back within each; at one depth the order stays. Counting groups the fragments of a
/// sample, of which there are few; one sort over all takes longer.
std::vector<Fragment> sorted(const std::vector<Fragment>& fragments, std::size_t samples) {
  std::vector<std::uint32_t> end(samples + 1, 0);
  for (const Fragment& fragment : fragments) ++end[fragment.sample + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  const std::vector<std::uint32_t> begin = end;
  std::vector<Fragment> out(fragments.size());
  for (const Fragment& fragment : fragments) {
    std::uint32_t at = end[fragment.sample]++;
    for (; at > begin[fragment.sample] && fragment.depth < out[at - 1].depth; --at) out[at] = out[at - 1];
    out[at] = fragment;
  }
  return out;
}

/// The sum of all fragments of one sample.
struct SampleSum {
  float coverage = 0, shade = 0;
  float depth = std::numeric_limits<float>::infinity();
};

SampleSum sum_of(std::span<const Fragment> fragments) {
  SampleSum sum;
  float clear = 1;
  for (const Fragment& fragment : fragments) {
    sum.shade += clear * fragment.opacity * fragment.shade;
    clear *= 1 - fragment.opacity;
    if (clear <= 0.5f) sum.depth = std::min(sum.depth, fragment.depth);
  }
  sum.coverage = 1 - clear;
  return sum;
}

void develop_pixel(std::span<const SampleSum> sums, std::size_t at, HairPicture& picture) {
  float coverage = 0, shade = 0, depth = 0;
  int deep = 0;
  for (const SampleSum& sum : sums) {
    coverage += sum.coverage;
    shade += sum.shade;
    if (!std::isfinite(sum.depth)) continue;
    depth += sum.depth;
    ++deep;
  }
  picture.coverage[at] = coverage / float(sums.size());
  picture.shade[at] = shade / float(sums.size());
  if (deep > 0) picture.depth[at] = depth / float(deep);
}

void develop_band(std::span<const Fragment> fragments, const SampleRows& rows, std::uint32_t side,
                  HairPicture& picture) {
  const std::uint32_t pixel_rows = rows.count / side, first = rows.first / side;
  const std::size_t samples_of_pixel = std::size_t(side) * side;
  std::vector<SampleSum> sums(std::size_t(rows.width) * rows.count);
  for (std::size_t begin = 0, end = 0; begin < fragments.size(); begin = end) {
    while (end < fragments.size() && fragments[end].sample == fragments[begin].sample) ++end;
    const std::uint32_t sample = fragments[begin].sample, x = sample % rows.width, y = sample / rows.width;
    // Fragments of a pixel are processed together.
    const std::size_t pixel = std::size_t(y / side) * picture.size + x / side;
    sums[pixel * samples_of_pixel + (y % side) * side + x % side] = sum_of(fragments.subspan(begin, end - begin));
  }
  for (std::size_t pixel = 0; pixel < std::size_t(pixel_rows) * picture.size; ++pixel) {
    develop_pixel(std::span(sums).subspan(pixel * samples_of_pixel, samples_of_pixel),
                  std::size_t(first) * picture.size + pixel, picture);
  }
}

}  // namespace

HairPicture draw_cards(const CardSurface& surface, const PictureFrame& frame, const platform::Threads& threads,
                       std::uint32_t side) {
  HairPicture picture = blank_picture(frame.size);
  const PictureFrame fine = finer(frame, int(side));
  const auto bands = triangles_by_band(surface, fine, kCardBand * side);
  parallel_for(bands.size(), threads, [&](std::size_t b) {
    const auto first = std::uint32_t(b * kCardBand), count = std::min(kCardBand, frame.size - first);
    const SampleRows rows{fine.size, first * side, count * side};
    const auto fragments = fragments_of(surface, fine, rows, bands[b], side);
    develop_band(sorted(fragments, std::size_t(rows.width) * rows.count), rows, side, picture);
  });
  return picture;
}

HairLikeness compare_hair(const HairPicture& wanted, const HairPicture& seen) {
  double both = 0, either = 0, squares = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < wanted.coverage.size(); ++i) {
    both += double(std::min(wanted.coverage[i], seen.coverage[i]));
    either += double(std::max(wanted.coverage[i], seen.coverage[i]));
    if (!(wanted.coverage[i] > 0 || seen.coverage[i] > 0)) continue;
    const double difference = double(wanted.shade[i]) - double(seen.shade[i]);
    squares += difference * difference;
    ++covered;
  }
  if (covered == 0) return {};
  return {both / either, std::sqrt(squares / double(covered))};
}

SurfaceCost cost_of(const CardSurface& surface, const PictureFrame& frame) {
  std::vector<std::uint8_t> is_met(std::size_t(frame.size) * frame.size, 0);
  std::size_t fragments = 0;
  const SampleRows all{frame.size, 0, frame.size};
  for (std::uint32_t t = 0; 3 * std::size_t(t) < surface.triangles.size(); ++t) {
    for_each_sample(surface, frame, all, t, [&](std::uint32_t x, std::uint32_t y, const SurfacePoint&) {
      ++fragments;
      is_met[std::size_t(y) * frame.size + x] = 1;
    });
  }
  const auto met = std::ranges::count(is_met, std::uint8_t{1});
  return {double(fragments), met > 0 ? double(fragments) / double(met) : 0.0};
}

double psnr_db(double error) { return error > 1e-5 ? -20 * std::log10(error) : 100; }

std::vector<std::vector<std::uint32_t>> triangles_by_band(const CardSurface& surface, const PictureFrame& frame,
                                                          std::uint32_t rows) {
  std::vector<std::vector<std::uint32_t>> bands((frame.size + rows - 1) / rows);
  for (std::uint32_t t = 0; 3 * std::size_t(t) < surface.triangles.size(); ++t) {
    const SeenTriangle seen(surface, frame, t);
    if (!seen.is_seen()) continue;
    const auto box = seen.box_within({frame.size, 0, frame.size});
    if (box.left > box.right) continue;
    for (int y = box.top; y <= box.bottom;) {
      const auto band = std::uint32_t(y) / rows;
      bands[band].push_back(t);
      y = int((band + 1) * rows);
    }
  }
  return bands;
}

}  // namespace coif::cards
