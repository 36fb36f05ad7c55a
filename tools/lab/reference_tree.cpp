#include "lab/passive_model.h"
#include "lab/reference_links.h"
#include "lab/reference_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace coif::lab {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A twist that decays faster is hardly visible, and would need shorter steps than everything else. Bones that never
/// twist have no such rate.
constexpr double kFastestTorsion = 5000;  // 1/s

/// Directions nearer than this to each other have no plane between them.
constexpr double kSameDirection = 1.0e-9;

/// Depth that counts as a contact, share of the collider's or the bone's size.
constexpr double kTouches = 1.0e-10;

void turn_to(const Vector3d& direction, const RigBone& bone, BoneState& state) {
  state.frame = shortest_arc(turned(state.frame, bone.rest_direction), direction) * state.frame;
  state.turning = across(state.turning, direction);
}

/// The frame of a bone that never twists follows from its direction and its parent's frame; any other rotation is
/// dropped.
void untwist(const RigBone& bone, const Quaterniond& parent_frame, BoneState& state) {
  if (never_twists(bone)) state.frame = frame_of_arc(bone, parent_frame, turned(state.frame, bone.rest_direction));
}

BoneMotion motion_of(const RigBone& bone, const BoneMotion& parent, const BoneState& state) {
  BoneMotion motion;
  motion.frame = state.frame;
  motion.end = parent.end + bone.length * turned(state.frame, bone.rest_direction);
  motion.velocity = parent.velocity + bone.length * state.turning;
  motion.angular_velocity = angular_velocity_of(bone, parent, state);
  return motion;
}

/// The state of a bone whose parent was held, as if the parent's tail had been pushed evenly throughout the step. The
/// bone's own tail goes to its free place, except for its length and, in a cascade, for the damping, which acts against
/// the real motion of the default position.
void follow_parent(const RigBone& bone, const BoneMotion& parent, const BoneMotion& free_parent,
                   const motion::HeadState& head, const Vector3d& direction_before, bool is_cascade, BoneState& state) {
  const Vector3d shift = (parent.end - free_parent.end) / bone.length;
  const Vector3d way = turned(state.frame, bone.rest_direction) - shift;
  if (!(way.norm() > kSameDirection)) return;
  const Vector3d target_shift =
      shift + target_of(bone, parent, head).direction - target_of(bone, free_parent, head).direction;
  const Vector3d push =
      (is_cascade ? bone.damping : 0.0) * target_shift - (parent.velocity - free_parent.velocity) / bone.length;
  const Vector3d direction = way.normalized();
  const Vector3d mean = direction_before + direction;
  state.turning += mean.norm() > kSameDirection ? across(push, mean.normalized()) : push;
  turn_to(direction, bone, state);
}

/// Removes from the bone the velocity that brings the touching point, `along` metres from its start, towards a collider
/// that moves with the head. It stops a bone and never throws it: where the start itself sinks towards the collider,
/// the bone is turned out of the way but does not gain that speed. Over a short lever it could be any speed, since
/// bones do not hold back their parents.
void stop_inwards(const Vector3d& normal, double along, const BoneMotion& parent, const motion::HeadState& head,
                  const RigBone& bone, BoneState& state) {
  const Vector3d direction = turned(state.frame, bone.rest_direction);
  const Vector3d side = across(normal, direction);
  const double slope = side.norm();
  if (slope < kSameDirection) return;
  const Vector3d point = parent.end + along * direction;
  const Vector3d surface = head.velocity + head.angular_velocity.cross(point);
  const double inwards = -(parent.velocity + along * state.turning - surface).dot(normal);
  const double own = -(state.turning - head.angular_velocity.cross(direction)).dot(side / slope);
  const double lost = std::min(own, inwards / (along * slope));
  if (lost > 0) state.turning += side * (lost / slope);
}

}  // namespace

