#include "report/order/measure_order.h"

#include "lab/rig.h"
#include "report/order/drawn_way.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace coif::report {
namespace {

constexpr std::size_t kChannels = 4;
constexpr std::size_t kAlpha = 3;
constexpr double kOne = 255;

int difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::size_t at) {
  return std::abs(int(a[at]) - int(b[at]));
}

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

PictureError& PictureError::operator+=(const PictureError& other) {
  squared += other.squared;
  pixels += other.pixels;
  bad += other.bad;
  return *this;
}

double PictureError::rmse() const { return pixels == 0 ? 0 : std::sqrt(squared / double(pixels)); }

double PictureError::psnr_db() const {
  const double error = rmse();
  return error > 0 ? std::min(-20 * std::log10(error), kEqualDb) : kEqualDb;
}

PictureError picture_error(std::span<const std::uint8_t> exact, std::span<const std::uint8_t> other) {
  PictureError error;
  for (std::size_t pixel = 0; pixel < exact.size(); pixel += kChannels) {
    if (exact[pixel + kAlpha] == 0) continue;
    int squared = 0, largest = 0;
    for (std::size_t c = 0; c < kAlpha; ++c) {
      const int d = difference(exact, other, pixel + c);
      squared += d * d;
      largest = std::max(largest, d);
    }
    error.squared += squared / (double(kAlpha) * kOne * kOne);
    error.pixels += 1;
    error.bad += largest > kBadDifference * kOne ? 1 : 0;
  }
  return error;
}

double largest_difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, difference(a, b, i));
  return largest / kOne;
}

OrderError sum_up(std::span<const PictureError> views) {
  OrderError summed;
  PictureError all;
  for (const PictureError& view : views) {
    all += view;
    summed.view_psnr_db.push_back(view.psnr_db());
  }
  if (views.empty()) return summed;
  summed.psnr_db = all.psnr_db();
  summed.rmse = all.rmse();
  summed.median_psnr_db = median_of(summed.view_psnr_db);
  summed.worst_psnr_db = *std::ranges::min_element(summed.view_psnr_db);
  summed.bad_pixels_pct = all.pixels == 0 ? 0 : 100 * double(all.bad) / double(all.pixels);
  return summed;
}

PictureError excess_change(std::span<const std::uint8_t> exact_before, std::span<const std::uint8_t> exact_after,
                           std::span<const std::uint8_t> before, std::span<const std::uint8_t> after) {
  PictureError change;
  for (std::size_t pixel = 0; pixel < exact_before.size(); pixel += kChannels) {
    if (exact_before[pixel + kAlpha] == 0 && exact_after[pixel + kAlpha] == 0) continue;
    int squared = 0;
    for (std::size_t c = 0; c < kAlpha; ++c) {
      const int excess = difference(before, after, pixel + c) - difference(exact_before, exact_after, pixel + c);
      squared += excess > 0 ? excess * excess : 0;
    }
    change.squared += squared / (double(kAlpha) * kOne * kOne);
    change.pixels += 1;
  }
  return change;
}

double mean_coverage(std::span<const std::uint8_t> pixels) {
  double sum = 0;
  for (std::size_t pixel = 0; pixel < pixels.size(); pixel += kChannels) sum += pixels[pixel + kAlpha];
  return pixels.empty() ? 0 : sum / (kOne * double(pixels.size() / kChannels));
}

std::vector<std::uint8_t> side_by_side(std::span<const std::uint8_t> exact, std::span<const std::uint8_t> other,
                                       std::uint32_t width) {
  constexpr int kMagnified = 4;  // differences that a reader should see are mostly some hundredths
  const std::size_t row = kChannels * width;
  std::vector<std::uint8_t> joined(3 * exact.size(), 255);
  for (std::size_t at = 0; at < exact.size(); ++at) {
    if (at % kChannels == kAlpha) continue;
    const std::size_t to = at / row * 3 * row + at % row;
    joined[to] = exact[at];
    joined[to + row] = other[at];
    const bool is_hair = exact[at / kChannels * kChannels + kAlpha] > 0;
    joined[to + 2 * row] = std::uint8_t(is_hair ? std::min(kMagnified * difference(exact, other, at), 255) : 0);
  }
  return joined;
}

