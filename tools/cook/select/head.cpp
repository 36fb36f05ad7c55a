#include "cook/select/head.h"

#include "base/geometry.h"
#include "base/text.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>

namespace coif {
namespace {

/// The node with most weight below it; of equals the one nearest to the root.
std::uint32_t heaviest(const SourceModel& source, const NodeWeights& below, auto is_candidate) {
  std::uint32_t best = kNoIndex;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (!is_candidate(n) || below[n] <= 0) continue;
    if (best == kNoIndex || below[n] > below[best]) best = n;
  }
  return best;
}

/// The lowest node that carries all of the hair, itself or below it.
std::uint32_t lowest_common_node(const SourceModel& source, const NodeWeights& below) {
  const double total = *std::ranges::max_element(below);
  std::uint32_t lowest = kNoIndex;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    if (total > 0 && below[n] >= total * (1 - 1.0e-9)) lowest = n;
  }
  return lowest;
}

Eigen::AlignedBox3d box_of(const HairMesh& hair) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : hair.positions) box.extend(p.cast<double>());
  return box;
}

/// The node of a rigid mesh, away from the hair: a file without bones has its origin on the floor, not in the head.
bool is_far_mesh_node(const SourceModel& source, const HairMesh& hair, std::uint32_t node) {
  if (node == kNoIndex) return false;
  const bool carries_mesh = std::ranges::any_of(
      source.meshes, [&](const SourceMesh& mesh) { return mesh.node == node && mesh.influence_begin.empty(); });
  return carries_mesh && !box_of(hair).contains(source.nodes[node].model_from_node.translation());
}

/// Without a node of its own the head sits in the middle of the hair.
HeadBone head_bone_at(const SourceModel& source, const HairMesh& hair, std::uint32_t node) {
  HeadBone head;
  if (node == kNoIndex) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : hair.positions) box.extend(p);
    head.joint = box.center().cast<double>();
    return head;
  }
  head.node = node;
  head.name = source.nodes[node].name;
  head.joint = source.nodes[node].model_from_node.translation();
  head.rotation = Eigen::Quaterniond(rotation_part(source.nodes[node].model_from_node)).normalized();
  return head;
}

}  // namespace

bool is_called_head(const std::string& name) {
  const std::vector<std::string> not_heads{"*end*",  "*nub*",   "*top*",   "*hair*",
                                           "*band*", "*phone*", "*light*", "*mesh*"};
  return matches(name, "*head*") && !matches_any(name, not_heads);
}

NodeWeights hair_weights(const SourceModel& source, const HairMesh& hair) {
  NodeWeights weights(source.nodes.size(), 0.0);
  for (const SourceInfluence& influence : hair.influences) weights[influence.node] += influence.weight;
  return weights;
}

NodeWeights weights_below(const SourceModel& source, const NodeWeights& weights) {
  NodeWeights below = weights;
  // Parents come first, so backwards each node is complete before it is added to its parent.
  for (std::size_t n = source.nodes.size(); n-- > 0;) {
    if (source.nodes[n].parent != kNoIndex) below[source.nodes[n].parent] += below[n];
  }
  return below;
}

tl::expected<HeadBone, ToolError> find_head_bone(const SourceModel& source, const HairMesh& hair,
                                                 const std::string& pattern) {
  const NodeWeights below = weights_below(source, hair_weights(source, hair));
  if (!pattern.empty()) {
    const auto named = [&](std::uint32_t n) { return matches(source.nodes[n].name, pattern); };
    if (const std::uint32_t head = heaviest(source, below, named); head != kNoIndex) {
      return head_bone_at(source, hair, head);
    }
    for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
      if (named(n)) return head_bone_at(source, hair, n);
    }
    return tl::unexpected(ToolError{
        ToolError::Kind::kBadInput,
        fmt::format("{}: recipe key \"skeleton.head\": no node is called '{}'; 'coif cook {} --list' names them",
                    source.path, pattern, source.path)});
  }
  if (source.head_node != kNoIndex) return head_bone_at(source, hair, source.head_node);
  const auto by_name = [&](std::uint32_t n) { return is_called_head(source.nodes[n].name); };
  if (const std::uint32_t head = heaviest(source, below, by_name); head != kNoIndex) {
    return head_bone_at(source, hair, head);
  }
  const std::uint32_t lowest = lowest_common_node(source, below);
  return head_bone_at(source, hair, is_far_mesh_node(source, hair, lowest) ? kNoIndex : lowest);
}

namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestVertices = 50;  ///< A head's mesh has more; fewer are teeth or a pin.
constexpr double kInsideBox = 0.97;          ///< A skull is a little smaller than the box that nose and ears widen.
constexpr double kDeepInside = 0.85;         ///< Hair deeper than this in a head says that it is not the head's shape,
constexpr double kMuchHair = 0.25;           ///< where it is more than this share of all hair; roots may be inside.
constexpr double kReachOut = 0.05;           ///< Ears may reach this share of the hair's width out of it.
constexpr double kThinnest = 0.75;           ///< Of a sphere through the hair: roots may reach into the skull.
constexpr double kLongestHead = 2.5;         ///< Longest over shortest semi-axis.
constexpr double kSmallestHead = 0.4;        ///< Of the hair's smaller horizontal size.
constexpr double kSmallestRadius = 0.001;    ///< Metres: flat hair encloses nothing.

/// Share of a vertex's weight on the head bone; one for a mesh that hangs from it.
float weight_on_head(const SourceModel& source, const SourceMesh& mesh, std::uint32_t v, const std::string& head) {
  if (mesh.influence_begin.empty()) return source.nodes[mesh.node].name == head ? 1.0f : 0.0f;
  float sum = 0;
  for (std::uint32_t k = mesh.influence_begin[v]; k < mesh.influence_begin[v + 1]; ++k) {
    if (source.nodes[mesh.influences[k].node].name == head) sum += mesh.influences[k].weight;
  }
  return sum;
}