ReferenceTree::ReferenceTree(const Rig& rig, std::vector<std::uint32_t> members, const SolverScene& scene)
    : members_(std::move(members)), solids_(solid_shapes(rig.colliders)), scene_(scene) {
  std::vector<int> place(rig.bones.size(), -1);
  for (std::size_t i = 0; i < members_.size(); ++i) {
    RigBone bone = rig.bones[members_[i]];
    if (bone.parent >= 0) bone.parent = place[std::size_t(bone.parent)];
    if (bone.model == ChainModel::kPassive) bone.torsion = double(kShortestArc);
    if (!never_twists(bone)) bone.torsion = std::min(bone.torsion, kFastestTorsion);
    if (solids_.size() < 32) bone.colliders &= (1u << solids_.size()) - 1;
    is_free_ = is_free_ && bone.colliders == 0 && bone.angle_limit >= double(kNoAngleLimit) &&
               bone.limit.kind == LimitKind::kUnlimited;
    place[members_[i]] = int(i);
    bones_.push_back(bone);
  }
  find_links(rig, place);
  if (bones_.front().model == ChainModel::kPassive) passive_ = std::make_unique<PassiveModel>(bones_);
  states_.resize(bones_.size());
  trial_.resize(bones_.size());
  motions_.resize(bones_.size());
  free_motions_.resize(bones_.size());
  for (auto& rates : rates_) rates.resize(bones_.size());
  moved_.resize(bones_.size());
  turned_.resize(bones_.size());
  before_.resize(bones_.size());
}

ReferenceTree::ReferenceTree(ReferenceTree&&) noexcept = default;
ReferenceTree::~ReferenceTree() = default;

void ReferenceTree::reset(const motion::HeadState& head) {
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const Vector3d direction = turned(head.rotation, bones_[i].rest_direction);
    states_[i] = {head.rotation, head.angular_velocity.cross(direction)};
  }
}

void ReferenceTree::jump(const Quaterniond& turn) {
  for (BoneState& state : states_) state = {turn * state.frame, turned(turn, state.turning)};
}

void ReferenceTree::step(const HeadStep& step) {
  integrate(step);
  if (!is_free_) hold(step.end);
}

void ReferenceTree::find_rates(const motion::HeadState& head, const std::vector<BoneState>& states,
                               std::vector<BoneRates>& rates) {
  if (passive_) {
    passive_->rates(scene_, head, states, motions_, rates);
  } else {
    free_rates(bones_, scene_, head, states, motions_, rates);
  }
}

void ReferenceTree::integrate(const HeadStep& step) {
  for (std::size_t i = 0; i < states_.size(); ++i) before_[i] = turned(states_[i].frame, bones_[i].rest_direction);
  const auto try_after = [&](const std::vector<BoneRates>& rates, double dt) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      trial_[i].frame.coeffs() = states_[i].frame.coeffs() + dt * rates[i].frame;
      trial_[i].turning = states_[i].turning + dt * rates[i].turning;
    }
  };
  find_rates(step.start, states_, rates_[0]);
  try_after(rates_[0], step.dt / 2);
  find_rates(step.middle, trial_, rates_[1]);
  try_after(rates_[1], step.dt / 2);
  find_rates(step.middle, trial_, rates_[2]);
  try_after(rates_[2], step.dt);
  find_rates(step.end, trial_, rates_[3]);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto mean = [&](auto rate) {
      return (rate(rates_[0][i]) + 2 * rate(rates_[1][i]) + 2 * rate(rates_[2][i]) + rate(rates_[3][i])).eval();
    };
    BoneState& state = states_[i];
    state.frame.coeffs() += step.dt / 6 * mean([](const BoneRates& r) { return r.frame; });
    state.frame.normalize();
    state.turning += step.dt / 6 * mean([](const BoneRates& r) { return r.turning; });
    state.turning = across(state.turning, turned(state.frame, bones_[i].rest_direction));
  }
  untwist_all(step.end.rotation);
}

void ReferenceTree::untwist_all(const Quaterniond& head_rotation) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const int parent = bones_[i].parent;
    untwist(bones_[i], parent < 0 ? head_rotation : states_[std::size_t(parent)].frame, states_[i]);
  }
}

