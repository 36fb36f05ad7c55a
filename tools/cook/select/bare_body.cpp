#include "cook/select/hair_evidence.h"

#include "cook/select/mesh_topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

// A sphere has the roundness 1, heads have 0.3 to 0.9, busts 0.3. Strips and sheets of hair are open; tubes and shells
// of hair have less than 0.1. The rim of an open sheet is at least 2 times the root of its area, that of a head without
// a neck once.
constexpr double kLeastRound = 0.2;
constexpr double kMostOpen = 1.6;
constexpr double kNearlyWhole = 0.8;     // Share of the model's surface.
constexpr double kMostOpenFigure = 0.3;  // As kMostOpen, for figures.
constexpr double kLeastFigure = 1.2;     // metres, of a figure
constexpr float kLeastSlim = 1.5f;       // Height of a body over its depth.
constexpr double kOnGround = 0.05;       // Share of its height.

/// One connected piece of a mesh, by its form.
struct PieceForm {
  double area = 0, volume = 0, rim = 0;  // `rim`: length of the edges that only one triangle has.
  Vector3d first = Vector3d::Zero();
  Eigen::AlignedBox3d box;

  [[nodiscard]] double open() const { return area > 0 ? rim / std::sqrt(area) : 0; }
  /// The squared ratio of its volume to that of a sphere with the same surface.
  [[nodiscard]] double round() const {
    return area > 0 ? 36 * std::numbers::pi * volume * volume / (area * area * area) : 0;
  }
  [[nodiscard]] bool is_full() const { return open() < kMostOpen && round() > kLeastRound; }
};

void add_triangle(const importer::SourceMesh& mesh, std::size_t t, PieceForm& piece) {
  Vector3d corner[3];
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = mesh.positions[mesh.triangles[3 * t + k]].cast<double>();
    piece.box.extend(corner[k]);
  }
  // Volumes are computed from a point of the piece itself, so that slightly open pieces have about the right volume.
  if (piece.area == 0) piece.first = corner[0];
  piece.area += 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
  piece.volume += (corner[0] - piece.first).dot((corner[1] - piece.first).cross(corner[2] - piece.first)) / 6;
}

void append_forms(const importer::SourceMesh& mesh, double weld_distance, std::vector<PieceForm>& all) {
  const MeshPieces pieces = find_pieces(mesh, weld_distance);
  std::vector<PieceForm> forms(pieces.count);
  for (std::size_t t = 0; t < pieces.piece_of.size(); ++t) add_triangle(mesh, t, forms[pieces.piece_of[t]]);
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, weld_distance);
  const std::vector<EdgeUse> edges = sorted_edges(mesh.triangles, place);
  for_each_edge(edges, [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    const std::size_t first = 3 * std::size_t(uses[0].triangle), side = uses[0].side;
    const Eigen::Vector3f along =
        mesh.positions[mesh.triangles[first + side]] - mesh.positions[mesh.triangles[first + (side + 1) % 3]];
    forms[pieces.piece_of[uses[0].triangle]].rim += double(along.norm());
  });
  all.insert(all.end(), forms.begin(), forms.end());
}

bool is_figure(const PieceForm& piece) {
  const double height = piece.box.sizes().y();
  return piece.open() < kMostOpenFigure && height >= kLeastFigure && std::abs(piece.box.min().y()) < kOnGround * height;
}

}  // namespace

bool is_bare_body(const importer::SourceModel& source, double weld_distance) {
  std::vector<PieceForm> forms;
  for (const importer::SourceMesh& mesh : source.meshes) append_forms(mesh, weld_distance, forms);
  if (forms.empty()) return false;
  double all = 0, full = 0;
  for (const PieceForm& piece : forms) {
    all += piece.area;
    if (piece.is_full()) full += piece.area;
  }
  const PieceForm& largest = *std::ranges::max_element(forms, {}, &PieceForm::area);
  return full >= kNearlyWhole * all || (largest.area >= 0.5 * all && is_figure(largest));
}

bool stands_on_ground(const importer::SourceModel& source) {
  Eigen::AlignedBox3f box;
  for (const importer::SourceMesh& mesh : source.meshes)
    for (const Eigen::Vector3f& p : mesh.positions) box.extend(p);
  if (box.isEmpty()) return false;
  const Eigen::Vector3f size = box.sizes();
  return std::abs(box.min().y()) < float(kOnGround) * size.y() && size.y() > kLeastSlim * size.z();
}

std::string empty_hair_node(const importer::SourceModel& source) {
  std::vector<bool> holds(source.nodes.size(), false);
  for (const importer::SourceNode& node : source.nodes) {
    if (node.parent != importer::kNoIndex) holds[node.parent] = true;
  }
  for (const importer::SourceMesh& mesh : source.meshes) {
    holds[mesh.node] = true;
    for (const importer::SourceInfluence& influence : mesh.influences) holds[influence.node] = true;
  }
  for (std::size_t n = 0; n < source.nodes.size(); ++n) {
    if (!holds[n] && is_called_hair(source.nodes[n].name)) return source.nodes[n].name;
  }
  return "";
}

}  // namespace coif::cook
