#include "report/picture/light_measures.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coif::report {
namespace {

using Plane = Eigen::ArrayXXf;  ///< Width by height.

constexpr float kInside = 0.5f;  ///< Least coverage.

Plane channel_of(const LinearPicture& picture, std::size_t k) {
  Plane plane(picture.width, picture.height);
  for (Eigen::Index i = 0; i < plane.size(); ++i) plane(i) = picture.rgba[std::size_t(4 * i) + k];
  return plane;
}

/// Rec. 709 luminance of the hair alone: coverage divided out.
Plane brightness_of(const LinearPicture& picture) {
  const Plane light =
      0.2126f * channel_of(picture, 0) + 0.7152f * channel_of(picture, 1) + 0.0722f * channel_of(picture, 2);
  return light / channel_of(picture, 3).max(1e-3f);
}

double iou(const Plane& a, const Plane& b) {
  const double both = double(a.min(b).sum()), any = double(a.max(b).sum());
  return any > 0 ? both / any : 1;
}

/// A Gaussian along the first axis, up to three standard deviations.
Plane blurred_along(const Plane& plane, double sigma) {
  const auto reach = std::min(Eigen::Index(std::ceil(3 * sigma)), plane.rows() - 1);
  Plane sum = Plane::Zero(plane.rows(), plane.cols());
  double weights = 0;
  for (Eigen::Index d = -reach; d <= reach; ++d) {
    const double weight = std::exp(-0.5 * double(d * d) / (sigma * sigma));
    weights += weight;
    const Eigen::Index count = plane.rows() - std::abs(d), from = std::max<Eigen::Index>(d, 0);
    sum.middleRows(from - d, count) += float(weight) * plane.middleRows(from, count);
  }
  return sum / float(weights);
}

Plane blurred(const Plane& plane, double sigma) {
  return blurred_along(blurred_along(plane, sigma).transpose(), sigma).transpose();
}

/// The mean of what is inside around each pixel.
Plane mean_around(const Plane& plane, const Plane& inside, double sigma) {
  return blurred(plane * inside, sigma) / blurred(inside, sigma).max(1e-4f);
}

double mean_of(const Plane& plane, const Plane& inside) {
  return double((plane * inside).sum()) / std::max(double(inside.sum()), 1.0);
}

/// Covariance over the mean's square of each band of two pictures' brightness.
std::array<double, 6> band_contrast(const Plane& a, const Plane& b, const Plane& inside) {
  std::array<double, 6> contrast;
  const double mean = std::sqrt(std::max(mean_of(a, inside) * mean_of(b, inside), 1e-12));
  std::pair<Plane, Plane> finer{a, b};
  for (std::size_t i = 0; i < contrast.size(); ++i) {
    std::pair<Plane, Plane> coarser{mean_around(a, inside, kGrainPixels[i]), mean_around(b, inside, kGrainPixels[i])};
    const Plane band_a = finer.first - coarser.first, band_b = finer.second - coarser.second;
    contrast[i] = mean_of(band_a * band_b, inside) / (mean * mean);
    finer = std::move(coarser);
  }
  return contrast;
}

/// Sums of squares over blocks: of differences, of truths.
void compare_blocks(const LinearPicture& truth, const LinearPicture& ours, const Plane& inside, LightFigures& figures) {
  constexpr Eigen::Index kBlock = 8;
  double differences = 0, truths = 0, light = 0, true_light = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Plane a = channel_of(truth, k), b = channel_of(ours, k);
    for (Eigen::Index x = 0; x + kBlock <= inside.rows(); x += kBlock) {
      for (Eigen::Index y = 0; y + kBlock <= inside.cols(); y += kBlock) {
        if (!(inside.block(x, y, kBlock, kBlock) > 0).all()) continue;
        const double t = double(a.block(x, y, kBlock, kBlock).mean()), o = double(b.block(x, y, kBlock, kBlock).mean());
        differences += (o - t) * (o - t);
        truths += t * t;
        light += o;
        true_light += t;
        figures.blocks += k == 0 ? 1 : 0;
      }
    }
  }
  figures.tone = truths > 0 ? std::sqrt(differences / truths) : std::numeric_limits<double>::quiet_NaN();
  figures.bias = true_light > 0 ? light / true_light - 1 : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

LightFigures compare_light(const TruthPicture& truth, const LinearPicture& ours) {
  LightFigures figures;
  const LinearPicture mean = truth.mean();
  const Plane covered = channel_of(mean, 3).min(1.0f), covered_by_us = channel_of(ours, 3).min(1.0f);
  const Plane true_shape = (covered >= kInside).cast<float>(), shape = (covered_by_us >= kInside).cast<float>();
  const Plane inside = true_shape * shape;
  figures.outline = iou(true_shape, shape);
  figures.coverage = iou(covered, covered_by_us);
  compare_blocks(mean, ours, inside, figures);
  const auto wanted = band_contrast(brightness_of(truth.halves[0]), brightness_of(truth.halves[1]), inside);
  const Plane own = brightness_of(ours);
  const auto drawn = band_contrast(own, own, inside);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const bool is_there = wanted[i] > 1e-6;
    figures.grain[i] = is_there ? std::sqrt(drawn[i] / wanted[i]) : std::numeric_limits<double>::quiet_NaN();
  }
  return figures;
}

}  // namespace coif::report
