#include "cook/size/evidence.h"

#include "base/geometry.h"
#include "base/words.h"
#include "cook/select/hair_evidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kSkeleton = 7;      ///< Against a head that is beside the body instead of above it.
constexpr double kHeadBone = 2.5;    ///< Against a head's bone that points sideways.
constexpr double kHangs = 1.5;       ///< Against joints of hair that lead sideways instead of down.
constexpr double kFalls = 4;         ///< Against hair beyond the head that lies beside it instead of below.
constexpr double kMostOfFall = 6;    ///< Upper bound of that: hair may stand, too.
constexpr double kBald = 2;          ///< Against a head without hair on top.
constexpr double kSides = 3;         ///< Against an up axis across which the hair is mirrored.
constexpr double kBeyond = 1.5;      ///< Radii of the head: hair farther out hangs from the head.
constexpr double kMuchBeyond = 0.2;  ///< Share of the surface that is farther out, from which on the evidence is full.
constexpr double kCap = 0.7;         ///< Cosine from up: the top of a head.

constexpr Eigen::Index kAxis[kUps] = {1, 2, 2, 0, 0, 1};
constexpr double kSign[kUps] = {1, 1, -1, 1, -1, -1};

/// The middle of a set of joints.
Vector3d middle_of(const std::vector<Vector3d>& joints) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& joint : joints) sum += joint / double(joints.size());
  return sum;
}

/// `direction` need not be unit; where it is up the likelihood is 0.
UpEvidence evidence_along(const char* what, const Vector3d& direction, double against) {
  UpEvidence evidence{what, {}};
  for (std::size_t up = 0; up < kUps; ++up) {
    evidence.likelihood[up] = -against * (1 - up_direction(up).dot(direction.normalized()));
  }
  return evidence;
}

void weigh_skeleton(const importer::SourceModel& model, std::vector<UpEvidence>& evidence) {
  const std::uint32_t head = guess_head_node(model);
  if (head == importer::kNoIndex) return;
  const Vector3d at = model.nodes[head].model_from_node.translation();
  for (const auto& [part, what] : {std::pair{BodyPart::kFeet, "the head's joint above the feet's"},
                                   {BodyPart::kTrunk, "the head's joint above the trunk's"},
                                   {BodyPart::kNeck, "the head's joint above the neck's"}}) {
    const std::vector<Vector3d> joints = joints_of(model, part);
    if (joints.empty() || (at - middle_of(joints)).norm() < 1.0e-6) continue;
    evidence.push_back(evidence_along(what, at - middle_of(joints), kSkeleton));
    return;
  }
}

/// The direction of the head's bone: towards its end marker, or, as in Blender, along its own Y.
void weigh_head_bone(const importer::SourceModel& model, std::vector<UpEvidence>& evidence) {
  static const std::vector<std::string> ends{"*head*end*", "*head*top*", "*head*nub*", "*head*tip*"};
  const std::uint32_t head = guess_head_node(model);
  if (head == importer::kNoIndex) return;
  const Eigen::Affine3d& at = model.nodes[head].model_from_node;
  for (const importer::SourceNode& node : model.nodes) {
    const Vector3d way = node.model_from_node.translation() - at.translation();
    if (node.parent != head || !matches_any(node.name, ends) || way.norm() < 1.0e-6) continue;
    evidence.push_back(evidence_along("the head's bone points up", way, kHeadBone));
    return;
  }
  if (!matches(model.space.generator, "*blender*")) return;
  evidence.push_back(evidence_along("the head's bone points up", rotation_part(at).col(1), kHeadBone));
}

/// Directions from each joint of hair to those below it.
void weigh_joints(const importer::SourceModel& model, std::vector<UpEvidence>& evidence) {
  const std::vector<bool> hair = find_hair_bones(model);
  std::vector<bool> is_bone = hair;
  for (const importer::SourceMesh& mesh : model.meshes) {
    for (const importer::SourceInfluence& influence : mesh.influences) is_bone[influence.node] = true;
  }
  Vector3d way = Vector3d::Zero();
  double length = 0;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const std::uint32_t parent = model.nodes[n].parent;
    if (parent == importer::kNoIndex || !hair[parent] || !is_bone[n]) continue;
    const Vector3d bone =
        model.nodes[n].model_from_node.translation() - model.nodes[parent].model_from_node.translation();
    way += bone;
    length += bone.norm();
  }
  if (!(length > 0)) return;
  UpEvidence hangs{"hair's joints lead down", {}};
  for (std::size_t up = 0; up < kUps; ++up) hangs.likelihood[up] = -kHangs * (1 + up_direction(up).dot(way) / length);
  evidence.push_back(hangs);
}

/// Centre and area of each triangle.
struct Surface {
  std::vector<std::pair<Vector3d, double>> parts;
  double area = 0;
};

Surface surface_of(const HairMesh& hair) {
  Surface surface;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    const Vector3d a = hair.corner(t, 0).cast<double>(), b = hair.corner(t, 1).cast<double>(),
                   c = hair.corner(t, 2).cast<double>();
    surface.parts.emplace_back((a + b + c) / 3, 0.5 * (b - a).cross(c - a).norm());
    surface.area += surface.parts.back().second;
  }
  return surface;
}

/// The head that there would be under the hair's top, were a direction up. Before it is turned.
struct RoomUnder {
  Vector3d center;
  double radius;
};

RoomUnder room_under(const HairMesh& hair, std::size_t up) {
  HairMesh turned;
  turned.positions = hair.positions;
  turn_hair(turned, y_up_from_direction(up));
  const HeadEllipsoid head = ellipsoid_under_top(turned);
  return {y_up_from_direction(up).transpose() * head.center, head.radii.mean()};
}

