#include "lab/passive_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::lab {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// 1 / unfolded; limited for a bone that folds over its parent, whose frame would turn with every small movement.
double per_fold(double unfolded) {
  constexpr double kLeastUnfolded = 0.02;  // 11 degrees from folded over
  return 1 / std::max(unfolded, kLeastUnfolded);
}

/// Share of a joint's stiffness that it has against folding by more than a right angle.
constexpr double kFoldStiffness = 0.01;

/// tan^2 of half the fold minus its value at a right angle; 0 below.
double folded(double per_fold) { return std::max(2 * per_fold - 2, 0.0); }

/// The matrix must be positive definite.
Matrix3d symmetric_inverse(const Matrix3d& m) {
  const double xx = m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2), xy = m(0, 2) * m(1, 2) - m(0, 1) * m(2, 2),
               xz = m(0, 1) * m(1, 2) - m(0, 2) * m(1, 1), yy = m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2),
               yz = m(0, 1) * m(0, 2) - m(0, 0) * m(1, 2), zz = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1);
  const double scale = 1 / (m(0, 0) * xx + m(0, 1) * xy + m(0, 2) * xz);
  Matrix3d inverse;
  inverse << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return scale * inverse;
}

/// Share of a bone's reaction by which a contact gives way, since a contact without a lever cannot be solved.
constexpr double kSoftness = 1.0e-9;

double mass_of(const RigBone& bone) { return bone.length; }

const BoneMotion& carrier(std::span<const RigBone> bones, std::size_t i, const motion::HeadState& head,
                          std::span<const BoneMotion> motions, BoneMotion& joint) {
  if (bones[i].parent >= 0) return motions[std::size_t(bones[i].parent)];
  joint = motion_of_joint(bones[i].joint, head);
  return joint;
}

}  // namespace

std::vector<Carried> carried_at_rest(std::span<const RigBone> bones) {
  std::vector<Vector3d> starts(bones.size()), tails(bones.size());
  std::vector<Carried> carried(bones.size());
  for (std::size_t i = 0; i < bones.size(); ++i) {
    starts[i] = bones[i].parent < 0 ? bones[i].joint : tails[std::size_t(bones[i].parent)];
    tails[i] = starts[i] + bones[i].length * bones[i].rest_direction;
    for (int up = int(i); up >= 0; up = bones[std::size_t(up)].parent) {
      const Vector3d from = tails[i] - starts[std::size_t(up)];
      carried[std::size_t(up)].inertia += mass_of(bones[i]) * from.squaredNorm();
      carried[std::size_t(up)].arm += mass_of(bones[i]) * from.norm();
    }
  }
  return carried;
}

double fastest_rate(std::span<const RigBone> bones) {
  const std::vector<Carried> carried = carried_at_rest(bones);
  double fastest = 0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const double ratio = 16 * carried[i].inertia / std::pow(bones[i].length, 3);
    fastest = std::max({fastest, bones[i].damping * ratio, std::sqrt(bones[i].stiffness * ratio)});
  }
  return fastest;
}

PassiveModel::PassiveModel(std::span<const RigBone> bones)
    : bones_(bones),
      carried_(carried_at_rest(bones)),
      turns_(bones.size()),
      bends_(bones.size()),
      links_(bones.size()),
      forces_(bones.size()),
      torques_(bones.size()) {}

const Matrix3d& PassiveModel::turn_above(std::size_t i) const {
  return bones_[i].parent < 0 ? head_turn_ : turns_[std::size_t(bones_[i].parent)];
}

/// The forces at the joint of a bone whose direction and arc are known.
void PassiveModel::load(std::size_t i, const motion::HeadState& head, const BoneMotion& parent,
                        const BoneMotion& motion) {
  const RigBone& bone = bones_[i];
  Bend& bend = bends_[i];
  const double share = bone.parent_share;
  const Vector3d pull = bone.pull_direction(), by_parent = turn_above(i) * pull, by_head = head_turn_ * pull;
  const Vector3d base = share * parent.angular_velocity + (1 - share) * head.angular_velocity;
  const Vector3d drag = bone.damping * carried_[i].inertia * across(motion.angular_velocity - base, bend.direction);
  const double stiffness = bone.stiffness * carried_[i].inertia;
  const Vector3d of_parent = stiffness * bend.direction.cross(by_parent);
  const double fold = folded(bend.per_fold) * bend.per_fold;
  const Vector3d unfold = 6 * kFoldStiffness * stiffness * fold * fold * bend.direction.cross(bend.arc);
  bend.torque = share * of_parent + (1 - share) * stiffness * bend.direction.cross(by_head) - drag + unfold;
  bend.reaction = share * (of_parent - drag) + unfold;
}

