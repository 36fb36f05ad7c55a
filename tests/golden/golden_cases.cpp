#include "golden/golden_cases.h"

#include "render/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

namespace coif {
namespace {

constexpr std::uint32_t kWidth = 160, kHeight = 120;

const TransparencyMode* mode_called(std::string_view name) {
  for (const TransparencyMode* mode : render::transparency_modes()) {
    if (name == name_of(*mode)) return mode;
  }
  return &kBlendMode;
}

GoldenCase golden(const char* name, double yaw, double pitch, const char* transparency = "blend") {
  GoldenCase made{name, {}};
  made.settings.width = kWidth;
  made.settings.height = kHeight;
  made.settings.yaw_degrees = yaw;
  made.settings.pitch_degrees = pitch;
  made.settings.transparency = mode_called(transparency);
  return made;
}

GoldenCase moving(GoldenCase made, motion::Motion motion, double seconds) {
  made.settings.motion = motion;
  made.settings.time = seconds;
  return made;
}

}  // namespace

std::vector<GoldenCase> golden_cases() {
  return {golden("front", 20, 5),
          golden("back", 200, 10),
          golden("above", -60, 60),
          moving(golden("turn", 90, 0), motion::Motion::kTurn, 0.45),
          golden("coverage", 20, 5, "coverage"),
          golden("opaque", 20, 5, "opaque")};
}

GoldenAsset::GoldenAsset(const std::string& path) {
  constexpr std::size_t kAlignment = 64;  // what Asset::open() may ask for
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (failed) return;
  const std::size_t rounded = (std::size_t(size) / kAlignment + 1) * kAlignment;
  bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(kAlignment, rounded)));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes_.get()), std::streamsize(size));
  if (file) (void)asset_.open({bytes_.get(), std::size_t(size)});
}

namespace {

constexpr int kReach = 4;  // pixels
constexpr double kSigma = 1.5;

double linear(std::uint8_t encoded) {
  const double c = encoded / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double lightness(double luminance) {
  constexpr double kBreak = 216.0 / 24389.0, kSlope = 24389.0 / 27.0;
  return luminance > kBreak ? 116 * std::cbrt(luminance) - 16 : kSlope * luminance;
}

std::vector<double> lightness_of(std::span<const std::uint8_t> rgba) {
  std::vector<double> result;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    result.push_back(lightness(0.2126 * linear(rgba[i]) + 0.7152 * linear(rgba[i + 1]) + 0.0722 * linear(rgba[i + 2])));
  }
  return result;
}

/// Along rows (`step` 1, lines of `width` pixels) or columns; beyond the border the outermost pixel repeats.
std::vector<double> blurred(const std::vector<double>& image, int length, int step, int lines, int line_step) {
  std::array<double, 2 * kReach + 1> kernel{};
  double sum = 0;
  for (int k = -kReach; k <= kReach; ++k) {
    kernel[std::size_t(k + kReach)] = std::exp(-0.5 * k * k / (kSigma * kSigma));
    sum += kernel[std::size_t(k + kReach)];
  }
  std::vector<double> result(image.size());
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < length; ++i) {
      double mean = 0;
      for (int k = -kReach; k <= kReach; ++k) {
        const int from = std::clamp(i + k, 0, length - 1);
        mean += kernel[std::size_t(k + kReach)] * image[std::size_t(line * line_step + from * step)];
      }
      result[std::size_t(line * line_step + i * step)] = mean / sum;
    }
  }
  return result;
}

}  // namespace

PerceptualDifference perceptual_difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                                           std::uint32_t width) {
  std::vector<double> difference = lightness_of(a);
  const std::vector<double> other = lightness_of(b);
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= other[i];
  const int columns = int(width), rows = int(difference.size() / width);
  difference = blurred(difference, columns, 1, rows, columns);  // blurring is linear: the difference's is enough
  difference = blurred(difference, rows, columns, columns, 1);
  PerceptualDifference result;
  for (const double d : difference) {
    result.mean += std::abs(d) / double(difference.size());
    result.largest = std::max(result.largest, std::abs(d));
  }
  return result;
}

}  // namespace coif
