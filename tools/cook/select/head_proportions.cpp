#include "cook/select/head_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

/// A normal distribution.
struct Proportion {
  double mean, spread;
};

// Means and standard deviations over heads of a dozen makers, realistic and cartoon ones. Places are in semi-axes from
// the head's centre, the face at +1; an eye's X is its distance from the middle.
constexpr Proportion kWidthByHeight{-0.12, 0.1}, kDepthByHeight{-0.02, 0.1};  // logarithms of ratios of semi-axes
constexpr Proportion kJointAside{0, 0.1}, kJointUp{-0.93, 0.18}, kJointForwards{-0.13, 0.2};
constexpr Proportion kEyeAside{0.39, 0.06}, kEyeUp{-0.13, 0.1}, kEyeForwards{0.6, 0.12};
constexpr Proportion kNeckLength{-0.33, 0.3};  // logarithm, by the height's semi-axis
constexpr Proportion kEndUp{1.15, 0.35};
constexpr Proportion kMeshWidth{0.03, 0.1};  // logarithm of its half by the semi-axis: ears stand out
constexpr Proportion kMeshAside{0, 0.1}, kMeshChin{-0.97, 0.2}, kMeshNose{1.02, 0.15};
constexpr Proportion kMeshTop{1, 0.1};  // where the mesh is whole
// A mesh that reaches further than its head is rare; one whose skull is cut away under the hair is not.
constexpr double kMeshBeyond = 0.1, kMeshShort = 0.5;

constexpr double kMostOfOne = 9;  ///< Squared deviations of one landmark.

class Surprise {
 public:
  void add(double value, const Proportion& usual) { add_deviation((value - usual.mean) / usual.spread); }
  /// `beyond` is above 0 where a mesh reaches out of its head.
  void add_reach(double beyond) { add_deviation(beyond / (beyond > 0 ? kMeshBeyond : kMeshShort)); }
  [[nodiscard]] double sum() const { return sum_; }

 private:
  void add_deviation(double deviation) {
    const double square = deviation * deviation;
    sum_ += kMostOfOne * square / (kMostOfOne + square);
  }
  double sum_ = 0;
};

void add_mesh(const HeadEllipsoid& head, const HeadLandmarks& marks, Surprise& surprise) {
  const Vector3d low = (marks.mesh->min() - head.center).cwiseQuotient(head.radii),
                 high = (marks.mesh->max() - head.center).cwiseQuotient(head.radii);
  surprise.add(std::log(marks.mesh->sizes().x() / (2 * head.radii.x())), kMeshWidth);
  surprise.add((low.x() + high.x()) / 2, kMeshAside);
  surprise.add(low.y(), kMeshChin);
  if (marks.has_whole_mesh()) {
    surprise.add(high.y(), kMeshTop);
  } else {
    surprise.add_reach(high.y() - 1);
  }
  const double front = marks.forwards < 0 ? -low.z() : high.z(), back = marks.forwards < 0 ? -high.z() : low.z();
  if (marks.forwards != 0) {
    surprise.add(front, kMeshNose);
  } else {
    surprise.add_reach(front - 1);
  }
  surprise.add_reach(-1 - back);
}

}  // namespace

double surprise(const HeadEllipsoid& head, const HeadLandmarks& marks) {
  Surprise sum;
  const auto in_axes = [&](const Vector3d& point) { return Vector3d((point - head.center).cwiseQuotient(head.radii)); };
  sum.add(std::log(head.radii.x() / head.radii.y()), kWidthByHeight);
  sum.add(std::log(head.radii.z() / head.radii.y()), kDepthByHeight);
  if (marks.joint) {
    const Vector3d at = in_axes(*marks.joint);
    sum.add(at.x(), kJointAside);
    sum.add(at.y(), kJointUp);
    sum.add(at.z() * marks.forwards, marks.forwards != 0 ? kJointForwards : Proportion{0, kJointForwards.spread});
  }
  if (marks.joint && marks.neck) sum.add(std::log((*marks.joint - *marks.neck).norm() / head.radii.y()), kNeckLength);
  if (marks.end) sum.add(in_axes(*marks.end).y(), kEndUp);
  if (marks.eyes) {
    for (const Vector3d& eye : *marks.eyes) {
      const Vector3d at = in_axes(eye);
      sum.add(std::abs(at.x()), kEyeAside);
      sum.add(at.y(), kEyeUp);
      if (marks.forwards != 0) sum.add(at.z() * marks.forwards, kEyeForwards);
    }
  }
  if (marks.mesh) add_mesh(head, marks, sum);
  return sum.sum();
}

HeadEllipsoid likeliest_head(const HeadLandmarks& marks) {
  // From each landmark that tells a size by itself; the best of what they lead to.
  std::vector<double> heights;
  if (marks.mesh) heights.push_back(marks.mesh->sizes().x() / 2 / std::exp(kMeshWidth.mean + kWidthByHeight.mean));
  if (marks.joint && marks.eyes)
    heights.push_back(((*marks.eyes)[0].y() - marks.joint->y()) / (kEyeUp.mean - kJointUp.mean));
  if (marks.joint && marks.neck) heights.push_back((*marks.joint - *marks.neck).norm() / std::exp(kNeckLength.mean));
  if (marks.joint && marks.end) heights.push_back((marks.end->y() - marks.joint->y()) / (kEndUp.mean - kJointUp.mean));

  HeadEllipsoid best;
  double least = std::numeric_limits<double>::infinity();
  for (const double height : heights) {
    if (!(height > 0)) continue;
    HeadEllipsoid head;
    head.radii = height * Vector3d(std::exp(kWidthByHeight.mean), 1, std::exp(kDepthByHeight.mean));
    const Vector3d base = marks.joint ? *marks.joint : marks.mesh->center();
    head.center = base;
    if (marks.joint)
      head.center -= head.radii.cwiseProduct(Vector3d(0, kJointUp.mean, marks.forwards * kJointForwards.mean));
    head = descend(
        head, [&](const HeadEllipsoid& h) { return surprise(h, marks); }, 0.2);
    const double found = surprise(head, marks);
    if (found < least) {
      least = found;
      best = head;
    }
  }
  return best;
}

}  // namespace coif::cook