void PassiveModel::gather(std::size_t i, double opening) {
  Links& links = links_[i];
  const Matrix3d inverse = symmetric_inverse(links.mass);
  const Vector3d& direction = bends_[i].direction;
  links.by_pull = inverse * direction;
  links.push = inverse * links.push;
  links.yields = 1 / direction.dot(links.by_pull);
  links.pull = (opening + direction.dot(links.push)) * links.yields;
  if (bones_[i].parent < 0) return;
  Links& above = links_[std::size_t(bones_[i].parent)];
  above.mass += links.yields * direction * direction.transpose();
  above.push += links.pull * direction;
}

Vector3d PassiveModel::release(std::size_t i, const Vector3d& of_start) const {
  const Links& links = links_[i];
  return links.push - (links.pull - bends_[i].direction.dot(of_start) * links.yields) * links.by_pull;
}

void PassiveModel::rates(const SolverScene& scene, const motion::HeadState& head, std::span<const BoneState> states,
                         std::span<BoneMotion> motions, std::span<BoneRates> rates) {
  const Vector3d air = scene.wind + head.velocity * bones_.front().air_follow;
  BoneMotion joint;
  head_turn_ = head.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const RigBone& bone = bones_[i];
    const BoneMotion& parent = carrier(bones_, i, head, motions, joint);
    BoneMotion& motion = motions[i];
    motion.frame = states[i].frame.normalized();
    turns_[i] = motion.frame.toRotationMatrix();
    const Vector3d direction = turns_[i] * bone.rest_direction, arc = turn_above(i) * bone.rest_direction;
    bends_[i].direction = direction;
    bends_[i].arc = arc;
    bends_[i].per_fold = per_fold(1 + arc.dot(direction));
    const Vector3d turning = across(states[i].turning, direction), swing = direction.cross(turning);
    const double along = (arc + direction).dot(parent.angular_velocity) - arc.dot(swing);
    motion.end = parent.end + bone.length * direction;
    motion.velocity = parent.velocity + bone.length * turning;
    motion.angular_velocity = swing + direction * (along * bends_[i].per_fold);
    load(i, head, parent, motion);
    forces_[i] = mass_of(bone) * (scene.gravity * bone.gravity_scale - bone.friction * (motion.velocity - air));
    torques_[i] = bends_[i].torque;
    links_[i] = {mass_of(bone) * Matrix3d::Identity(), Vector3d::Zero(), Vector3d::Zero()};
    rates[i].turning = turning;
  }
  for (std::size_t i = bones_.size(); i-- > 0;) {
    const Bend& bend = bends_[i];
    const double length = bones_[i].length;
    const double spin = torques_[i].dot(bend.direction) * bend.per_fold;
    const Vector3d force = (torques_[i] - spin * bend.arc).cross(bend.direction) / length;
    links_[i].push += forces_[i] + force;
    if (bones_[i].parent >= 0) {
      const auto up = std::size_t(bones_[i].parent);
      forces_[up] -= force;
      torques_[up] += spin * (bend.arc + bend.direction) - bend.reaction;
    }
    gather(i, length * rates[i].turning.squaredNorm());
  }
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const BoneMotion& parent = carrier(bones_, i, head, motions, joint);
    motions[i].acceleration = release(i, parent.acceleration);
    rates[i].turning = (motions[i].acceleration - parent.acceleration) / bones_[i].length;
    const Vector3d half = 0.5 * motions[i].angular_velocity;
    rates[i].frame = (Quaterniond(0, half.x(), half.y(), half.z()) * states[i].frame).coeffs();
  }
}

