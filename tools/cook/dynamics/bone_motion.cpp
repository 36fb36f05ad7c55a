#include "cook/dynamics/bone_motion.h"

#include "write/pose_oscillator.h"

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

/// The resistance that Algorithm 1 needs for this stiffness at this rate.
double resistance_for(double stiffness, double rate) {
  const double pull = stiffness / (rate * rate);
  return pull / (1 + pull);
}

}  // namespace

double natural_rate(const DynamicsRecord& record, double length) {
  const double pendulum = length > 0 ? 2 * kGravity * std::abs(record.gravity_scale) / length : 0;
  return std::sqrt(record.stiffness + pendulum);
}

double damping_for(double ratio, double length, const DynamicsRecord& record) {
  return std::max(0.0, 2 * ratio * natural_rate(record, length) - double(record.friction));
}

void bake_oscillator(std::optional<double> ratio, double length, DynamicsRecord& record) {
  const PoseOscillator oscillator = oscillator_of(record.resistance, record.authoring_rate);
  record.stiffness = float(std::min(oscillator.stiffness, double(kMostStiffness)));
  const double damping = ratio ? damping_for(*ratio, length, record) : oscillator.damping;
  record.damping = float(std::min(damping, double(kMostDamping)));
}

double natural_stiffness(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                         double bending_length) {
  const lab::RigBone& bone = rig.bones[i];
  // A root does not turn: its hair is bent from the scalp on, over half a bone.
  const double span =
      bone.parent < 0 ? bone.length / 2 : 0.5 * (bone.length + rig.bones[std::size_t(bone.parent)].length);
  return kGravity * std::pow(bending_length, 3) / span / carried[i].inertia;
}

double swing_rate(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i, double stiffness) {
  const double weight = kGravity * std::abs(rig.bones[i].gravity_scale) * carried[i].arm / carried[i].inertia;
  return std::sqrt(stiffness + weight);
}

void bake_natural(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                  const NaturalMotion& motion, DynamicsRecord& record) {
  record.stiffness = float(std::min(natural_stiffness(rig, carried, i, motion.bending_length), double(kMostStiffness)));
  const double stiffness = double(record.stiffness), swing = swing_rate(rig, carried, i, stiffness);
  constexpr double kTiedBending = 1.6;  // Hairs that lie close slide on each other when their bundle bends.
  const double damped = motion.is_tied ? kTiedBending * stiffness / swing : swing;
  record.damping = float(std::min(2 * motion.damping_ratio * damped, double(kMostDamping)));
  record.resistance = float(resistance_for(stiffness, double(record.authoring_rate)));
}

double friction_of(const HairPreset& preset, bool is_tied) {
  constexpr double kTied = 0.3;
  return is_tied ? kTied * preset.friction : preset.friction;
}

}  // namespace coif::cook
