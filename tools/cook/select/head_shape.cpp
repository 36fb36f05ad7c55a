#include "base/geometry.h"
#include "base/text.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/select/head.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestVertices = 50;  ///< A head's mesh has more; fewer are teeth or a pin.
constexpr double kInsideBox = 0.97;          ///< A skull is a little smaller than the box that nose and ears widen.
/// Share of the head's size: if hair is deeper inside, this is not the head's shape.
constexpr double kDeepInside = 0.85;
/// Share of all hair that must be that deep; roots may be inside.
constexpr double kMuchHair = 0.25;
/// Share of the hair's width by which ears may stick out of it.
constexpr double kReachOut = 0.05;
constexpr double kLongestHead = 2.5;       ///< Longest over shortest semi-axis.
constexpr double kSmallestHead = 0.4;      ///< Share of the hair's smaller horizontal size.
constexpr double kSmallestRadius = 0.001;  ///< Metres: flat hair encloses nothing.
/// Share of a head's height: its mesh reaches this near to the joint that it turns about.
constexpr double kAtJoint = 0.1;

/// The hair that a head may hold at rest: sunk roots, and only a few pixels of the picture.
constexpr HairInside kMostInside{0.03, 0.03, 0.005};
constexpr double kLeastOfMesh = 0.7;  ///< A head's mesh that has to shrink further was none.
/// Lower bound with hair alone, which is less certain: strips on one side show little.
constexpr double kLeastOfHair = 0.4;

/// Share of a vertex's weight on the head bone; one for a mesh that hangs from it.
float weight_on_head(const importer::SourceModel& source, const importer::SourceMesh& mesh, std::uint32_t v,
                     const std::string& head) {
  if (mesh.influence_begin.empty()) return source.nodes[mesh.node].name == head ? 1.0f : 0.0f;
  float sum = 0;
  for (std::uint32_t k = mesh.influence_begin[v]; k < mesh.influence_begin[v + 1]; ++k) {
    if (source.nodes[mesh.influences[k].node].name == head) sum += mesh.influences[k].weight;
  }
  return sum;
}

using Box = Eigen::AlignedBox3d;

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

/// Places of the hair's vertices, as the source has them.
std::set<std::array<float, 3>> places_of(const HairMesh& hair) {
  std::set<std::array<float, 3>> places;
  for (const Eigen::Vector3f& p : hair.positions) places.insert({p.x(), p.y(), p.z()});
  return places;
}

/// Vertices that follow only the head bone: of other meshes, or of the rest of a mesh that gave hair.
std::vector<Vector3d> head_vertices(const importer::SourceModel& source, const HairMesh& hair,
                                    const HeadBone& head_bone) {
  std::vector<Vector3d> vertices;
  const std::set<std::array<float, 3>> is_hair = places_of(hair);
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const importer::SourceMesh& mesh = source.meshes[m];
    const bool gave_hair = std::ranges::find(hair.source_meshes, m) != hair.source_meshes.end();
    std::vector<Vector3d> of_mesh;
    Box box;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      const Eigen::Vector3f& p = mesh.positions[v];
      if (gave_hair && is_hair.contains({p.x(), p.y(), p.z()})) continue;
      if (weight_on_head(source, mesh, v, head_bone.name) <= 0.9f) continue;
      of_mesh.push_back(mesh.positions[v].cast<double>());
      box.extend(of_mesh.back());
    }
    if (of_mesh.empty()) continue;
    if (is_under(box, hair.box()) || is_on_joint(box, head_bone.joint)) {
      vertices.insert(vertices.end(), of_mesh.begin(), of_mesh.end());
    }
  }
  return vertices;
}

HeadEllipsoid ellipsoid_in_box(const std::vector<Vector3d>& vertices) {
  Box box;
  for (const Vector3d& v : vertices) box.extend(v);
  return {box.center(), box.sizes() * (0.5 * kInsideBox)};
}

/// A hat or a hood follows the head bone too; then the box is larger than the hair and hair is inside it.
bool holds_hair(const HeadEllipsoid& head, const HairMesh& hair) {
  std::size_t inside = 0;
  for (const Eigen::Vector3f& p : hair.positions)
    inside += head.scaled_distance(p.cast<double>()) < kDeepInside ? 1 : 0;
  return double(inside) > kMuchHair * double(hair.positions.size());
}

/// A head is about as wide as deep and high, and not small compared with its hair.
bool is_head_shaped(const HeadEllipsoid& head, const HairMesh& hair) {
  const Vector3d hair_size = hair.box().sizes();
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

}  // namespace

