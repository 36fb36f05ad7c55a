#include "report/stability/stress_meters.h"

#include "lab/reference_model.h"

#include <algorithm>
#include <limits>

namespace coif::report {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

LimitMeter::LimitMeter(const lab::Rig& rig) : rig_(rig), frames_(rig.bones.size()) {
  const auto is_seen = [](const lab::RigBone& bone) {
    return lab::never_twists(bone) || bone.model == ChainModel::kPassive;
  };
  const auto is_bounded = [](const lab::RigBone& bone) { return bone.limit.kind != LimitKind::kUnlimited; };
  sees_limits_ = std::ranges::any_of(rig.bones, is_bounded) && std::ranges::all_of(rig.bones, is_seen);
}

void LimitMeter::look(std::span<const Vector3d> ends) {
  if (!sees_limits_) return;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const lab::RigBone& bone = rig_.bones[i];
    const bool is_root = bone.parent < 0;
    const auto up = std::size_t(is_root ? 0 : bone.parent);
    const Quaterniond parent = is_root ? Quaterniond::Identity() : frames_[up];
    const Vector3d direction = (ends[i] - (is_root ? bone.joint : ends[up])).normalized();
    worst_ = std::max(worst_, lab::bounded(bone, parent, direction).at.beyond);
    frames_[i] = lab::frame_of_arc(bone, parent, direction);
  }
}

double LimitMeter::worst() const { return sees_limits_ ? worst_ : kNothing; }

LinkMeter::LinkMeter(const lab::Rig& rig) : rig_(rig) {
  const std::vector<Vector3d> ends = lab::resting_ends(rig);
  for (const lab::RigLink& link : rig.links) gaps_.push_back((ends[link.bone] - ends[link.to]).norm());
}

void LinkMeter::look(std::span<const Vector3d> ends) {
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const double gap = (ends[rig_.links[i].bone] - ends[rig_.links[i].to]).norm();
    worst_ = std::max(worst_, gap / gaps_[i] - 1);
  }
}

double LinkMeter::worst() const { return gaps_.empty() ? kNothing : worst_; }

}  // namespace coif::report
