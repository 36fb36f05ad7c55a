#include "compare/rig_difference.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif::compare {
namespace {

using Eigen::Vector3d;

Vector3d rest_position(const Asset& asset, std::uint32_t vertex) {
  return Eigen::Map<const Eigen::Vector3f>(asset.vertices()[vertex].position).cast<double>();
}

/// Displacement of a vertex by skinning, head space: its drawn place minus its place at rest.
Vector3d displacement(const Asset& asset, const animation::RecordedFrame& frame, std::uint32_t vertex) {
  const Vector3d rest = rest_position(asset, vertex);
  const SkinRecord& skin = asset.skin()[vertex];
  Vector3d skinned = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) {
    if (skin.weight[k] == 0) continue;
    const Eigen::Map<const Eigen::Matrix<float, 3, 4, Eigen::RowMajor>> matrix(frame.palette[skin.bone[k]].m[0]);
    skinned += skin.weight[k] / 255.0 * (matrix.cast<double>() * rest.homogeneous());
  }
  return skinned - rest;
}

/// Sums over the frames of one pair of vertices.
struct PointSums {
  double difference2 = 0;
  double moved2 = 0;
  double worst2 = 0;
  Vector3d moved = Vector3d::Zero();
};

PointSums follow_point(const Asset& a, const animation::Recording& in_a, std::uint32_t vertex_a, const Asset& b,
                       const animation::Recording& in_b, std::uint32_t vertex_b) {
  PointSums sums;
  for (std::size_t f = 0; f < in_a.frames.size(); ++f) {
    const Vector3d by_a = displacement(a, in_a.frames[f], vertex_a);
    const double difference2 = (by_a - displacement(b, in_b.frames[f], vertex_b)).squaredNorm();
    sums.difference2 += difference2;
    sums.worst2 = std::max(sums.worst2, difference2);
    sums.moved2 += by_a.squaredNorm();
    sums.moved += by_a;
  }
  return sums;
}

}  // namespace

tl::expected<RigDifference, ToolError> compare_rigs(const Asset& a, const Asset& b, const SurfaceMatch& match,
                                                    const animation::RecordingSettings& settings) {
  const auto in_a = animation::record(a, settings);
  if (!in_a) return tl::unexpected(in_a.error());
  const auto in_b = animation::record(b, settings);
  if (!in_b) return tl::unexpected(in_b.error());
  const auto frames = double(in_a->frames.size());
  double difference2 = 0, moved2 = 0, swing2 = 0, worst2 = 0;
  for (std::size_t i = 0; i < match.area.size(); ++i) {
    if (match.area[i] <= 0) continue;
    const PointSums sums = follow_point(a, *in_a, match.vertex_a[i], b, *in_b, match.vertex_b[i]);
    difference2 += match.area[i] * sums.difference2 / frames;
    moved2 += match.area[i] * sums.moved2 / frames;
    swing2 += match.area[i] * (sums.moved2 / frames - (sums.moved / frames).squaredNorm());
    worst2 = std::max(worst2, sums.worst2);
  }
  RigDifference result;
  result.rms = std::sqrt(difference2);
  result.max = std::sqrt(worst2);
  result.moved = std::sqrt(moved2);
  if (result.moved > 0) {
    result.ratio = result.rms / result.moved;
    result.still_ratio = std::sqrt(std::max(swing2, 0.0)) / result.moved;
  }
  return result;
}

double hair_size(const Asset& asset) {
  Eigen::AlignedBox3d box;
  for (std::uint32_t v : asset.lod_indices(0)) box.extend(rest_position(asset, v));
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace coif::compare