HeadEllipsoid ellipsoid_under_top(const HairMesh& hair) {
  const Box box = hair.box();
  const double width = std::min(box.sizes().x(), box.sizes().z());
  std::vector<Vector3d> cap;
  for (const Eigen::Vector3f& p : hair.positions) {
    // Take at least the topmost vertex, even if flat hair has no width.
    if (double(p.y()) >= box.max().y() - 0.5 * width) cap.push_back(p.cast<double>());
  }
  auto [center, radius] = fit_sphere(cap);
  // A flat or ragged cap can put the sphere anywhere: keep it within the hair's own size.
  if (!(radius > 0.2 * width && radius < 0.8 * width) || !box.contains(center)) {
    radius = 0.4 * width;
    center = Vector3d(box.center().x(), box.max().y() - 0.5 * width, box.center().z());
  }
  return {center, radius * Vector3d(0.9, 1.1, 1.0)};
}

namespace {

struct FirstGuess {
  HeadGuess like;
  bool is_mesh = false;  ///< It comes from a mesh.
  std::string origin;    ///< FittedHead's.
};

FirstGuess guess_head(const importer::SourceModel& source, const HairMesh& hair, const HeadBone& head_bone) {
  const std::vector<Vector3d> vertices = head_vertices(source, hair, head_bone);
  if (vertices.size() >= kFewestVertices) {
    const HeadEllipsoid head = ellipsoid_in_box(vertices);
    if (is_head_shaped(head, hair) && !holds_hair(head, hair)) {
      return {{head, Vector3d::Constant(0.1), 0.05, 0.1},
              true,
              fmt::format("the box of {} vertices that follow the head bone", vertices.size())};
    }
  }
  // Hair is combed to one side more often than faces look there.
  return {{ellipsoid_under_top(hair), {0.15, 0.4, 0.4}, 0.12, 0.5}, false, "the inside of the hair"};
}

/// Shrinks it, to `least` of its size at the utmost, until hardly any hair is inside.
void make_room(const HairMesh& hair, double least, FittedHead& head, Findings& findings) {
  const double share = share_with_room(hair, head, kMostInside);
  head.radii *= std::clamp(share * 0.999, least, 1.0);
  head.radii = head.radii.cwiseMax(kSmallestRadius);
  const HairInside inside = hair_inside(hair, head);
  const double most_vertices = std::max(kMostInside.vertices, 1.0 / double(hair.positions.size()));
  if (inside.area <= kMostInside.area && inside.vertices <= most_vertices) return;
  findings.warn(
      "C111",
      fmt::format("{:.0f} % of the hair's surface is inside the head, even where that is made {:.0f} % as large as it "
                  "looks; if it is not the head, set \"head.center\" and \"head.radii\" in the recipe",
                  100 * std::max(inside.area, inside.vertices), 100 * least));
}

}  // namespace

HeadSign first_sign_of_head(const importer::SourceModel& source, const HairMesh& hair, const HeadBone& head_bone) {
  const FirstGuess guess = guess_head(source, hair, head_bone);
  return {guess.like.shape, guess.is_mesh};
}

FittedHead fit_head(const importer::SourceModel& source, const HairMesh& hair, const HeadBone& head_bone,
                    const HairRecipe& recipe, Findings& findings, const std::stop_token& stop) {
  FittedHead head;
  head.shape = recipe.head_shape;
  double least = 1;
  if (recipe.head_center && recipe.head_radii) {
    head.center = Vector3d(recipe.head_center->data());
    head.radii = Vector3d(recipe.head_radii->data()).cwiseMax(kSmallestRadius);
    head.origin = "the recipe";
    head.declared = true;
  } else {
    FirstGuess guess = guess_head(source, hair, head_bone);
    guess.like.shape.radii = guess.like.shape.radii.cwiseMax(kSmallestRadius);
    head.origin = guess.origin;
    static_cast<HeadEllipsoid&>(head) = fit_head_room(hair, guess.like, stop);
    least = guess.is_mesh ? kLeastOfMesh : kLeastOfHair;
  }
  if (head.shape == HeadShape::kSphere) head.radii.setConstant(head.radii.mean());
  if (!head.declared) make_room(hair, least, head, findings);
  const HairInside inside = hair_inside(hair, head);
  findings.note(
      fmt::format("head: {}; centre ({:.3f}, {:.3f}, {:.3f}) m, radii ({:.3f}, {:.3f}, {:.3f}) m, {:.1f} % of the "
                  "hair's surface and {:.1f} % of its vertices inside; moved by '{}'",
                  head.origin, head.center.x(), head.center.y(), head.center.z(), head.radii.x(), head.radii.y(),
                  head.radii.z(), 100 * inside.area, 100 * inside.vertices, head_bone.name));
  return head;
}

}  // namespace coif::cook
