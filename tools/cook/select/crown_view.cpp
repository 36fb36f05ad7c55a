#include "cook/select/crown_view.h"

#include "cook/select/head.h"
#include "cook/select/head_landmarks.h"
#include "cook/select/mesh_topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coif::cook {
namespace {

using Eigen::Vector3d;
using importer::kNoIndex, importer::SourceMesh, importer::SourceModel;

constexpr std::size_t kDirections = 400;  ///< Spread over the sphere around the head's centre.
constexpr double kNearestSeen = 0.5,
                 kFarthestSeen = 2.5;  ///< In radii: what is seen nearer or farther is not on the head.
constexpr double kFollowsHead = 0.9;   ///< Share of the weight of a piece that is the head itself.
constexpr double kNearJoint = 0.25;    ///< Share of its height by which the joint may be outside of it.
constexpr double kFlattest = 0.45;     ///< Smallest over largest size of a head.

bool is_of_crown(const Vector3d& direction) {
  return direction.y() > 0.3 || (direction.z() < -0.3 && direction.y() > -0.3);
}

bool is_of_face(const Vector3d& direction) {
  return direction.z() > 0.6 && direction.y() < 0.25 && direction.y() > -0.7;
}

bool is_of_middle(const Vector3d& direction) {
  return direction.z() > 0.6 && direction.y() < 0.05 && direction.y() > -0.5;
}

/// Spread evenly: a spiral (Vogel 1979, "A better way to construct the sunflower head").
std::vector<Vector3d> directions() {
  std::vector<Vector3d> all;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double y = 1 - 2 * (double(i) + 0.5) / double(kDirections), across = std::sqrt(1 - y * y);
    all.emplace_back(across * std::cos(turn * double(i)), y, across * std::sin(turn * double(i)));
  }
  return all;
}

/// How far along a direction from the centre a triangle is met; 0 where it is not (Möller and Trumbore 1997).
double meeting(const Vector3d& direction, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d e1 = b - a, e2 = c - a, p = direction.cross(e2);
  const double determinant = e1.dot(p);
  if (std::abs(determinant) < 1.0e-12) return 0;
  const double u = -a.dot(p) / determinant;
  const Vector3d q = (-a).cross(e1);
  const double v = direction.dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 ? std::max(0.0, e2.dot(q) / determinant) : 0;
}

/// The box of the largest piece that may be the head itself; hair does not reach down to the joint, or is flat.
Eigen::AlignedBox3d box_at_joint(const SourceModel& source, std::uint32_t node, double weld_distance) {
  const Vector3d joint = source.nodes[node].model_from_node.translation();
  const std::vector<bool> no_bones(source.nodes.size(), false);
  Eigen::AlignedBox3d best;
  for (const SourceMesh& mesh : source.meshes) {
    const MeshPieces pieces = find_pieces(mesh, weld_distance);
    const std::vector<PieceEvidence> evidence = weigh_pieces(source, mesh, pieces, no_bones, node);
    std::vector<Eigen::AlignedBox3d> boxes(pieces.count);
    for (std::size_t t = 0; t < pieces.piece_of.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        boxes[pieces.piece_of[t]].extend(mesh.positions[mesh.triangles[3 * t + k]].cast<double>());
    for (std::uint32_t p = 0; p < pieces.count; ++p) {
      const Vector3d size = boxes[p].sizes();
      const double reach = kNearJoint * size.y();
      if (evidence[p].head_share < kFollowsHead || size.minCoeff() < kFlattest * size.maxCoeff()) continue;
      if (joint.y() > boxes[p].max().y() || boxes[p].exteriorDistance(joint) > reach) continue;
      if (boxes[p].min().y() > joint.y() + reach) continue;
      if (best.isEmpty() || boxes[p].volume() > best.volume()) best = boxes[p];
    }
  }
  return best;
}

}  // namespace

