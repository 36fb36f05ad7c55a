#include "import/vrm_springs.h"

#include "base/geometry.h"
#include "gltf/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::importer {
namespace {

using nlohmann::json;
using Kind = SourceLimit::Kind;

constexpr double kHalfTurn = std::numbers::pi;
/// Error of a quaternion's length: with a larger one it was written by mistake.
constexpr double kFarFromUnit = 1.0e-2;

struct KindWords {
  Kind kind;
  const char* name;
  const char* angles[2];  ///< Null: the kind has no second angle.
  double most[2];         ///< Larger angles are reduced to this.
};

constexpr KindWords kKinds[] = {{Kind::kCone, "cone", {"angle", nullptr}, {kHalfTurn, 0}},
                                {Kind::kHinge, "hinge", {"angle", nullptr}, {kHalfTurn, 0}},
                                {Kind::kSpherical, "spherical", {"pitch", "yaw"}, {kHalfTurn, kHalfTurn / 2}}};

/// False where an angle is missing or negative.
bool read_angles(const json& values, const KindWords& words, SourceLimit& limit) {
  for (int k = 0; k < 2 && words.angles[k] != nullptr; ++k) {
    const auto angle = number_of(member(values, words.angles[k]));
    if (!angle || *angle < 0) return false;
    limit.angles[k] = std::min(*angle, words.most[k]);
  }
  return true;
}

/// False where four numbers are no rotation.
bool read_rotation(const json& value, Eigen::Quaterniond& rotation) {
  if (value.is_null()) return true;
  if (!value.is_array() || value.size() != 4) return false;
  for (int k = 0; k < 4; ++k) rotation.coeffs()[k] = number_of(value[std::size_t(k)]).value_or(0);  // x, y, z, w
  if (!(std::abs(rotation.norm() - 1) < kFarFromUnit)) return false;
  rotation.normalize();
  return true;
}

}  // namespace

SourceLimit read_limit(const json& joint, const std::string& whose, SpringSink& sink) {
  const json& extension = member(member(joint, "extensions"), "VRMC_springBone_limit");
  if (extension.is_null()) return {};
  const json& given = member(extension, "limit");
  SourceLimit limit;
  const KindWords* chosen = nullptr;
  std::size_t count = 0;
  for (const KindWords& words : kKinds) {
    if (!member(given, words.name).is_object()) continue;
    chosen = &words;
    ++count;
  }
  const auto reject = [&](const char* why) {
    sink.ignore(fmt::format("{}: a joint's limit {}; ignored", whose, why));
    return SourceLimit{};
  };
  if (count != 1) return reject("is not one of cone, hinge and spherical");
  limit.kind = chosen->kind;
  const json& values = member(given, chosen->name);
  if (!read_angles(values, *chosen, limit)) return reject("has no angle of 0 or more");
  if (!read_rotation(member(values, "rotation"), limit.rotation))
    return reject("has a rotation that is no unit quaternion");
  return limit;
}

Eigen::Quaterniond limit_axes(const SourceModel& model, std::uint32_t joint, std::uint32_t tail) {
  const Eigen::Affine3d& node = model.nodes[joint].model_from_node;
  const Eigen::Vector3d along = (node.inverse() * model.nodes[tail].model_from_node.translation()).stableNormalized();
  const Eigen::Quaterniond axes(rotation_part(node));
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  if (!(along.norm() > 0.5)) return axes;  // the tail is at the joint, or the node has no volume: nothing swings
  if (along.y() <= -1) return axes * Eigen::Quaterniond(0, 1, 0, 0);
  Eigen::Quaterniond turn(1 + along.y(), 0, 0, 0);
  turn.vec() = up.cross(along);
  if (!(turn.norm() > 1.0e-8)) turn = Eigen::Quaterniond(0, 1, 0, 0);
  return (axes * turn.normalized()).normalized();
}

}  // namespace coif::importer
