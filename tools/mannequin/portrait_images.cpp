#include "base/srgb.h"
#include "mannequin/portrait.h"
#include "mannequin/portrait_head.h"
#include "mannequin/solid_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace coif::mannequin {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint32_t kEyeSide = 256;

/// Corners of a curve of straight pieces, ascending in the first number.
using Corner = std::pair<double, double>;

// The face gets most texels. Degrees around the head -> U, and metres above the ground -> 1 - V. Textures repeat:
// without a margin the filter would mix the middle of the back into the face.
constexpr std::array<Corner, 4> kAround{{{0, 0.008}, {40, 0.50}, {75, 0.75}, {180, 0.992}}};
constexpr std::array<Corner, 4> kUp{{{1.22, 0}, {1.485, 0.16}, {1.650, 0.90}, {1.725, 1}}};
constexpr double kSkinAxisZ = -0.020;  // the axis that the skin is unrolled from

double along_curve(std::span<const Corner> curve, double x) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto& [from, low] = curve[i - 1];
    const auto& [to, high] = curve[i];
    if (x <= to || i + 1 == curve.size()) return low + (high - low) * std::clamp((x - from) / (to - from), 0.0, 1.0);
  }
  return 0;
}

std::array<Corner, 4> reversed(const std::array<Corner, 4>& curve) {
  std::array<Corner, 4> out;
  std::ranges::transform(curve, out.begin(), [](const Corner& c) { return Corner{c.second, c.first}; });
  return out;
}

/// The outermost point of the skin there.
Vector3d skin_point(const Vector2d& place) {
  const double angle = along_curve(reversed(kAround), place.x()) * std::numbers::pi / 180;
  const double height = along_curve(reversed(kUp), 1 - place.y());
  const Vector3d outwards{std::sin(angle), 0, std::cos(angle)};
  constexpr double kFarthest = 0.28;
  double r = kFarthest;
  for (int i = 0; i < 60 && r > 0; ++i) {
    const double distance = portrait_distance(Vector3d(0, height, kSkinAxisZ) + r * outwards);
    if (distance < 2e-4) break;
    r -= 0.9 * distance;
  }
  return Vector3d(0, height, kSkinAxisZ) + std::max(r, 0.0) * outwards;
}

/// Share of light from everywhere that reaches the point. Source: Quilez, "Ambient occlusion", distance fields, 2008.
double openness_of_skin(const Vector3d& point) {
  const Vector3d normal = portrait_normal(point);
  double hidden = 0;
  for (const double reach : {0.003, 0.007, 0.013}) {
    hidden += std::max(reach - portrait_distance(point + reach * normal), 0.0) / reach / 3;
  }
  // The paint below the jaw is for the shoulders, and the neck shows it too.
  const double share = 0.9 * smooth_step(1.455, 1.480, point.y());
  // Between the lids the eye's own paint has the shade.
  const LidEdges lids = lid_edges(std::abs(point.x()));
  const bool is_lid = point.z() > 0.05 && std::abs(lids.across) < 1.15 && point.y() < lids.upper + 0.001 &&
                      point.y() > lids.lower - 0.001;
  return std::clamp(1 - share * hidden, is_lid ? 0.85 : 0.2, 1.0);
}

struct SkinSample {
  Vector3d point;
  double openness;
};

SkinSample between(const SkinSample& a, const SkinSample& b, double t) {
  return {a.point + t * (b.point - a.point), a.openness + t * (b.openness - a.openness)};
}

/// Fewer than texels: finding the surface costs more than painting it.
class SkinSamples {
 public:
  explicit SkinSamples(int columns) : columns_(columns), rows_(columns * 4 / 3) {
    for (int y = 0; y <= rows_; ++y) {
      for (int x = 0; x <= columns_; ++x) {
        const Vector3d point = skin_point({double(x) / columns_, double(y) / rows_});
        samples_.push_back({point, openness_of_skin(point)});
      }
    }
  }

  [[nodiscard]] SkinSample at(const Vector2d& place) const {
    const double x = place.x() * columns_, y = place.y() * rows_;
    const int column = std::min(int(x), columns_ - 1), row = std::min(int(y), rows_ - 1);
    const auto corner = [&](int dx, int dy) {
      return samples_[std::size_t((row + dy) * (columns_ + 1) + column + dx)];
    };
    return between(between(corner(0, 0), corner(1, 0), x - column), between(corner(0, 1), corner(1, 1), x - column),
                   y - row);
  }

 private:
  int columns_, rows_;
  std::vector<SkinSample> samples_;
};

template <typename Paint>
PaintedImage painted(std::uint32_t width, std::uint32_t height, const Paint& color_at) {
  PaintedImage image{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const Vector3d color = color_at(Vector2d((x + 0.5) / width, (y + 0.5) / height));
      for (int k = 0; k < 3; ++k) {
        image.rgba.push_back(std::uint8_t(std::lround(255 * encode_srgb(std::clamp(color[k], 0.0, 1.0)))));
      }
      image.rgba.push_back(255);
    }
  }
  return image;
}

}  // namespace

Vector2d skin_place(const Vector3d& point) {
  const double angle = std::atan2(std::abs(point.x()), point.z() - kSkinAxisZ) * 180 / std::numbers::pi;
  return {along_curve(kAround, angle), 1 - along_curve(kUp, point.y())};
}

PaintedImage skin_image(std::uint32_t width) {
  const SkinSamples samples(int(width / 4));
  return painted(width, width * 4 / 3, [&](const Vector2d& place) {
    const auto [point, openness] = samples.at(place);
    // Light that skin scatters into a fold is red.
    const Vector3d fold(std::pow(openness, 0.6), std::pow(openness, 0.95), openness);
    return Vector3d(skin_color(point).cwiseProduct(fold));
  });
}

PaintedImage eye_image() {
  return painted(kEyeSide, kEyeSide, [](const Vector2d& place) {
    return eye_color(kEyeImageReach * (2 * place.x() - 1), kEyeImageReach * (1 - 2 * place.y()));
  });
}

}  // namespace coif::mannequin
