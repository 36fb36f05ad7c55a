#include "sample/long_skeleton.h"

#include "sample/rounded_influences.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace coif::sample {
namespace {

using Eigen::Vector3d;

constexpr int kRoot = 0, kNeck = 1, kHead = 2, kFirstScalp = 3, kFirstLock = 6;
constexpr int kJointsPerLock = kBonesPerLock + 1;  // and the end

/// Scalp joint of a lock: left, back or right.
int scalp_of(const Lock& lock) {
  if (lock.course.azimuth < 125.0) return kFirstScalp;
  return lock.course.azimuth <= 235.0 ? kFirstScalp + 1 : kFirstScalp + 2;
}

std::string with_digits(int number, std::size_t digits) {
  std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

}  // namespace

std::vector<Joint> make_long_skeleton(std::span<const Lock> locks) {
  std::vector<Joint> joints{{"root", -1, {0, 0, 0}},
                            {"neck", kRoot, {0, 1.450, -0.030}},
                            {"Head", kNeck, {0, 1.600, 0}},
                            {"scalp_left", kHead, {0.055, 1.670, -0.010}},
                            {"scalp_back", kHead, {0, 1.670, -0.080}},
                            {"scalp_right", kHead, {-0.055, 1.670, -0.010}}};
  for (std::size_t l = 0; l < locks.size(); ++l) {
    const std::string name = "Lock_" + with_digits(static_cast<int>(l) + 1, 3) + "_";
    const double start = chain_start(locks[l].course);
    int parent = scalp_of(locks[l]);
    for (int b = 0; b <= kBonesPerLock; ++b) {
      const double along = start + (1.0 - start) * b / kBonesPerLock;
      const Vector3d position = point_on_lock(locks[l].course, along);
      joints.push_back({name + (b < kBonesPerLock ? with_digits(b + 1, 2) : "end"), parent, position});
      parent = static_cast<int>(joints.size()) - 1;
    }
  }
  return joints;
}

SkinInfluences lock_influences(std::span<const Lock> locks, int a, int b, double share_b, double along) {
  // In the middle of a bone a point is on it alone; at the joint of two it is on both by half.
  const double place = std::clamp(along * kBonesPerLock - 0.5, -1.0, kBonesPerLock - 1.0);
  const int upper = static_cast<int>(std::floor(place));
  const double lower_share = place - upper;
  const auto joint = [&](int lock, int bone) {
    return bone < 0 ? scalp_of(locks[static_cast<std::size_t>(lock)]) : kFirstLock + lock * kJointsPerLock + bone;
  };
  const int lower = std::min(upper + 1, kBonesPerLock - 1);
  return rounded_influences({{{joint(a, upper), (1.0 - share_b) * (1.0 - lower_share)},
                              {joint(a, lower), (1.0 - share_b) * lower_share},
                              {joint(b, upper), share_b * (1.0 - lower_share)},
                              {joint(b, lower), share_b * lower_share}}});
}

}  // namespace coif::sample
