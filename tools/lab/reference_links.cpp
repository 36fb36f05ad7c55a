#include "lab/reference_links.h"

#include "lab/passive_model.h"

#include <algorithm>
#include <cmath>

namespace coif::lab {
namespace {

using Eigen::Vector3d;

constexpr int kRounds = 400;
constexpr double kNoLever = 1e-2;   ///< Sine: a bone this nearly along its link cannot be turned by it.
constexpr double kWithin = 1e-10;   ///< Share of a link's length.
constexpr double kTaut = 1e-6;      ///< Likewise: its speed is looked at.
constexpr double kSlowest = 1e-10;  ///< m/s
constexpr double kMostWay = 0.25;   ///< Share of a bone's length, in one round.

}  // namespace

ReferenceLinks::ReferenceLinks(std::vector<RigLink> links, std::span<const RigBone> bones)
    : links_(std::move(links)), bones_(bones), starts_(bones.size()) {
  const std::vector<Carried> carried = carried_at_rest(bones);
  for (std::size_t i = 0; i < bones.size(); ++i) {
    mobility_.push_back(bones[i].length * bones[i].length / carried[i].inertia);
  }
}

void ReferenceLinks::turn(std::size_t i, const Vector3d& way, const Level& level) const {
  const RigBone& bone = bones_[i];
  BoneState& state = level.states[i];
  const Vector3d before = turned(state.frame, bone.rest_direction);
  const double most = kMostWay * bone.length, size = way.norm();
  const Vector3d direction = (before + way * (size > most ? most / size : 1.0) / bone.length).normalized();
  state.frame = shortest_arc(before, direction) * state.frame;
  state.turning = across(state.turning, direction);
  push(i, Vector3d::Zero(), level);
}

void ReferenceLinks::push(std::size_t i, const Vector3d& velocity, const Level& level) const {
  const RigBone& bone = bones_[i];
  BoneState& state = level.states[i];
  const BoneMotion& start = starts_[i];
  const Vector3d direction = turned(state.frame, bone.rest_direction);
  state.turning += across(velocity, direction) / bone.length;
  level.motions[i].end = start.end + bone.length * direction;
  level.motions[i].velocity = start.velocity + bone.length * state.turning;
  level.turned[i] = 1;
}

double ReferenceLinks::shorten(const RigLink& link, const Level& level) const {
  const Vector3d way = level.motions[link.to].end - level.motions[link.bone].end;
  const double size = way.norm();
  const double excess = size > link.longest ? size - link.longest : size < link.shortest ? size - link.shortest : 0.0;
  if (excess == 0) return 0;
  const Vector3d towards = size > 0 ? Vector3d(way / size) : Vector3d(Vector3d::UnitX());
  Vector3d sides[2];
  double yields = 0;
  for (const int k : {0, 1}) {
    const std::size_t i = k == 0 ? link.bone : link.to;
    const Vector3d direction = turned(level.states[i].frame, bones_[i].rest_direction);
    sides[k] = across(towards, direction);
    if (sides[k].norm() < kNoLever) sides[k] = direction.unitOrthogonal();
    yields += mobility_[i] * sides[k].squaredNorm();
  }
  if (!(yields > 0)) return 0;
  turn(link.bone, sides[0] * (excess / yields * mobility_[link.bone]), level);
  turn(link.to, sides[1] * (-excess / yields * mobility_[link.to]), level);
  return std::abs(excess) / link.longest;
}

double ReferenceLinks::slow(const RigLink& link, const Level& level) const {
  const Vector3d way = level.motions[link.to].end - level.motions[link.bone].end;
  const double size = way.norm();
  if (!(size > 0)) return 0;
  const Vector3d towards = way / size;
  const double growing = (level.motions[link.to].velocity - level.motions[link.bone].velocity).dot(towards);
  const bool is_long = size >= link.longest * (1 - kTaut) && growing > 0;
  const bool is_short = size <= link.shortest * (1 + kTaut) && growing < 0;
  if (!is_long && !is_short) return 0;
  const Vector3d side = across(towards, turned(level.states[link.bone].frame, bones_[link.bone].rest_direction));
  const Vector3d to_side = across(towards, turned(level.states[link.to].frame, bones_[link.to].rest_direction));
  const double yields = mobility_[link.bone] * side.squaredNorm() + mobility_[link.to] * to_side.squaredNorm();
  if (!(yields > kNoLever * kNoLever * (mobility_[link.bone] + mobility_[link.to]))) return 0;
  push(link.bone, side * (growing / yields * mobility_[link.bone]), level);
  push(link.to, to_side * (-growing / yields * mobility_[link.to]), level);
  return std::abs(growing);
}

void ReferenceLinks::hold(const Level& level) const {
  const auto before = [&](std::size_t end) {
    return std::ranges::partition_point(links_, [end](const RigLink& link) { return link.bone < end; });
  };
  const std::span<const RigLink> own(before(level.begin), before(level.end));
  const auto repeat = [&](double least, const auto& part) {
    double most = least * 2;
    for (int round = 0; round < kRounds && most > least; ++round) {
      most = 0;
      for (std::size_t i = 0; i < own.size(); ++i) {
        most = std::max(most, part(own[round % 2 == 0 ? i : own.size() - 1 - i]));
      }
    }
  };
  repeat(kWithin, [&](const RigLink& link) { return shorten(link, level); });
  repeat(kSlowest, [&](const RigLink& link) { return slow(link, level); });
}

}  // namespace coif::lab
