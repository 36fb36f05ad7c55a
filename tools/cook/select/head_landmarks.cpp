#include "cook/select/head_landmarks.h"

#include "cook/select/hair_evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;
using importer::kNoIndex;
using importer::SourceModel;

constexpr std::size_t kFewestVertices = 16;  ///< The simplest heads have more; fewer are teeth or a pin.
constexpr float kFollows = 0.9f;             ///< Least share of a vertex's weight on the head.
constexpr double kReachOut = 0.05;           ///< Share of the hair's width by which ears may stick out of it.
constexpr double kAtJoint = 0.1;       ///< Share of the mesh's height: a head's mesh reaches so near to its joint.
constexpr double kLongestHead = 2.5;   ///< Longest side over the shortest; a skull cut away makes it flat.
constexpr double kDeepInside = 0.85;   ///< Hair deeper than this in the mesh's box says that it is a hood,
constexpr double kMuchHair = 0.25;     ///< where it is more than this share of all hair; roots may be inside.
constexpr double kMirrored = 0.2;      ///< How far eyes may be off their mirror images, by their distance.
constexpr double kBeforeJoint = 0.25;  ///< How far eyes are before the joint at least, by their height above it.

Vector3d place(const SourceModel& source, std::uint32_t node) {
  return source.nodes[node].model_from_node.translation();
}

std::vector<bool> nodes_that_follow(const SourceModel& source, std::uint32_t head) {
  const std::vector<bool> hair_bones = find_hair_bones(source);
  std::vector<bool> follows(source.nodes.size(), false);
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    const std::uint32_t parent = source.nodes[n].parent;
    follows[n] = n == head || (parent != kNoIndex && follows[parent] && !hair_bones[n]);
  }
  return follows;
}

/// Joint and neck, where bones lead to a head: it is called so, or the spine ends in it.
void find_joints(const SourceModel& source, std::uint32_t head, const std::vector<bool>& below, HeadLandmarks& marks) {
  bool is_on_spine = false;
  for (std::uint32_t n = source.nodes[head].parent; n != kNoIndex; n = source.nodes[n].parent) {
    const std::string& name = source.nodes[n].name;
    is_on_spine = is_on_spine || is_called_neck(name) || is_called_trunk(name);
  }
  bool has_limbs = false, has_eyes = false;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    has_limbs = has_limbs || (below[n] && is_called_limb(source.nodes[n].name));
    has_eyes = has_eyes || (below[n] && is_called_eyeball(source.nodes[n].name));
  }
  if (has_limbs || !(is_on_spine || (has_eyes && is_called_head(source.nodes[head].name)))) return;
  marks.joint = place(source, head);
  const std::uint32_t parent = source.nodes[head].parent;
  if (parent == kNoIndex || !is_called_neck(source.nodes[parent].name)) return;
  if (const Vector3d neck = place(source, parent); neck.y() < marks.joint->y()) marks.neck = neck;
}

void find_end(const SourceModel& source, std::uint32_t head, HeadLandmarks& marks) {
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (source.nodes[n].parent != head || !is_called_end(source.nodes[n].name)) continue;
    if (const Vector3d end = place(source, n); end.y() > marks.joint->y()) marks.end = end;
  }
}

/// Finds the two nodes called eyes that mirror each other best and lie above the head's joint.
void find_eyes(const SourceModel& source, const std::vector<bool>& below, HeadLandmarks& marks) {
  std::vector<Vector3d> places;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (!below[n] || !is_called_eyeball(source.nodes[n].name)) continue;
    if (const Vector3d at = place(source, n) - *marks.joint; at.y() > 0) places.push_back(at);
  }
  double best = kMirrored;
  for (std::size_t a = 0; a < places.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Vector3d image(-places[b].x(), places[b].y(), places[b].z());
      const double apart = (places[a] - places[b]).norm();
      if (!(apart > 0) || !((places[a] - image).norm() < best * apart)) continue;
      best = (places[a] - image).norm() / apart;
      marks.eyes = {places[a] + *marks.joint, places[b] + *marks.joint};
    }
  }
}

/// Which way toes point from their feet.
double side_of_toes(const SourceModel& source) {
  double along = 0, length = 0;
  for (const importer::SourceNode& node : source.nodes) {
    if (node.parent == kNoIndex || !is_called_foot(node.name) || !is_called_foot(source.nodes[node.parent].name))
      continue;
    const Vector3d way = node.model_from_node.translation() - place(source, node.parent);
    along += way.z();
    length += way.norm();
  }
  return length > 0 && std::abs(along) > length / 2 ? std::copysign(1.0, along) : 0;
}