std::optional<HeadView> view_of_head(const SourceModel& source, std::uint32_t node, double weld_distance) {
  if (node == kNoIndex) return std::nullopt;
  // Its mesh may be the hair.
  const HeadLandmarks marks = find_joint_landmarks(source, node);
  const double forwards = marks.forwards < 0 ? -1.0 : 1.0;
  const bool shown = marks.forwards != 0;
  if (marks.show_size()) return HeadView{likeliest_head(marks), forwards, shown};
  const Eigen::AlignedBox3d box = box_at_joint(source, node, weld_distance);
  if (box.isEmpty()) return std::nullopt;
  return HeadView{{box.center(), box.sizes() / 2}, forwards, shown};
}

namespace {

/// The widest part of the circle around a view in which nothing is seen at the height of a face, 0..1.
double widest_opening(const SourceModel& source, const HeadView& view) {
  constexpr std::size_t kSectors = 36;
  constexpr std::array kHeights{-0.45, -0.25, 0.0};
  std::array<std::array<bool, kHeights.size()>, kSectors> seen{};
  for (const SourceMesh& mesh : source.meshes) {
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
      const auto corner = [&](std::size_t k) { return view.in_axes(mesh.positions[mesh.triangles[t + k]]); };
      const Vector3d a = corner(0), b = corner(1), c = corner(2);
      if (std::max({a.y(), b.y(), c.y()}) < kHeights[0] * kFarthestSeen) continue;
      for (std::size_t i = 0; i < kSectors; ++i) {
        const double turn = 2 * std::numbers::pi * double(i) / double(kSectors);
        for (std::size_t h = 0; h < kHeights.size(); ++h) {
          if (seen[i][h]) continue;
          const double far = meeting(Vector3d(std::sin(turn), kHeights[h], std::cos(turn)).normalized(), a, b, c);
          seen[i][h] = far > kNearestSeen && far < kFarthestSeen;
        }
      }
    }
  }
  std::size_t widest = 0, run = 0;
  for (std::size_t i = 0; i < 2 * kSectors; ++i) {
    run = std::ranges::count(seen[i % kSectors], true) < 2 ? run + 1 : 0;
    widest = std::max(widest, std::min(run, kSectors));
  }
  return double(widest) / double(kSectors);
}

}  // namespace

double open_face(const SourceModel& source) {
  HairMesh all;
  for (const SourceMesh& mesh : source.meshes)
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
  if (all.positions.empty()) return 0;
  const HeadEllipsoid under_top = ellipsoid_under_top(all);
  const Eigen::AlignedBox3d box = all.box();
  const double width = std::min(box.sizes().x(), box.sizes().z());
  const HeadEllipsoid lower = ball_below_top(box, width, under_top.center.z());
  return std::max(widest_opening(source, {under_top}), widest_opening(source, {lower}));
}

Outermost::Outermost() : directions_(directions()), far_(kDirections, 0.0), part_(kDirections, kNoIndex) {}

void Outermost::add(const Vector3d& a, const Vector3d& b, const Vector3d& c, std::uint32_t part) {
  const Vector3d middle = ((a + b + c) / 3).normalized();
  const double wide =
      std::max({(a.normalized() - middle).norm(), (b.normalized() - middle).norm(), (c.normalized() - middle).norm()});
  for (std::size_t d = 0; d < kDirections; ++d) {
    if ((directions_[d] - middle).norm() > wide + 1.0e-9) continue;
    const double far = meeting(directions_[d], a, b, c);
    if (far < kNearestSeen || far > kFarthestSeen || far <= far_[d]) continue;
    far_[d] = far;
    part_[d] = part;
  }
}

std::vector<Coverage> Outermost::shares(std::size_t count) const {
  const auto number = [&](auto is_of) { return double(std::ranges::count_if(directions_, is_of)); };
  const double crown = number(is_of_crown), face = number(is_of_face), middle = number(is_of_middle);
  std::vector<Coverage> all(count);
  for (std::size_t d = 0; d < kDirections; ++d) {
    if (part_[d] == kNoIndex) continue;
    Coverage& part = all[part_[d]];
    if (is_of_crown(directions_[d])) part.crown += 1 / crown;
    if (is_of_face(directions_[d])) part.face += 1 / face;
    if (is_of_middle(directions_[d])) part.middle_of_face += 1 / middle;
  }
  return all;
}

}  // namespace coif::cook