/// Weighs the direction of hair that reaches beyond the head.
double fall_along(const Surface& surface, const RoomUnder& room, std::size_t up) {
  double beyond = 0, upwards = 0, weights = 0;
  for (const auto& [at, area] : surface.parts) {
    const double distance = (at - room.center).norm();
    if (!(distance > kBeyond * room.radius)) continue;
    const double weight = area * (distance - kBeyond * room.radius);  // Tips hang most freely.
    beyond += area;
    weights += weight;
    upwards += weight * up_direction(up).dot(at - room.center) / distance;
  }
  if (!(weights > 0)) return 0;
  const double certainty = std::min(1.0, beyond / surface.area / kMuchBeyond);
  return -certainty * std::min(kMostOfFall, kFalls * (1 + upwards / weights));
}

/// Share of the directions in a cap around `up` that have hair, seen from the head's middle.
double covered_top(const Surface& surface, const RoomUnder& room, std::size_t up) {
  constexpr int kRings = 3, kSectors = 8;
  const Eigen::Matrix3d turn = y_up_from_direction(up);
  std::array<bool, std::size_t(kRings * kSectors)> seen{};
  for (const auto& [at, area] : surface.parts) {
    const Vector3d from = turn * (at - room.center).normalized();
    if (!(from.y() > kCap)) continue;
    const int ring = std::min(kRings - 1, int((1 - from.y()) / (1 - kCap) * kRings));
    const double angle = std::atan2(from.z(), from.x()) / (2 * std::numbers::pi) + 0.5;
    seen[std::size_t(ring * kSectors + std::min(kSectors - 1, int(angle * kSectors)))] = true;
  }
  return double(std::ranges::count(seen, true)) / double(seen.size());
}

void weigh_hair(const HairMesh& hair, const Surface& surface, std::vector<UpEvidence>& evidence) {
  UpEvidence falls{"hair falls from the head", {}}, covers{"hair covers the top of the head", {}};
  for (std::size_t up = 0; up < kUps; ++up) {
    const RoomUnder room = room_under(hair, up);
    falls.likelihood[up] = fall_along(surface, room, up);
    covers.likelihood[up] = -kBald * (1 - covered_top(surface, room, up));
  }
  evidence.push_back(falls);
  evidence.push_back(covers);
}

/// Along an axis, how far one half of the hair is the other one's mirror image: the share of its surface that is in
/// cells which both halves fill.
double mirrored_along(const HairMesh& hair, const Surface& surface, Eigen::Index axis) {
  constexpr int kCells = 12;
  const Eigen::AlignedBox3d box = hair.box();
  const double side = box.sizes().maxCoeff();
  double middle = 0;
  for (const auto& [at, area] : surface.parts) middle += at[axis] * area / surface.area;
  std::array<double, std::size_t(kCells * kCells * kCells)> left{}, right{};
  const auto cell = [&](double value) { return std::clamp(int(value / side * kCells), 0, kCells - 1); };
  const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (const auto& [at, area] : surface.parts) {
    const double out = at[axis] - middle;
    const auto index =
        std::size_t((cell(std::abs(out)) * kCells + cell(at[u] - box.min()[u])) * kCells + cell(at[v] - box.min()[v]));
    (out > 0 ? right : left)[index] += area;
  }
  double common = 0;
  for (std::size_t i = 0; i < left.size(); ++i) common += 2 * std::min(left[i], right[i]);
  return common / surface.area;
}

void weigh_sides(const HairMesh& hair, const Surface& surface, std::vector<UpEvidence>& evidence) {
  std::array<double, 3> mirrored{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) mirrored[std::size_t(axis)] = mirrored_along(hair, surface, axis);
  // Hair that looks alike across several axes, a ball, gives no evidence.
  UpEvidence sides{"hair is the same on both sides", {}};
  for (std::size_t up = 0; up < kUps; ++up) {
    const auto axis = std::size_t(kAxis[up]);
    const double others = std::max(mirrored[(axis + 1) % 3], mirrored[(axis + 2) % 3]);
    sides.likelihood[up] = -kSides * std::clamp((mirrored[axis] - others) / 0.3, 0.0, 1.0);
  }
  evidence.push_back(sides);
}

}  // namespace

Vector3d up_direction(std::size_t up) { return Vector3d::Unit(kAxis[up]) * kSign[up]; }

Eigen::Matrix3d y_up_from_direction(std::size_t up) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  switch (up) {
    case 1: turn << 1, 0, 0, 0, 0, 1, 0, -1, 0; break;
    case 2: turn << 1, 0, 0, 0, 0, -1, 0, 1, 0; break;
    case 3: turn << 0, -1, 0, 1, 0, 0, 0, 0, 1; break;
    case 4: turn << 0, 1, 0, -1, 0, 0, 0, 0, 1; break;
    case 5: turn << 1, 0, 0, 0, -1, 0, 0, 0, -1; break;
    default: break;
  }
  return turn;
}

std::vector<UpEvidence> weigh_ups(const KnownModel& known) {
  std::vector<UpEvidence> evidence;
  weigh_skeleton(known.model, evidence);
  weigh_head_bone(known.model, evidence);
  weigh_joints(known.model, evidence);
  if (known.hair.triangles.empty() || known.on_face) return evidence;
  const Surface surface = surface_of(known.hair);
  if (!(surface.area > 0)) return evidence;
  weigh_hair(known.hair, surface, evidence);
  weigh_sides(known.hair, surface, evidence);
  return evidence;
}

}  // namespace coif::cook
