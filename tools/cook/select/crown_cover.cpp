#include "cook/select/hair_evidence.h"
#include "cook/select/head_landmarks.h"
#include "cook/select/under_hair.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;
using importer::SourceMesh, importer::SourceModel;

constexpr std::size_t kDirections = 400;           ///< Spread over the sphere around the head's centre.
constexpr double kNearest = 0.5, kFarthest = 2.5;  ///< In radii: what is seen nearer or farther is not on the head.
constexpr double kMostFace = 0.2;                  ///< Share of the face that hair may cover.
constexpr double kLeastCrown = 0.12, kLeastCrownOfPiece = 0.2;  ///< Share of the crown that hair covers at least.
constexpr double kOnlyOnHead = 0.8;                             ///< Share of a part's vertices that follow the head.
constexpr double kCovered = 0.05;  ///< Hair that covers more than this of the crown may be all.

/// A part of the model that may be hair: one connected piece of a mesh.
struct Part {
  double on_head = 0;          ///< Share of its vertices.
  double crown = 0, face = 0;  ///< Shares of the directions in which it is outermost.
};

/// A head of which joints show the size, as the centre of a view in all directions.
struct HeadView {
  HeadEllipsoid head;
  double forwards = 1;

  [[nodiscard]] Vector3d in_axes(const Eigen::Vector3f& p) const {
    const Vector3d at = (p.cast<double>() - head.center).cwiseQuotient(head.radii);
    return {forwards * at.x(), at.y(), forwards * at.z()};
  }
};

std::optional<HeadView> view_of(const SourceModel& source, std::uint32_t node) {
  // Its mesh may be the hair.
  const HeadLandmarks marks = find_joint_landmarks(source, node);
  if (!marks.show_size()) return std::nullopt;
  return HeadView{likeliest_head(marks), marks.forwards < 0 ? -1.0 : 1.0};
}

bool is_of_crown(const Vector3d& direction) {
  return direction.y() > 0.3 || (direction.z() < -0.3 && direction.y() > -0.3);
}

bool is_of_face(const Vector3d& direction) {
  return direction.z() > 0.6 && direction.y() < 0.25 && direction.y() > -0.7;
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

/// Which part is outermost in each direction.
class Outermost {
 public:
  Outermost() : directions_(directions()), far_(kDirections, 0.0), part_(kDirections, importer::kNoIndex) {}

  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c, std::uint32_t part) {
    const Vector3d middle = ((a + b + c) / 3).normalized();
    const double wide = std::max(
        {(a.normalized() - middle).norm(), (b.normalized() - middle).norm(), (c.normalized() - middle).norm()});
    for (std::size_t d = 0; d < kDirections; ++d) {
      if ((directions_[d] - middle).norm() > wide + 1.0e-9) continue;
      const double far = meeting(directions_[d], a, b, c);
      if (far < kNearest || far > kFarthest || far <= far_[d]) continue;
      far_[d] = far;
      part_[d] = part;
    }
  }

  /// Fills Part::crown and Part::face.
  void share_out(std::vector<Part>& parts) const {
    const auto count = [&](auto is_of) { return double(std::ranges::count_if(directions_, is_of)); };
    const double crown = count(is_of_crown), face = count(is_of_face);
    for (std::size_t d = 0; d < kDirections; ++d) {
      if (part_[d] == importer::kNoIndex) continue;
      if (is_of_crown(directions_[d])) parts[part_[d]].crown += 1 / crown;
      if (is_of_face(directions_[d])) parts[part_[d]].face += 1 / face;
    }
  }

 private:
  std::vector<Vector3d> directions_;
  std::vector<double> far_;
  std::vector<std::uint32_t> part_;
};

/// Pieces of all meshes, with what each covers of the head.
struct Parts {
  std::vector<Part> parts;
  std::vector<MeshPieces> pieces;         ///< One entry per mesh.
  std::vector<std::uint32_t> first_part;  ///< Per mesh: the part that its piece 0 is.
};

Parts parts_around(const SourceModel& source, const HeadView& view, std::uint32_t head, double weld_distance) {
  Parts all;
  Outermost outermost;
  const std::vector<bool> no_bones(source.nodes.size(), false);
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    all.pieces.push_back(find_pieces(mesh, weld_distance));
    all.first_part.push_back(std::uint32_t(all.parts.size()));
    const std::vector<PieceEvidence> evidence = weigh_pieces(source, mesh, all.pieces[m], no_bones, head);
    for (std::uint32_t p = 0; p < all.pieces[m].count; ++p) all.parts.push_back({evidence[p].head_share});
    for (std::size_t t = 0; t < all.pieces[m].piece_of.size(); ++t) {
      const std::uint32_t part = all.first_part[m] + all.pieces[m].piece_of[t];
      if (all.parts[part].on_head < kOnlyOnHead) continue;
      const auto corner = [&](std::size_t k) { return view.in_axes(mesh.positions[mesh.triangles[3 * t + k]]); };
      outermost.add(corner(0), corner(1), corner(2), part);
    }
  }
  outermost.share_out(all.parts);
  return all;
}

/// Worn, or skin by its name: no hair, whatever it covers.
bool is_called_otherwise(const SourceModel& source, const SourceMesh& mesh) {
  return either_is_called(source, mesh, is_called_headwear) || either_is_called(source, mesh, is_called_adornment) ||
         is_called_skin(importer::material_name(source, mesh));
}

bool may_be_hair(double crown, double face, double least) { return crown >= least && face <= kMostFace; }

}  // namespace

CrownCover find_crown_cover(const SourceModel& source, const HairChoice& so_far, std::uint32_t head,
                            double weld_distance) {
  CrownCover cover;
  cover.choice.taken.resize(source.meshes.size());
  const auto view = view_of(source, head);
  if (!view) return cover;
  const Parts all = parts_around(source, *view, head, weld_distance);
  double taken = 0;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    std::vector<bool> has(all.pieces[m].count, false);
    for (std::size_t t = 0; t < all.pieces[m].piece_of.size(); ++t)
      if (so_far.takes(m, t)) has[all.pieces[m].piece_of[t]] = true;
    for (std::uint32_t p = 0; p < all.pieces[m].count; ++p)
      if (has[p]) taken += all.parts[all.first_part[m] + p].crown;
  }
  if (taken > kCovered) return cover;
  // Whole meshes of one material first; pieces of what is merged only where none of them is hair.
  const auto take = [&](std::uint32_t m, auto is_hair) {
    std::vector<bool> triangles;
    for (const std::uint32_t piece : all.pieces[m].piece_of)
      triangles.push_back(is_hair(all.parts[all.first_part[m] + piece]));
    if (std::ranges::count(triangles, true) == 0) return;
    cover.choice.taken[m] = std::move(triangles);
    cover.found = true;
  };
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    if (is_called_otherwise(source, source.meshes[m])) continue;
    double crown = 0, face = 0;
    for (std::uint32_t p = 0; p < all.pieces[m].count; ++p) {
      crown += all.parts[all.first_part[m] + p].crown;
      face += all.parts[all.first_part[m] + p].face;
    }
    if (may_be_hair(crown, face, kLeastCrown)) take(m, [](const Part& part) { return part.on_head >= kOnlyOnHead; });
  }
  for (std::uint32_t m = 0; m < source.meshes.size() && !cover.found; ++m) {
    if (is_called_otherwise(source, source.meshes[m])) continue;
    take(m, [](const Part& part) { return may_be_hair(part.crown, part.face, kLeastCrownOfPiece); });
  }
  return cover;
}

}  // namespace coif::cook
