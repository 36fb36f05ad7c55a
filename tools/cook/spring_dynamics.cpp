#include "cook/spring_dynamics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr double kGravity = 9.81;           ///< Metres per second squared, of the scene that gravity_scale refers to.
constexpr double kLeastKept = 1.0e-4;       ///< Share of the velocity; a drag of 1 keeps none, and friction has no end.
constexpr double kMostGravity = 1000;       ///< What a DynamicsRecord may hold.
constexpr double kVertical = 1.0 - 1.0e-4;  ///< Cosine of a direction that counts as down.

bool has_sideways_gravity(const SourceSpringJoint& joint) {
  return joint.gravity_power != 0 && std::abs(joint.gravity_direction.y()) < kVertical;
}

}  // namespace

DynamicsRecord dynamics_of_joint(const SourceSpringJoint& joint, double length) {
  const double turn = joint.stiffness / (kSpringRate * joint.length);
  const double acceleration = joint.gravity_power * -joint.gravity_direction.y() * kSpringRate;
  const double gravity_scale = acceleration / kGravity * (length / joint.length);
  DynamicsRecord record{};
  record.resistance = float(turn / (1 + turn));
  record.friction = float(-std::log(std::max(1 - joint.drag, kLeastKept)) * kSpringRate);
  record.gravity_scale = float(std::clamp(gravity_scale, -kMostGravity, kMostGravity));
  record.authoring_rate = float(kSpringRate);
  return record;
}

std::vector<std::string> describe_lost_settings(const SourceModel& source, const std::vector<BoneJoint>& joints) {
  const SourceSpring* sideways = nullptr;
  const SourceSpring* centered = nullptr;
  for (const BoneJoint& bone : joints) {
    if (!bone) continue;
    if (sideways == nullptr && has_sideways_gravity(*bone.joint)) sideways = bone.spring;
    if (centered == nullptr && bone.spring->center != kNoIndex) centered = bone.spring;
  }
  std::vector<std::string> lost;
  if (sideways != nullptr) {
    lost.push_back(
        fmt::format("spring '{}': its gravity is not vertical; only the vertical part is kept (of other such "
                    "springs too); let the game's wind push sideways",
                    sideways->name));
  }
  if (centered != nullptr) {
    lost.push_back(
        fmt::format("spring '{}' has the center '{}', whose motion it would not feel; here hair feels every "
                    "motion of the head (as on other such springs); if it swings too much, raise the drag",
                    centered->name, source.nodes[centered->center].name));
  }
  return lost;
}

}  // namespace coif
