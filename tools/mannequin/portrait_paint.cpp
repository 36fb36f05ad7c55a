#include "mannequin/portrait.h"

#include "mannequin/portrait_head.h"
#include "mannequin/solid_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace coif::mannequin {
namespace {

using Eigen::Vector3d;

const Vector3d kSkin{0.545, 0.335, 0.245};
const Vector3d kBlush{0.560, 0.235, 0.180};
const Vector3d kLips{0.470, 0.190, 0.165};
const Vector3d kBrow{0.100, 0.057, 0.036};
const Vector3d kRoots{0.120, 0.072, 0.050};
const Vector3d kLashes{0.020, 0.012, 0.010};

Vector3d blended(const Vector3d& a, const Vector3d& b, double share) {
  return a + std::clamp(share, 0.0, 1.0) * (b - a);
}

/// Same for all platforms: -1..1 at whole numbers.
double lattice_noise(std::int64_t x, std::int64_t y) {
  SeededNoise noise(static_cast<std::uint64_t>(x * 73856093 ^ y * 19349663));
  return noise.between(-1, 1);
}

/// Smooth between whole numbers.
double value_noise(double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const double tx = smooth_step(0, 1, x - fx), ty = smooth_step(0, 1, y - fy);
  const double low = lattice_noise(ix, iy) * (1 - tx) + lattice_noise(ix + 1, iy) * tx;
  const double high = lattice_noise(ix, iy + 1) * (1 - tx) + lattice_noise(ix + 1, iy + 1) * tx;
  return low * (1 - ty) + high * ty;
}

double bump(double x, double y, double center_x, double center_y, double radius_x, double radius_y) {
  const double u = (x - center_x) / radius_x, v = (y - center_y) / radius_y;
  return std::exp(-(u * u + v * v));
}

/// How much of the skin the brow's hair covers. `x` >= 0.
double brow_cover(double x, double y) {
  constexpr double kInner = 0.0120, kOuter = 0.0530;
  const double t = (x - kInner) / (kOuter - kInner);
  if (t < -0.1 || t > 1.1) return 0;
  const double u = std::clamp(t, 0.0, 1.0);
  const double middle = kBrowLine + 0.0002 + 0.0048 * std::sin(0.5 * std::numbers::pi * std::min(u / 0.68, 1.0)) -
                        0.0062 * smooth_step(0.55, 1.05, u);
  const double half = 0.0038 * (1 - 0.82 * smooth_step(0.45, 1.0, u));
  const double v = (y - middle) / half;
  // Hairs rise at the inner end and lie along the brow towards the tail.
  const double lean = 0.35 + 2.6 * u;
  const double across = (x - lean * (y - middle)) / 0.00055;
  const double hair = 0.72 + 0.38 * value_noise(across, 40 * u);
  const double soft = smooth_step(1.15 + 0.25 * value_noise(across, 7), 0.35, std::abs(v));
  return soft * hair * smooth_step(-0.06, 0.10, t) * smooth_step(1.04, 0.90, t);
}

/// How much of the scalp's skin the hairs' roots cover, from the hairline on.
double root_cover(const Vector3d& point) {
  constexpr std::array<std::pair<double, double>, 11> kHairline{{{0, 34},
                                                                 {20, 35},
                                                                 {38, 33},
                                                                 {55, 22},
                                                                 {71, -12},
                                                                 {78, -12},
                                                                 {86, -1},
                                                                 {98, -2},
                                                                 {122, -32},
                                                                 {145, -40},
                                                                 {180, -42}}};  // degrees around: degrees up
  const Vector3d q = (point - Vector3d(0, 1.630, -0.012)).cwiseQuotient(Vector3d(0.0745, 0.090, 0.096));
  constexpr double kDegree = std::numbers::pi / 180;
  const double up = std::asin(std::clamp(q.y() / std::max(q.norm(), 1e-6), -1.0, 1.0)) / kDegree;
  const double around = std::atan2(std::abs(q.x()), q.z()) / kDegree;
  double line = kHairline.back().second;
  for (std::size_t i = 1; i < kHairline.size(); ++i) {
    const auto& [from, low] = kHairline[i - 1];
    const auto& [to, high] = kHairline[i];
    if (around <= to) {
      line = low + (high - low) * (around - from) / (to - from);
      break;
    }
  }
  const double ragged = 1.6 * value_noise(around * 1.7, 0.12 * up) + 1.0 * value_noise(around * 4.1, 11 + 0.2 * up);
  return smooth_step(-3, 13, up - line + ragged);
}

struct LipCover {
  /// How much of the skin lips cover, 0..1. `depth` is 1 at the mouth's line, 0 at the lips' borders.
  double share, depth;
};

LipCover lip_cover(double x, double y) {
  constexpr double kCorner = 0.0272;
  const double t = std::min(x / kCorner, 1.0);
  const double fall = std::sqrt(std::max(1 - t * t, 0.0));
  const double bow = 0.0074 - 0.0014 * bump(x, 0, 0, 0, 0.0032, 1);
  const double upper = bow * std::pow(1 - std::pow(t, 1.6), 0.9), lower = 0.0098 * std::pow(fall, 1.15);
  const double above = y - kMouthLine - 0.0044 * t * t;  // The corners smile.
  const double v = above > 0 ? above / std::max(upper, 1e-4) : -above / std::max(lower, 1e-4);
  return {smooth_step(1.12, 0.86, v) * smooth_step(1.0, 0.93, t), std::max(1 - v, 0.0)};
}

}  // namespace