namespace {

constexpr double kOrbitPitch = 5;
constexpr std::uint32_t kOrbitDivisor = 2;  // A quarter of the pixels shows popping as well.

/// A way's pictures so far, and the worst of them.
struct Running {
  std::vector<PictureError> errors;
  double worst_db = std::numeric_limits<double>::infinity();
  ViewAngle worst_view;
  render::Picture worst, worst_exact;

  void add(const PictureError& error, const ViewAngle& view, const render::Picture& exact, render::Picture& picture) {
    errors.push_back(error);
    if (error.psnr_db() >= worst_db) return;
    worst_db = error.psnr_db();
    worst_view = view;
    worst = std::move(picture);
    worst_exact = exact;
  }

  [[nodiscard]] WayComparison comparison(const std::string& way, const std::string& pose) const {
    WayComparison result{sum_up(errors), {way, pose, worst_view.yaw_degrees, worst_view.pitch_degrees, worst_db, {}}};
    const render::Picture joined{3 * worst.width, worst.height, side_by_side(worst_exact.rgba, worst.rgba, worst.width),
                                 "", 0};
    result.worst.png = render::encode_png(joined);
    return result;
  }
};

}  // namespace

render::HairShot PictureComparer::shot(const DrawnWay& way, const PosedHair& hair, const ViewAngle& view) const {
  return {.model = way.model,
          .transparency = way.transparency,
          .material = way.material,
          .palette = hair.palette,
          .order = way.bones ? &way.bones->order() : nullptr,
          .yaw_degrees = view.yaw_degrees,
          .pitch_degrees = view.pitch_degrees,
          .width = width_,
          .height = height_,
          .samples = way.samples};
}

tl::expected<render::Picture, ToolError> PictureComparer::take(const DrawnWay& way, const PosedHair& hair,
                                                               const ViewAngle& view, std::uint32_t divisor) {
  render::HairShot taken = shot(way, hair, view);
  taken.width /= divisor;
  taken.height /= divisor;
  if (!way.sorted_units.empty()) {
    const Eigen::Vector3f eye = pictures_.eye(taken).cast<float>();
    AssetContents contents = sorted_by_unit(finest_, way.sorted_units, hair.positions, eye);
    set_faces(contents, way.faces_together);
    const lab::OpenedAsset sorted(contents);
    if (auto replaced = pictures_.replace(way.model, sorted.asset()); !replaced) {
      return tl::unexpected(replaced.error());
    }
  }
  return pictures_.take(taken);
}

tl::expected<std::vector<WayComparison>, ToolError> PictureComparer::over_views(
    std::span<const DrawnWay> ways, const OrderPose& pose, std::span<const ViewAngle> views,
    const std::function<void(std::size_t view)>& progress) {
  std::vector<Running> running(ways.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    progress(v);
    const PosedHair& hair = pose.moments[v % pose.moments.size()];
    const auto exact = take(exact_, hair, views[v]);
    if (!exact) return tl::unexpected(exact.error());
    for (std::size_t w = 0; w < ways.size(); ++w) {
      auto picture = take(ways[w], hair, views[v]);
      if (!picture) return tl::unexpected(picture.error());
      running[w].add(picture_error(exact->rgba, picture->rgba), views[v], *exact, *picture);
    }
  }
  std::vector<WayComparison> comparisons;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    comparisons.push_back(running[w].comparison(ways[w].name, pose.name));
  }
  return comparisons;
}

tl::expected<std::vector<double>, ToolError> PictureComparer::on_orbit(
    std::span<const DrawnWay> ways, const OrderPose& pose, std::uint32_t frames,
    const std::function<void(std::uint32_t frame)>& progress) {
  std::vector<PictureError> changes(ways.size());
  std::vector<render::Picture> before(ways.size());
  render::Picture exact_before;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    progress(frame);
    const ViewAngle view{double(frame), kOrbitPitch};
    auto exact = take(exact_, pose.moments.front(), view, kOrbitDivisor);
    if (!exact) return tl::unexpected(exact.error());
    for (std::size_t w = 0; w < ways.size(); ++w) {
      auto picture = take(ways[w], pose.moments.front(), view, kOrbitDivisor);
      if (!picture) return tl::unexpected(picture.error());
      if (frame > 0) changes[w] += excess_change(exact_before.rgba, exact->rgba, before[w].rgba, picture->rgba);
      before[w] = std::move(*picture);
    }
    exact_before = std::move(*exact);
  }
  std::vector<double> popping;
  for (const PictureError& change : changes) popping.push_back(change.rmse());
  return popping;
}

}  // namespace coif::report