/// Passive bones leave colliders together, by the shortest way for the whole chain. A turn about its start alone would
/// also undo the turn of a bone that comes to lie on a collider along its whole length.
void ReferenceTree::lift(const motion::HeadState& head) {
  constexpr int kRounds = 4;
  const Quaterniond to_head = head.rotation.conjugate();
  std::vector<Vector3d> directions(bones_.size()), ends(bones_.size()), ways;
  std::vector<double> depths;
  velocities_.resize(bones_.size());
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const int up = bones_[i].parent;
    const Vector3d start = up < 0 ? motion_of_joint(bones_[i].joint, head).velocity : velocities_[std::size_t(up)];
    velocities_[i] = start + bones_[i].length * states_[i].turning;
  }
  for (int round = 0; round < kRounds; ++round) {
    std::vector<BoneContact> found;
    depths.clear();
    for (std::size_t i = 0; i < bones_.size(); ++i) {
      const RigBone& bone = bones_[i];
      const Vector3d start = bone.parent < 0 ? turned(head.rotation, bone.joint) : ends[std::size_t(bone.parent)];
      directions[i] = turned(states_[i].frame, bone.rest_direction);
      ends[i] = start + bone.length * directions[i];
      const HairSegment segment{turned(to_head, start), turned(to_head, directions[i]), bone.length, bone.hit_radius};
      for (std::uint32_t left = bone.colliders; left != 0; left &= left - 1) {
        const SolidShape& solid = solids_[std::size_t(std::countr_zero(left))];
        const SolidContact at = nearest_contact(solid, segment);
        if (!(at.gap < -kTouches * std::max(solid.size, bone.length) && at.along > 0)) continue;
        const Vector3d point = start + at.along * directions[i];
        found.push_back({i, at.along / bone.length, turned(head.rotation, at.normal),
                         head.velocity + head.angular_velocity.cross(point)});
        depths.push_back(-at.gap);
      }
    }
    if (found.empty()) return;
    passive_->lift(found, depths, directions, ways);
    if (round == 0) contacts_ = found;
    for (std::size_t i = 0; i < bones_.size(); ++i) {
      const int up = bones_[i].parent;
      const Vector3d way = up < 0 ? ways[i] : Vector3d(ways[i] - ways[std::size_t(up)]);
      turn_to((directions[i] + way / bones_[i].length).normalized(), bones_[i], states_[i]);
    }
    untwist_all(head.rotation);
  }
}

void ReferenceTree::hold(const motion::HeadState& head) {
  contacts_.clear();
  if (passive_) lift(head);
  std::size_t begin = 0, level = 0;
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    hold_bone(i, head);
    if (!links_ || i + 1 != level_ends_[level]) continue;
    hold_links(begin, i + 1, head);
    begin = level_ends_[level++];
  }
  if (passive_ && (!contacts_.empty() || std::ranges::find(moved_, char(1)) != moved_.end())) {
    passive_->keep_links(head, contacts_, motions_, states_);
  }
}

void ReferenceTree::hold_bone(std::size_t i, const motion::HeadState& head) {
  const RigBone& bone = bones_[i];
  const bool is_root = bone.parent < 0;
  const BoneMotion joint = is_root ? motion_of_joint(bone.joint, head) : BoneMotion{};
  const auto up = std::size_t(is_root ? 0 : bone.parent);
  const BoneMotion& parent = is_root ? joint : motions_[up];
  free_motions_[i] = motion_of(bone, is_root ? joint : free_motions_[up], states_[i]);
  moved_[i] = !is_root && moved_[up];
  if (moved_[i]) follow_parent(bone, parent, free_motions_[up], head, before_[i], passive_ == nullptr, states_[i]);
  const bool at_limit = hold_limit(bone, parent, head, states_[i]);
  const bool at_bounds = hold_bounds(bone, parent, states_[i]);
  const bool touches = hold_colliders(i, parent, head);
  const bool held = hold_bounds(bone, parent, states_[i]) || at_limit || at_bounds;
  if (held || touches) moved_[i] = true;
  untwist(bone, parent.frame, states_[i]);
  motions_[i] = motion_of(bone, parent, states_[i]);
  // keep_links() must see each particle's own velocity, not the part that its new direction leaves of it.
  if (passive_ && !held) motions_[i].velocity = velocities_[i];
}

void ReferenceTree::hold_links(std::size_t begin, std::size_t end, const motion::HeadState& head) {
  const auto start_of = [&](std::size_t i) {
    const int up = bones_[i].parent;
    return up < 0 ? motion_of_joint(bones_[i].joint, head) : motions_[std::size_t(up)];
  };
  links_->hold(begin, end, start_of, states_, motions_, turned_);
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::exchange(turned_[i], char(0))) continue;
    const BoneMotion parent = start_of(i);
    moved_[i] = true;
    // Colliders last: as in the runtime, where both cannot be.
    (void)hold_colliders(i, parent, head);
    (void)hold_bounds(bones_[i], parent, states_[i]);
    untwist(bones_[i], parent.frame, states_[i]);
    motions_[i] = motion_of(bones_[i], parent, states_[i]);
  }
}

