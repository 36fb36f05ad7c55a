#include "cook/select/select_hair.h"

#include "base/geometry.h"
#include "cook/select/triangle_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace coif::cook {
namespace {

constexpr float kLeastOverlap = 0.85f;      ///< Along each axis, share of the range that both cover.
constexpr double kMostOfFinerMesh = 0.8;    ///< Triangles; two layers of locks have about as many.
constexpr double kLeastOfFinerMesh = 0.02;  ///< Below that it is a ribbon, or a plane that was forgotten.
constexpr double kOnSurface = 0.01;         ///< Share of the size: how far a simplified surface moves.
constexpr double kLeastOnSurface = 0.95;    ///< Share of the corners that were looked at.
constexpr std::size_t kMostPieces = 64;     ///< Hair of more nodes than that is made of locks.
constexpr std::size_t kMostLookedAt = 500;

/// All hair of one node, which is one mesh of the artist's.
struct Piece {
  std::uint32_t first = 0;  ///< Into the source's meshes.
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> triangles;
  Eigen::AlignedBox3f box;

  [[nodiscard]] std::size_t count() const { return triangles.size() / 3; }
};

std::vector<Piece> pieces_of(const importer::SourceModel& source, std::span<const std::uint32_t> hair) {
  std::map<std::uint32_t, Piece> of_node;
  for (const std::uint32_t m : hair) {
    const importer::SourceMesh& mesh = source.meshes[m];
    const auto [entry, is_new] = of_node.emplace(mesh.node, Piece{m, {}, {}, {}});
    Piece& piece = entry->second;
    const auto base = std::uint32_t(piece.positions.size());
    piece.positions.insert(piece.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const std::uint32_t v : mesh.triangles) piece.triangles.push_back(base + v);
    for (const Eigen::Vector3f& position : mesh.positions) piece.box.extend(position);
  }
  std::vector<Piece> pieces;
  for (auto& [node, piece] : of_node) pieces.push_back(std::move(piece));
  return pieces;
}

/// Whether nearly all corners of `a` lie on the surface of `b`.
bool lies_on(const Piece& a, const Piece& b) {
  const double reach = kOnSurface * double(b.box.diagonal().norm());
  if (!(reach > 0)) return false;
  const TriangleGrid surface(b.positions, b.triangles, reach);
  const std::size_t step = std::max<std::size_t>(1, a.positions.size() / kMostLookedAt);
  std::size_t looked_at = 0, on_it = 0;
  for (std::size_t v = 0; v < a.positions.size(); v += step) {
    ++looked_at;
    if (surface.distance(a.positions[v], reach) < reach) ++on_it;
  }
  return double(on_it) >= kLeastOnSurface * double(looked_at);
}

bool is_coarser_copy(const Piece& coarse, const Piece& fine) {
  const double share = double(coarse.count()) / double(fine.count());
  return share <= kMostOfFinerMesh && share >= kLeastOfFinerMesh &&
         overlap_on_each_axis(coarse.box, fine.box, kLeastOverlap) && lies_on(coarse, fine);
}

}  // namespace

void warn_of_stacked_meshes(const importer::SourceModel& source, std::span<const std::uint32_t> hair,
                            Findings& findings) {
  const std::vector<Piece> pieces = pieces_of(source, hair);
  if (pieces.size() > kMostPieces) return;
  for (const Piece& fine : pieces) {
    for (const Piece& coarse : pieces) {
      if (!is_coarser_copy(coarse, fine)) continue;
      const std::string &name = source.meshes[fine.first].name, &other = source.meshes[coarse.first].name;
      findings.warn("C115",
                    fmt::format("mesh '{}' ({} triangles) lies on mesh '{}' ({} triangles), as a coarser level of "
                                "detail does, and both are drawn; if it is one, name the other in the recipe: "
                                "\"hair\": {{\"meshes\": [\"{}\"]}}",
                                other, coarse.count(), name, fine.count(), name));
    }
  }
}

}  // namespace coif::cook
