#include "report/stability/measure_stability.h"
#include "write/asset_writer.h"
#include "write/pose_oscillator.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr double kRate = 60;     // Steps per second at which resistances hold.
constexpr double kBehind = 0.1;  // Metres from the head's joint to its surface, backwards.

void store(const Vector3d& v, float (&to)[3]) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = float(v[axis]);
}

BoneRecord rigid_head() {
  BoneRecord head{};
  head.parent = head.chain = head.name = kNone;
  return head;
}

DynamicsRecord dynamics_of(const StressRig& rig, double resistance) {
  const PoseOscillator oscillator = oscillator_of(resistance, kRate);
  DynamicsRecord record{};
  record.resistance = float(resistance);
  record.friction = float(rig.friction);
  record.gravity_scale = float(rig.gravity_scale);
  record.authoring_rate = float(kRate);
  record.stiffness = float(oscillator.stiffness);
  const double asked = std::max(2 * rig.damping_ratio * std::sqrt(oscillator.stiffness) - rig.friction, 0.0);
  record.damping = float(rig.damping_ratio < 1 ? asked : std::max(oscillator.damping, asked));
  record.torsion = float(rig.torsion);
  record.angle_limit = kNoAngleLimit;
  record.parent_share = 1;
  return record;
}

ColliderRecord head_sphere(double radius) {
  ColliderRecord record{};
  store(Vector3d(0, 0, radius - kBehind), record.center);
  store(Vector3d::Constant(radius), record.radii);
  record.rotation[3] = 1;
  return record;
}

LimitRecord limit_of(const StressRig& rig, const Vector3d& rest, std::uint32_t number) {
  LimitRecord record{};
  record.rotation[3] = 1;
  if (rig.limit == LimitKind::kUnlimited) return record;
  record.kind = rig.limit;
  record.angles[0] = rig.limit_angles[0];
  if (rig.limit == LimitKind::kSpherical) record.angles[1] = rig.limit_angles[1];
  const Eigen::Quaterniond axes = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), rest) *
                                  Eigen::AngleAxisd(0.7 * (number + 1), Vector3d::UnitY());
  for (int k = 0; k < 4; ++k) record.rotation[k] = float(axes.coeffs()[k]);
  return record;
}

/// Adds the chains one by one.
class StressContents {
 public:
  StressContents(const StressRig& rig, ChainModel model) : rig_(rig), model_(model) {
    contents_.skeleton.head_rotation[3] = 1;
    contents_.bones.push_back(rigid_head());
    contents_.dynamics.push_back(dynamics_of(rig, 0));
    contents_.colliders.push_back(head_sphere(rig.head_radius));
    if (rig.limit != LimitKind::kUnlimited) contents_.limits.push_back(limit_of({}, {}, 0));
  }

  AssetContents make() {
    for (std::uint32_t chain = 0; chain < rig_.chains; ++chain) add_chain(chain);
    if (rig_.is_linked) add_links();
    return std::move(contents_);
  }

 private:
  /// A bone to be: its number in the tree, level by level, and where its parent is stored.
  struct Place {
    std::uint32_t number;
    std::uint32_t parent;
  };

  void add_chain(std::uint32_t chain) {
    const double side = (double(chain) - 0.5 * (rig_.chains - 1)) * rig_.chain_spacing;
    const auto first = std::uint32_t(contents_.bones.size());
    contents_.chains.push_back({first, rig_.bones_per_chain, 0, model_});
    depth_.clear();
    // Depth first, as the format wants trees: bone i of the tree has the children branching * i + 1 and on.
    std::vector<Place> waiting = {{0, 0}};
    while (!waiting.empty()) {
      const Place place = waiting.back();
      waiting.pop_back();
      const auto here = std::uint32_t(contents_.bones.size());
      if (place.number == 0) {
        add_bone(chain, 0, Vector3d(side, 0, -kBehind - rig_.root_offset), 0, place.number);
      } else {
        add_bone(chain, place.parent, end_of(place.parent), depth_[place.parent - first] + 1, place.number);
      }
      for (std::uint32_t k = rig_.branching; k > 0; --k) {
        const std::uint32_t child = rig_.branching * place.number + k;
        if (child < rig_.bones_per_chain) waiting.push_back({child, here});
      }
    }
  }

  /// Adds links by depth, as the format demands.
  void add_links() {
    const std::uint32_t count = rig_.bones_per_chain;
    for (std::uint32_t depth = 0; depth < count; ++depth) {
      for (std::uint32_t bone = 1 + count; bone < contents_.bones.size(); ++bone) {
        if (depth_[(bone - 1) % count] != depth) continue;
        const auto gap = float((end_of(bone) - end_of(bone - count)).norm());
        contents_.links.push_back({bone, bone - count, 0.5f * gap, float(1 + rig_.link_stretch) * gap});
      }
    }
  }

  [[nodiscard]] Vector3d end_of(std::uint32_t bone) const {
    const BoneRecord& record = contents_.bones[bone];
    const auto joint = Eigen::Map<const Eigen::Vector3f>(record.joint).cast<double>();
    const auto direction = Eigen::Map<const Eigen::Vector3f>(record.rest_direction).cast<double>();
    return joint + direction * double(record.length);
  }

  void add_bone(std::uint32_t chain, std::uint32_t parent, const Vector3d& joint, std::uint32_t depth,
                std::uint32_t number) {
    const std::uint32_t sibling = number == 0 ? 0 : (number - 1) % rig_.branching;
    BoneRecord bone{};
    bone.parent = parent;
    bone.kind = BoneKind::kSimulated;
    bone.chain = chain;
    bone.name = kNone;
    bone.colliders = 1;
    const double fan = rig_.branching > 1 ? 0.3 * (double(sibling) - 0.5 * (rig_.branching - 1)) : 0.0;
    store(joint, bone.joint);
    const Vector3d rest = Vector3d(fan, -1, depth == 0 ? -0.6 : -0.05).normalized();
    store(rest, bone.rest_direction);
    if (rig_.limit != LimitKind::kUnlimited) contents_.limits.push_back(limit_of(rig_, rest, number));
    const bool is_last = number + 1 == rig_.bones_per_chain;
    bone.length = float(rig_.bone_length * (depth % 2 == 1 ? rig_.length_ratio : 1) * (is_last ? rig_.tip_ratio : 1));
    contents_.bones.push_back(bone);
    const double share = rig_.bones_per_chain > 1 ? double(number) / (rig_.bones_per_chain - 1) : 0.0;
    const double resistance = rig_.root_resistance + (rig_.tip_resistance - rig_.root_resistance) * share;
    contents_.dynamics.push_back(dynamics_of(rig_, resistance));
    depth_.push_back(depth);
  }

  const StressRig& rig_;
  ChainModel model_;
  AssetContents contents_;
  std::vector<std::uint32_t> depth_;  ///< Depth of the present chain's bones.
};

}  // namespace

StressAsset::StressAsset(const StressRig& rig, ChainModel model) : opened_(StressContents(rig, model).make()) {}

}  // namespace coif::report