bool ReferenceTree::hold_limit(const RigBone& bone, const BoneMotion& parent, const motion::HeadState& head,
                               BoneState& state) const {
  if (bone.angle_limit >= double(kNoAngleLimit)) return false;
  const BoneTarget target = target_of(bone, bone.rest_direction, parent, head);
  const double size = target.direction.norm();
  if (!(size > kSameDirection)) return false;
  const Vector3d axis = target.direction / size;
  const Vector3d axis_turning = across(target.turning / size, axis);
  const Vector3d direction = turned(state.frame, bone.rest_direction);
  if (std::acos(std::clamp(direction.dot(axis), -1.0, 1.0)) <= bone.angle_limit) return false;

  Vector3d aside = across(direction, axis);
  aside = aside.norm() > kSameDirection ? aside.normalized() : axis.unitOrthogonal();
  const double cosine = std::cos(bone.angle_limit), sine = std::sin(bone.angle_limit);
  const Vector3d held = cosine * axis + sine * aside;
  turn_to(held, bone, state);
  if (sine < kSameDirection) {
    state.turning = across(axis_turning, held);
    return true;
  }
  const double opening = -(state.turning.dot(axis) + held.dot(axis_turning)) / sine;
  if (opening > 0) state.turning -= opening * (cosine * aside - sine * axis);
  return true;
}

bool ReferenceTree::hold_bounds(const RigBone& bone, const BoneMotion& parent, BoneState& state) const {
  const BoundedBone held = bounded(bone, parent.frame, turned(state.frame, bone.rest_direction));
  if (held.at.beyond <= 0) return false;
  const Vector3d direction = turned(held.axes, held.at.direction);
  const Vector3d with_frame = parent.angular_velocity.cross(direction);
  turn_to(direction, bone, state);
  const Vector3d turning = turned(held.axes.conjugate(), across(state.turning - with_frame, direction));
  state.turning = across(turned(held.axes, stopped(held.at, turning)) + with_frame, direction);
  return true;
}

bool ReferenceTree::hold_colliders(std::size_t i, const BoneMotion& parent, const motion::HeadState& head) {
  constexpr int kRounds = 8;  // Where colliders overlap, leaving one may enter another.
  const RigBone& bone = bones_[i];
  BoneState& state = states_[i];
  if (bone.colliders == 0) return false;
  const Quaterniond to_head = head.rotation.conjugate();
  HairSegment segment{turned(to_head, parent.end), turned(to_head, turned(state.frame, bone.rest_direction)),
                      bone.length, bone.hit_radius};
  bool touched = false, touches = true;
  for (int round = 0; round < kRounds && touches; ++round) {
    touches = false;
    for (std::uint32_t left = bone.colliders; left != 0; left &= left - 1) {
      SolidContact contact;
      if (!turn_clear(solids_[std::size_t(std::countr_zero(left))], segment, contact)) continue;
      touched = touches = true;
      turn_to(turned(head.rotation, segment.direction), bone, state);
      const Vector3d normal = turned(head.rotation, contact.normal);
      if (passive_) {
        const Vector3d point = parent.end + contact.along * turned(state.frame, bone.rest_direction);
        contacts_.push_back(
            {i, contact.along / bone.length, normal, head.velocity + head.angular_velocity.cross(point)});
      } else {
        stop_inwards(normal, contact.along, parent, head, bone, state);
      }
    }
  }
  return touched;
}

void ReferenceTree::bone_ends(const Quaterniond& head_rotation, std::span<Vector3d> ends) const {
  const Quaterniond to_head = head_rotation.conjugate();
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const RigBone& bone = bones_[i];
    const Vector3d start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    ends[i] = start + bone.length * turned(to_head, turned(states_[i].frame, bone.rest_direction));
  }
}

double ReferenceTree::fastest_turning() const {
  double fastest2 = 0;
  for (const BoneState& state : states_) fastest2 = std::max(fastest2, state.turning.squaredNorm());
  return std::sqrt(fastest2);
}

double ReferenceTree::least_steps_per_second() const {
  // Within the bounds of the method on the axes, 2.8 both ways.
  double fastest = passive_ ? fastest_rate(bones_) / 2.8 : 0;
  for (const RigBone& bone : bones_) {
    const double torsion = never_twists(bone) ? 0 : bone.torsion;
    fastest = std::max({fastest, std::sqrt(bone.stiffness), bone.damping + bone.friction, torsion});
  }
  return fastest;
}

}  // namespace coif::lab