/// A head is under its hair; what reaches out sideways or above (a hat, a halo) only follows the same bone.
bool is_under(const std::vector<Vector3d>& vertices, const Eigen::AlignedBox3d& hair) {
  const double slack = kReachOut * hair.sizes().x();
  return std::ranges::all_of(vertices, [&](const Vector3d& v) {
    return v.x() > hair.min().x() - slack && v.x() < hair.max().x() + slack && v.y() < hair.max().y() + slack;
  });
}

/// Vertices of the other meshes that follow the head bone and nothing else.
std::vector<Vector3d> head_vertices(const SourceModel& source, const HairMesh& hair, const HeadBone& head_bone) {
  const Eigen::AlignedBox3d hair_box = box_of(hair);
  std::vector<Vector3d> vertices;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    if (std::ranges::find(hair.source_meshes, m) != hair.source_meshes.end()) continue;
    const SourceMesh& mesh = source.meshes[m];
    std::vector<Vector3d> of_mesh;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      const bool follows = weight_on_head(source, mesh, v, head_bone.name) > 0.9f;
      if (follows) of_mesh.push_back(mesh.positions[v].cast<double>());
    }
    if (is_under(of_mesh, hair_box)) vertices.insert(vertices.end(), of_mesh.begin(), of_mesh.end());
  }
  return vertices;
}

FittedHead from_box(const std::vector<Vector3d>& vertices) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : vertices) box.extend(v);
  FittedHead head;
  head.center = box.center();
  head.radii = box.sizes() * (0.5 * kInsideBox);
  head.origin = fmt::format("the box of {} vertices that follow the head bone", vertices.size());
  return head;
}

/// A hat or a hood follows the head bone too; then the box is larger than the hair and hair is inside it.
bool holds_hair(const FittedHead& head, const HairMesh& hair) {
  std::size_t inside = 0;
  for (const Eigen::Vector3f& p : hair.positions) {
    inside += (p.cast<double>() - head.center).cwiseQuotient(head.radii).norm() < kDeepInside ? 1 : 0;
  }
  return double(inside) > kMuchHair * double(hair.positions.size());
}

/// A head is about as wide as deep and high, and not small beside its hair.
bool is_head_shaped(const FittedHead& head, const HairMesh& hair) {
  const Eigen::Vector3d hair_size = box_of(hair).sizes();
  return head.radii.maxCoeff() < kLongestHead * head.radii.minCoeff() &&
         2 * head.radii.maxCoeff() > kSmallestHead * std::min(hair_size.x(), hair_size.z());
}

/// Sphere through points by linear least squares: |p|^2 = 2 c.p + (r^2 - |c|^2). Points relative to their mean.
std::pair<Vector3d, double> fit_sphere(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / double(points.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Vector3d& p : points) {
    const Vector3d d = p - mean;
    const Eigen::Vector4d row(2 * d.x(), 2 * d.y(), 2 * d.z(), 1);
    normal += row * row.transpose();
    right += row * d.squaredNorm();
  }
  const Eigen::Vector4d solution = least_squares(normal, right);
  const Vector3d center = solution.head<3>();
  return {mean + center, std::sqrt(std::max(0.0, solution[3] + center.squaredNorm()))};
}

/// The hair lies on the skull at the top: a sphere through its upper part, no larger than the hair's inside there.
FittedHead from_hair(const HairMesh& hair) {
  const Eigen::AlignedBox3d box = box_of(hair);
  const double width = std::min(box.sizes().x(), box.sizes().z());
  std::vector<Vector3d> cap;
  for (const Eigen::Vector3f& p : hair.positions) {
    // At least the topmost vertex, even where flat hair has no width.
    if (double(p.y()) >= box.max().y() - 0.5 * width) cap.push_back(p.cast<double>());
  }
  auto [center, radius] = fit_sphere(cap);
  // A flat or ragged cap can put the sphere anywhere: keep it within the hair's own size.
  if (!(radius > 0.2 * width && radius < 0.8 * width) || !box.contains(center)) {
    radius = 0.4 * width;
    center = Vector3d(box.center().x(), box.max().y() - 0.5 * width, box.center().z());
  }
  std::vector<double> distances;
  for (const Vector3d& p : cap) distances.push_back((p - center).norm());
  const auto low = distances.begin() + std::ptrdiff_t(distances.size() / 20);
  std::ranges::nth_element(distances, low);
  FittedHead head;
  head.center = center;
  head.radii = Vector3d::Constant(std::clamp(*low, kThinnest * radius, radius));
  head.origin = "the inside of the hair's upper part";
  return head;
}

}  // namespace

FittedHead fit_head(const SourceModel& source, const HairMesh& hair, const HeadBone& head_bone, const Recipe& recipe) {
  FittedHead head;
  if (recipe.head_center && recipe.head_radii) {
    head.center = Vector3d(recipe.head_center->data());
    head.radii = Vector3d(recipe.head_radii->data());
    head.origin = "the recipe";
    head.declared = true;
  } else {
    const std::vector<Vector3d> vertices = head_vertices(source, hair, head_bone);
    if (vertices.size() >= kFewestVertices) head = from_box(vertices);
    const bool found = vertices.size() >= kFewestVertices && is_head_shaped(head, hair) && !holds_hair(head, hair);
    if (!found) head = from_hair(hair);
  }
  head.radii = head.radii.cwiseMax(kSmallestRadius);
  if (recipe.head_shape == "sphere") head.radii.setConstant(head.radii.mean());
  return head;
}

}  // namespace coif
