#include "cook/recipe/rig_recipe.h"
#include "cook/rig/fit_chains.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kSlice = 1.5;  ///< Cells: each slice has hair, and levels of depth stay apart.
constexpr std::size_t kMostSlices = 512;
/// Share of the middle slice's area: a slice with less hair at the tip is a few wisps.
constexpr double kThinSlice = 0.2;
/// Weight of hair that another lock moves; it matters only where the lock has none of its own.
constexpr double kWayShare = 1.0e-3;
constexpr int kSmoothing = 3;        ///< Times that each point moves halfway to its neighbours.
constexpr double kClearance = 1.01;  ///< Factor on the head's size: joints inside it are moved out to there.
constexpr double kShortestLockBone = 1.0e-3;

struct CurvePoint3 {
  Vector3d at;
  double depth;
};

using Curve = std::vector<CurvePoint3>;

/// Slices up to the last one with a fair share of hair: a few long wisps are carried on by the last bone.
std::size_t slices_to_tip(const std::vector<double>& weight) {
  std::vector<double> sorted = weight;
  std::ranges::nth_element(sorted, sorted.begin() + std::ptrdiff_t(sorted.size() / 2));
  std::size_t count = weight.size();
  while (count > 2 && weight[count - 1] < kThinSlice * sorted[sorted.size() / 2]) --count;
  return count;
}

/// Mean of the hair in each slice of depth; slices without hair are left out.
Curve slice_means(const HangingHair& hair, const HairLock& lock) {
  const double step = std::max(kSlice * hair.cells.size, lock.length / double(kMostSlices));
  const auto count = std::size_t(lock.length / step) + 1;
  std::vector<Vector3d> sum(count, Vector3d::Zero());
  std::vector<double> weight(count, 0), depth(count, 0);
  const auto add = [&](std::uint32_t cell, double share) {
    if (hair.depth[cell] <= 0) return;
    const std::size_t slice = std::min(std::size_t(hair.depth[cell] / step), count - 1);
    sum[slice] += share * hair.cells.area[cell] * hair.cells.middle[cell];
    depth[slice] += share * hair.cells.area[cell] * hair.depth[cell];
    weight[slice] += share * hair.cells.area[cell];
  };
  for (std::uint32_t c : lock.cells) add(c, 1);
  for (std::uint32_t c : lock.ways) add(c, kWayShare);
  Curve curve;
  for (std::size_t s = 0; s < slices_to_tip(weight); ++s) {
    if (weight[s] > 0) curve.push_back({sum[s] / weight[s], depth[s] / weight[s]});
  }
  return curve;
}

/// Turns every point about the head's upright axis to one side of it.
void turn_to(double turn, const FittedHead& head, Curve& curve) {
  const double angle = 2 * std::numbers::pi * turn;
  for (CurvePoint3& point : curve) {
    const double beside = std::hypot(point.at.x() - head.center.x(), point.at.z() - head.center.z());
    point.at.x() = head.center.x() + beside * std::sin(angle);
    point.at.z() = head.center.z() + beside * std::cos(angle);
  }
}

void smooth(Curve& curve) {
  for (int pass = 0; pass < kSmoothing; ++pass) {
    const Curve before = curve;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
      curve[i].at = 0.5 * before[i].at + 0.25 * (before[i - 1].at + before[i + 1].at);
    }
  }
}

/// Slices are at their mean depth. Extends the curve along its end directions, up to the scalp and by half a slice to
/// the tip.
void extend(Curve& curve) {
  const CurvePoint3 first = curve[0], second = curve[1];
  const CurvePoint3 last = curve[curve.size() - 1], before = curve[curve.size() - 2];
  const double half = 0.5 * (last.depth - before.depth);
  const Vector3d back = (first.at - second.at) / std::max(second.depth - first.depth, 1.0e-9);
  const Vector3d on = (last.at - before.at) / std::max(last.depth - before.depth, 1.0e-9);
  // The mean moves at most as fast as depth; faster is a jump between different hair.
  const auto limited = [](const Vector3d& v) { return v.norm() > 1 ? Vector3d(v.normalized()) : v; };
  curve.insert(curve.begin(), {first.at + limited(back) * first.depth, 0});
  curve.push_back({last.at + limited(on) * half, last.depth + half});
}

void keep_out_of_head(const FittedHead& head, Curve& curve) {
  for (CurvePoint3& point : curve) point.at = kept_out_of_head(head, point.at);
}

std::vector<double> arc_lengths(const Curve& curve) {
  std::vector<double> arc{0};
  for (std::size_t i = 1; i < curve.size(); ++i) arc.push_back(arc.back() + (curve[i].at - curve[i - 1].at).norm());
  return arc;
}

CurvePoint3 point_at(const Curve& curve, const std::vector<double>& arc, double length) {
  const auto above = std::ranges::lower_bound(arc, length) - arc.begin();
  const std::size_t i = std::clamp<std::size_t>(std::size_t(above), 1, curve.size() - 1);
  const double span = arc[i] - arc[i - 1];
  const double share = span > 0 ? std::clamp((length - arc[i - 1]) / span, 0.0, 1.0) : 0.0;
  return {curve[i - 1].at + share * (curve[i].at - curve[i - 1].at),
          curve[i - 1].depth + share * (curve[i].depth - curve[i - 1].depth)};
}

}  // namespace

Vector3d kept_out_of_head(const FittedHead& head, const Vector3d& point) {
  const Vector3d from = point - head.center;
  const double scaled = from.cwiseQuotient(head.radii).norm();
  return scaled < kClearance && scaled > 0 ? Vector3d(head.center + from * (kClearance / scaled)) : point;
}

LockCurve fit_lock_curve(const HangingHair& hair, const HairLock& lock, const FittedHead& head, const RigRecipe& recipe,
                         std::size_t most_bones) {
  LockCurve result;
  Curve curve = slice_means(hair, lock);
  if (curve.size() < 2) return result;
  if (lock.turn) turn_to(*lock.turn, head, curve);
  smooth(curve);
  extend(curve);
  keep_out_of_head(head, curve);
  const std::vector<double> arc = arc_lengths(curve);
  const double length = arc.back();
  if (length < std::max(recipe.chain_shortest, kShortestLockBone)) return result;
  const double wanted = std::round(length / recipe.chain_bone_length);
  const auto bones = std::size_t(std::clamp(wanted, 1.0, double(most_bones)));
  for (std::size_t j = 0; j <= bones; ++j) {
    CurvePoint3 joint = point_at(curve, arc, length * double(j) / double(bones));
    // On a chord between two outer points a joint may be inside the head again.
    Curve alone{joint};
    keep_out_of_head(head, alone);
    const bool too_near = j > 0 && (alone.front().at - result.joints.back()).norm() < kShortestLockBone;
    if (too_near) continue;
    result.joints.push_back(alone.front().at);
    result.depth.push_back(joint.depth);
  }
  if (result.joints.size() < 2) result = {};
  return result;
}

}  // namespace coif::cook