double find_forwards(const SourceModel& source, const HeadLandmarks& marks) {
  if (source.facing == importer::Facing::kBackwards) return -1;
  if (source.facing != importer::Facing::kUnknown) return 1;
  if (marks.eyes) {
    const Vector3d at = ((*marks.eyes)[0] + (*marks.eyes)[1]) / 2 - *marks.joint;
    if (std::abs(at.z()) > kBeforeJoint * at.y()) return std::copysign(1.0, at.z());
  }
  return side_of_toes(source);
}

/// A head is under its hair; parts that stick out sideways or above (a hat, a halo) only follow the same bone.
bool is_under(const Box& part, const Box& hair) {
  const double slack = kReachOut * hair.sizes().x();
  return part.min().x() > hair.min().x() - slack && part.max().x() < hair.max().x() + slack &&
         part.max().y() < hair.max().y() + slack;
}

/// A head begins where the neck ends, at the joint that it turns about; things worn on it do not.
bool is_on_joint(const Box& part, const Vector3d& joint) {
  const double slack = kAtJoint * part.sizes().y();
  return joint.y() > part.min().y() - slack && part.exteriorDistance(joint) < 2 * slack;
}

/// A band or a hat, by its name, or hair that was not chosen.
bool is_worn_on_head(const SourceModel& source, const importer::SourceMesh& mesh) {
  return either_is_called(source, mesh, is_called_adornment) || either_is_called(source, mesh, is_called_headwear) ||
         either_is_called(source, mesh, is_called_hair);
}

/// Places of vertices of other meshes, or of what else a mesh has that gave hair, that follow the head and nothing
/// else.
void find_mesh(const SourceModel& source, const HairMesh& hair, const HeadBone& head_bone,
               const std::vector<bool>& follows, HeadLandmarks& marks) {
  std::set<std::array<float, 3>> is_hair;
  for (const Eigen::Vector3f& p : hair.positions) is_hair.insert({p.x(), p.y(), p.z()});
  Box all;
  std::size_t count = 0;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const importer::SourceMesh& mesh = source.meshes[m];
    const bool gave_hair = std::ranges::find(hair.source_meshes, m) != hair.source_meshes.end();
    if (!gave_hair && is_worn_on_head(source, mesh)) continue;
    Box box;
    std::size_t of_mesh = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const Eigen::Vector3f& p = mesh.positions[v];
      if (gave_hair && is_hair.contains({p.x(), p.y(), p.z()})) continue;
      if (weight_on(mesh, v, follows) <= kFollows) continue;
      box.extend(p.cast<double>());
      ++of_mesh;
    }
    if (of_mesh == 0 || !(is_under(box, hair.box()) || is_on_joint(box, head_bone.joint))) continue;
    all.extend(box);
    count += of_mesh;
  }
  if (count < kFewestVertices || !(all.sizes().maxCoeff() < kLongestHead * all.sizes().minCoeff())) return;
  // A hat or a hood follows the head, too; then hair is inside of it.
  const HeadEllipsoid within{all.center(), all.sizes() / 2};
  std::size_t inside = 0;
  for (const Eigen::Vector3f& p : hair.positions)
    inside += within.scaled_distance(p.cast<double>()) < kDeepInside ? 1 : 0;
  if (double(inside) > kMuchHair * double(hair.positions.size())) return;
  marks.mesh = all;
  marks.mesh_vertices = count;
}

}  // namespace

std::string HeadLandmarks::text() const {
  std::vector<std::string> parts;
  if (joint) parts.emplace_back("its joint");
  if (neck) parts.emplace_back("the neck's");
  if (eyes) parts.emplace_back("two eyes");
  if (end) parts.emplace_back("its end");
  if (mesh) parts.push_back(fmt::format("{} vertices that follow it", mesh_vertices));
  return fmt::format("{}", fmt::join(parts, ", "));
}

HeadLandmarks find_joint_landmarks(const SourceModel& source, std::uint32_t head) {
  HeadLandmarks marks;
  if (head == kNoIndex) return marks;
  const std::vector<bool> follows = nodes_that_follow(source, head);
  find_joints(source, head, follows, marks);
  if (marks.joint) {
    find_end(source, head, marks);
    find_eyes(source, follows, marks);
  }
  marks.forwards = find_forwards(source, marks);
  return marks;
}

HeadLandmarks find_landmarks(const SourceModel& source, const HairMesh& hair, const HeadBone& head_bone) {
  HeadLandmarks marks = find_joint_landmarks(source, head_bone.node);
  if (head_bone.node != kNoIndex) find_mesh(source, hair, head_bone, nodes_that_follow(source, head_bone.node), marks);
  return marks;
}

}  // namespace coif::cook
