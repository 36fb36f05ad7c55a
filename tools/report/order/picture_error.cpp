#include "report/order/picture_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace coif {
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

}  // namespace coif