Vector3d skin_color(const Vector3d& point) {
  const double x = std::abs(point.x()), y = point.y();
  const double front = smooth_step(0.030, 0.050, point.z());
  Vector3d color = kSkin * (1 + 0.03 * value_noise(point.x() * 90, y * 90 + 7 * point.z()));
  double red = 0.55 * bump(x, y, 0.0390, 1.5700, 0.0200, 0.0150) + 0.40 * bump(x, y, 0, 1.5660, 0.0130, 0.0090) +
               0.20 * bump(x, y, 0, 1.5020, 0.0150, 0.0110) + 0.30 * bump(x, y, 0.0330, 1.6150, 0.0170, 0.0060);
  red *= front;
  red += 0.55 * smooth_step(0.070, 0.084, x) * smooth_step(1.50, 1.55, y);  // ears
  color = blended(color, kBlush, red);
  if (std::abs(x) < 0.0790) color = blended(color, kRoots, 0.80 * root_cover(point));
  if (front <= 0) return color;
  const LidEdges lids = lid_edges(x);
  const double near_eye = smooth_step(1.25, 1.0, std::abs(lids.across));
  const double shade = bump(x, y, 0.0320, lids.upper + 0.0030, 0.0170, 0.0034) * 0.16;
  color = blended(color, {0.300, 0.150, 0.110}, shade * front);
  color = blended(color, {0.480, 0.200, 0.170},
                  0.8 * bump(x, y, kOpeningMiddle - kOpeningHalf, kEyeLine, 0.0028, 0.0030) * front);
  const LipCover lips = lip_cover(x, y);
  const Vector3d lip =
      kLips * (1.0 - 0.55 * smooth_step(0.86, 0.98, lips.depth)) * (1 + 0.05 * value_noise(point.x() * 1400, y * 150));
  color = blended(color, lip, 0.92 * lips.share * front);
  color = blended(color, {0.150, 0.065, 0.050}, 0.85 * bump(x, y, 0.0060, 1.5580, 0.0030, 0.0014) * front);  // nostrils
  color = blended(color, kBrow, 0.95 * brow_cover(x, y) * front);
  // Lash lines: broad above and towards the outer corner.
  const double width = 0.0004 + 0.0013 * smooth_step(-1.0, 0.7, lids.across);
  const double above =
      smooth_step(1.8 * width, 0.5 * width, y - lids.upper) * smooth_step(-0.0022, -0.0008, y - lids.upper);
  const double wing = smooth_step(1.10, 1.0, std::abs(lids.across));
  color = blended(color, kLashes, 0.95 * above * wing * near_eye * front);
  const double below = smooth_step(0.0011, 0.0002, lids.lower - y) * smooth_step(-0.0020, -0.0008, lids.lower - y);
  return blended(color, {0.210, 0.085, 0.070}, 0.65 * below * wing * front);
}

Vector3d eye_color(double x, double y) {
  const double r = std::hypot(x, y), angle = std::atan2(y, x);
  constexpr double kIris = 0.445, kPupil = 0.175;
  Vector3d white = Vector3d(0.700, 0.660, 0.630) * (1 - 0.22 * smooth_step(0.55, 1.05, r));
  const double fibre = value_noise(angle * 26, 3 * r) * 0.5 + value_noise(angle * 61, 5 * r) * 0.5;
  const double inside = std::clamp((r - kPupil) / (kIris - kPupil), 0.0, 1.0);
  Vector3d iris = blended({0.130, 0.210, 0.190}, {0.045, 0.115, 0.140}, inside) * (1.15 + 0.75 * fibre);
  iris += Vector3d(0.100, 0.060, 0.015) * smooth_step(0.45, 0.0, inside);
  iris *= 1 - 0.85 * smooth_step(0.72, 1.0, inside);
  // Lighter opposite of the light, as the cornea gathers it.
  iris *= 1 + 0.6 * smooth_step(0.1, -0.4, y);
  Vector3d color = blended(iris, white, smooth_step(kIris - 0.02, kIris + 0.05, r));
  color = blended({0.004, 0.004, 0.005}, color, smooth_step(kPupil - 0.015, kPupil + 0.03, r));
  color *= 1 - 0.72 * smooth_step(0.12, 0.52, y + 0.10 * x * x);  // the upper lid's shadow
  const double glint = smooth_step(0.085, 0.055, std::hypot(x + 0.15, y - 0.17));
  return color + Vector3d::Constant(1.2 * glint);
}

}  // namespace coif::mannequin