/// By Gauss's principle, with all constraints in one dense matrix, as chains are short. Contacts that would have to
/// pull are left out, the strongest first.
Eigen::VectorXd PassiveModel::nearest(std::span<const BoneContact> contacts, const Eigen::VectorXd& opening,
                                      std::span<const double> entering) const {
  const auto links = Eigen::Index(bones_.size()), all = links + Eigen::Index(contacts.size());
  Eigen::MatrixXd bonds = Eigen::MatrixXd::Zero(all, 3 * links);
  Eigen::VectorXd excess(all), mobile(3 * links);
  for (Eigen::Index row = 0; row < all; ++row) {
    const BoneContact* const contact = row < links ? nullptr : &contacts[std::size_t(row - links)];
    const std::size_t i = contact == nullptr ? std::size_t(row) : contact->bone;
    const Vector3d way = contact == nullptr ? bends_[i].direction : contact->normal;
    const double share = contact == nullptr ? 1 : contact->share;
    bonds.block<1, 3>(row, 3 * Eigen::Index(i)) = share * way.transpose();
    if (const int up = bones_[i].parent; up >= 0) {
      bonds.block<1, 3>(row, 3 * up) = (contact == nullptr ? -1 : 1 - share) * way.transpose();
    }
    excess[row] = contact == nullptr ? opening[row] : entering[std::size_t(row - links)];
  }
  for (Eigen::Index k = 0; k < links; ++k) mobile.segment<3>(3 * k).setConstant(1 / mass_of(bones_[std::size_t(k)]));
  Eigen::MatrixXd yields = bonds * mobile.asDiagonal() * bonds.transpose();
  for (Eigen::Index k = links; k < all; ++k) yields(k, k) += kSoftness * yields(0, 0);
  std::vector<Eigen::Index> held(static_cast<std::size_t>(all));
  std::iota(held.begin(), held.end(), Eigen::Index(0));
  for (;;) {
    const Eigen::VectorXd impulses = Eigen::MatrixXd(yields(held, held)).ldlt().solve(-excess(held));
    std::size_t worst = held.size();
    for (auto k = std::size_t(links); k < held.size(); ++k) {
      const double least = worst < held.size() ? impulses[Eigen::Index(worst)] : 0;
      if (impulses[Eigen::Index(k)] < least) worst = k;
    }
    if (worst == held.size())
      return mobile.asDiagonal() * (Eigen::MatrixXd(bonds(held, Eigen::all)).transpose() * impulses);
    held.erase(held.begin() + std::ptrdiff_t(worst));
  }
}

void PassiveModel::lift(std::span<const BoneContact> contacts, std::span<const double> depths,
                        std::span<const Vector3d> directions, std::vector<Vector3d>& ways) {
  for (std::size_t i = 0; i < bones_.size(); ++i) bends_[i].direction = directions[i];
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(Eigen::Index(bones_.size()));
  std::vector<double> entering;
  for (const double depth : depths) entering.push_back(-depth);
  const Eigen::VectorXd changes = nearest(contacts, none, entering);
  ways.resize(bones_.size());
  for (std::size_t i = 0; i < bones_.size(); ++i) ways[i] = changes.segment<3>(3 * Eigen::Index(i));
}

void PassiveModel::keep_links(const motion::HeadState& head, std::span<const BoneContact> contacts,
                              std::span<BoneMotion> motions, std::span<BoneState> states) {
  BoneMotion joint;
  Eigen::VectorXd opening(bones_.size());
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    bends_[i].direction = turned(motions[i].frame, bones_[i].rest_direction);
    const BoneMotion& parent = carrier(bones_, i, head, motions, joint);
    opening[Eigen::Index(i)] = bends_[i].direction.dot(motions[i].velocity - parent.velocity);
  }
  std::vector<double> entering;
  for (const BoneContact& at : contacts) {
    const Vector3d start = carrier(bones_, at.bone, head, motions, joint).velocity;
    entering.push_back(at.normal.dot(start + at.share * (motions[at.bone].velocity - start) - at.surface));
  }
  const Eigen::VectorXd changes = nearest(contacts, opening, entering);
  for (std::size_t i = 0; i < bones_.size(); ++i) motions[i].velocity += changes.segment<3>(3 * Eigen::Index(i));
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const BoneMotion& parent = carrier(bones_, i, head, motions, joint);
    states[i].turning = across((motions[i].velocity - parent.velocity) / bones_[i].length, bends_[i].direction);
  }
}

double PassiveModel::energy(const SolverScene& scene, const motion::HeadState& head,
                            std::span<const BoneState> states) const {
  std::vector<BoneMotion> motions(bones_.size());
  double sum = 0;
  BoneMotion joint;
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const RigBone& bone = bones_[i];
    const BoneMotion& parent = carrier(bones_, i, head, motions, joint);
    motions[i].frame = states[i].frame;
    const Vector3d direction = turned(states[i].frame, bone.rest_direction);
    motions[i].end = parent.end + bone.length * direction;
    motions[i].velocity = parent.velocity + bone.length * states[i].turning;
    const double cosine = bone.parent_share * direction.dot(turned(parent.frame, bone.pull_direction())) +
                          (1 - bone.parent_share) * direction.dot(turned(head.rotation, bone.pull_direction()));
    sum += mass_of(bone) *
           (0.5 * motions[i].velocity.squaredNorm() - bone.gravity_scale * scene.gravity.dot(motions[i].end));
    const double fold = folded(per_fold(1 + direction.dot(turned(parent.frame, bone.rest_direction))));
    sum += bone.stiffness * carried_[i].inertia * (1 - cosine + kFoldStiffness * fold * fold * fold);
  }
  return sum;
}

}  // namespace coif::lab
