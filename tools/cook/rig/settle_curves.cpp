#include "cook/rig/fit_chains.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

/// Share of a chain's length by which it rises: from there on the hair is dressed to stand.
constexpr double kStands = 0.25;
/// Share of its length by which a chain descends at least, if it hangs.
constexpr double kHangs = 0.4;
/// Lengths by the lock's width: what stands and is stouter does not swing, as mohawks and buns; nor what lies across.
constexpr double kSlender = 6, kStout = 1.5;
/// Share of a lock that must have a mirror image in the other for the two to be images.
constexpr double kImage = 0.6;
/// Share of the head's radius: the mean distance up to which two chains are images, if their locks are.
constexpr double kImageReach = 0.2;
constexpr std::size_t kPoints = 8;  ///< At which two chains are compared.

double arc_of(const LockCurve& curve) {
  double length = 0;
  for (std::size_t j = 1; j < curve.joints.size(); ++j) length += (curve.joints[j] - curve.joints[j - 1]).norm();
  return length;
}

double distance_to(const LockCurve& curve, const Vector3d& point) {
  double nearest = (point - curve.joints.front()).norm();
  for (std::size_t j = 1; j < curve.joints.size(); ++j) {
    const Vector3d way = curve.joints[j] - curve.joints[j - 1];
    const double at = std::clamp(way.dot(point - curve.joints[j - 1]) / std::max(way.squaredNorm(), 1.0e-18), 0.0, 1.0);
    nearest = std::min(nearest, (point - curve.joints[j - 1] - at * way).norm());
  }
  return nearest;
}

/// Twice the root mean square distance of the lock's hair from its chain.
double width_of(const HangingHair& hair, const HairLock& lock, const LockCurve& curve) {
  double sum = 0, area = 0;
  for (const std::uint32_t c : lock.cells) {
    const double distance = distance_to(curve, hair.cells.middle[c]);
    sum += hair.cells.area[c] * distance * distance;
    area += hair.cells.area[c];
  }
  return area > 0 ? 2 * std::sqrt(sum / area) : 0;
}

/// Whether the chain goes round the head rather than away from it or down: along a hem.
bool goes_round(const LockCurve& curve, const FittedHead& head) {
  const Vector3d way = curve.joints.back() - curve.joints.front();
  Vector3d out = 0.5 * (curve.joints.back() + curve.joints.front()) - head.center;
  out.y() = 0;
  if (!(out.norm() > 0)) return false;
  const Vector3d around = Vector3d::UnitY().cross(out.normalized());
  return std::abs(way.dot(around)) > 0.5 * arc_of(curve);
}

bool is_stiff(const HangingHair& hair, const HairLock& lock, const LockCurve& curve, const FittedHead& head) {
  const double length = arc_of(curve), drop = curve.joints.front().y() - curve.joints.back().y();
  if (drop >= kHangs * length) return false;
  const double width = width_of(hair, lock, curve);
  if (drop < -kStands * length) return length < kSlender * width;
  return length < kStout * width || goes_round(curve, head);
}

std::set<HairCells::Index> places_of(const HangingHair& hair, const HairLock& lock) {
  std::set<HairCells::Index> places;
  for (const std::uint32_t c : lock.cells) places.insert(hair.cells.index[c]);
  return places;
}

/// Share of a lock's area that has its image in x among `places`; cells lie around the head's centre.
double imaged_share(const HangingHair& hair, const HairLock& lock, const std::set<HairCells::Index>& places) {
  double imaged = 0, all = 0;
  for (const std::uint32_t c : lock.cells) {
    HairCells::Index at = hair.cells.index[c];
    at[0] = -at[0];
    bool found = false;
    for (int k = -1; k <= 1 && !found; ++k) found = places.contains({at[0] + k, at[1], at[2]});
    imaged += found ? hair.cells.area[c] : 0;
    all += hair.cells.area[c];
  }
  return all > 0 ? imaged / all : 0;
}

/// `count` points at equal steps of arc length.
LockCurve sampled(const LockCurve& curve, std::size_t count) {
  const double length = arc_of(curve);
  LockCurve points;
  std::size_t j = 1;
  double before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = length * double(i) / double(count - 1);
    double span = (curve.joints[j] - curve.joints[j - 1]).norm();
    while (j + 1 < curve.joints.size() && before + span < wanted) {
      before += span;
      ++j;
      span = (curve.joints[j] - curve.joints[j - 1]).norm();
    }
    const double share = span > 0 ? std::clamp((wanted - before) / span, 0.0, 1.0) : 0;
    points.joints.push_back(curve.joints[j - 1] + share * (curve.joints[j] - curve.joints[j - 1]));
    points.depth.push_back(curve.depth[j - 1] + share * (curve.depth[j] - curve.depth[j - 1]));
  }
  return points;
}

Vector3d image_of(Vector3d point, double middle) {
  point.x() = 2 * middle - point.x();
  return point;
}

bool are_near_images(const LockCurve& a, const LockCurve& b, const FittedHead& head) {
  const LockCurve one = sampled(a, kPoints), other = sampled(b, kPoints);
  double sum = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    sum += (one.joints[i] - image_of(other.joints[i], head.center.x())).norm();
  }
  return sum / double(kPoints) < kImageReach * head.radii.mean();
}

/// Makes the two exact images of each other, with as many bones; one that is its own image comes to the middle.
/// The mean of two may be inside the head, which would push the modelled pose.
void make_images(LockCurve& a, LockCurve& b, const FittedHead& head) {
  const double middle = head.center.x();
  const std::size_t count = std::max(a.joints.size(), b.joints.size());
  a = sampled(a, count);
  if (&a != &b) b = sampled(b, count);
  for (std::size_t j = 0; j < count; ++j) {
    a.joints[j] = kept_out_of_head(head, 0.5 * (a.joints[j] + image_of(b.joints[j], middle)));
    b.joints[j] = image_of(a.joints[j], middle);
    if (&a == &b) a.joints[j].x() = middle;
  }
}

}  // namespace

void settle_curves(const HangingHair& hair, std::span<const HairLock> locks, const FittedHead& head,
                   std::span<LockCurve> curves) {
  for (std::size_t l = 0; l < locks.size(); ++l) {
    if (!curves[l].joints.empty() && is_stiff(hair, locks[l], curves[l], head)) curves[l] = {};
  }
  std::vector<std::set<HairCells::Index>> places(locks.size());
  for (std::size_t l = 0; l < locks.size(); ++l) {
    if (!curves[l].joints.empty()) places[l] = places_of(hair, locks[l]);
  }
  std::vector<bool> is_done(locks.size(), false);
  for (std::size_t a = 0; a < locks.size(); ++a) {
    for (std::size_t b = a; b < locks.size() && !is_done[a]; ++b) {
      if (curves[a].joints.empty() || curves[b].joints.empty() || is_done[b]) continue;
      const bool are_images = imaged_share(hair, locks[a], places[b]) > kImage &&
                              imaged_share(hair, locks[b], places[a]) > kImage &&
                              are_near_images(curves[a], curves[b], head);
      if (!are_images) continue;
      make_images(curves[a], curves[b], head);
      is_done[a] = is_done[b] = true;
    }
  }
}

}  // namespace coif::cook
