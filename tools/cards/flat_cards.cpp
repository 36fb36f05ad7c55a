#include "cards/choose_cards.h"

#include "base/geometry.h"
#include "cards/cluster_points.h"

#include <algorithm>

namespace coif::cards {
namespace {

/// Strands as places among all strands.
using StrandShapes = PointClusters<3 * EvenStrands::kStations>;

StrandShapes::Point shape_at(const EvenStrands& strands, std::uint32_t i) {
  StrandShapes::Point shape;
  const auto points = strands.strand(i);
  for (std::size_t k = 0; k < points.size(); ++k)
    std::copy_n(points[k].data(), 3, shape.begin() + std::ptrdiff_t(3 * k));
  return shape;
}

struct PlaneAxes {
  Eigen::Vector3f middle, along, across;
};

/// The principal axes of the strands' points, with equal weight for each strand.
PlaneAxes plane_of(const EvenStrands& strands, std::span<const std::uint32_t> members) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const double points = double(members.size() * EvenStrands::kStations);
  for (const std::uint32_t i : members) {
    for (const Eigen::Vector3f& point : strands.strand(i)) middle += point.cast<double>() / points;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d root_to_tip = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : members) {
    for (const Eigen::Vector3f& point : strands.strand(i)) {
      const Eigen::Vector3d off = point.cast<double>() - middle;
      spread += off * off.transpose();
    }
    root_to_tip += (middle - strands.strand(i).front().cast<double>());
  }
  const Eigen::Matrix3d axes = principal_axes(spread);
  const double towards_tips = axes.col(0).dot(root_to_tip) < 0 ? -1 : 1;
  return {middle.cast<float>(), (towards_tips * axes.col(0)).cast<float>(), axes.col(1).cast<float>()};
}

}  // namespace

std::vector<std::vector<std::uint32_t>> cluster_strands(const EvenStrands& strands, std::size_t count,
                                                        const platform::Threads& threads) {
  std::vector<StrandShapes::Point> shapes(strands.count());
  for (std::uint32_t i = 0; i < shapes.size(); ++i) shapes[i] = shape_at(strands, i);
  return StrandShapes::find(shapes, count, threads);
}

Ribbon flat_ribbon_of(const groom::Groom& groom, const EvenStrands& strands, std::span<const std::uint32_t> members) {
  const PlaneAxes plane = plane_of(strands, members);
  const Eigen::Vector3f normal = plane.along.cross(plane.across);
  Eigen::AlignedBox3f box;  // along, across, off the plane
  for (const std::uint32_t i : members) {
    for (const Eigen::Vector3f& point : groom.strand(i)) {
      const Eigen::Vector3f off = point - plane.middle;
      box.extend(Eigen::Vector3f(off.dot(plane.along), off.dot(plane.across), off.dot(normal)));
    }
  }
  Ribbon ribbon;
  for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
    const float share = float(k) / float(Ribbon::kStations - 1);
    const float at = box.min().x() + share * box.sizes().x();
    ribbon.middle[k] = plane.middle + at * plane.along + box.center().y() * plane.across;
    ribbon.along[k] = plane.along;
    ribbon.across[k] = plane.across;
    ribbon.half_width[k] = 0.5f * (box.sizes().y() + strands.width);
    ribbon.half_depth[k] = 0.5f * box.sizes().z();
  }
  return ribbon;
}

}  // namespace coif::cards
