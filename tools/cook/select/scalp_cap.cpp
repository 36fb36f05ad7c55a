#include "cook/select/under_hair.h"

#include "cook/select/triangle_distance.h"

namespace coif::cook {
namespace {

constexpr double kClose = 0.1;         ///< Share of the hair's width: largest distance of a cap from hair.
constexpr double kMostOfIt = 0.9;      ///< Share of a cap's vertices that must be that near.
constexpr double kLeastWidth = 0.4;    ///< Share of the hair's smaller horizontal size that a cap covers at least.
constexpr double kLeastHeight = 0.25;  ///< Share of its height that a cap covers at least.
constexpr std::size_t kLooked = 2000;  ///< Vertices of a mesh that are looked at.

bool is_cap(const importer::SourceMesh& mesh, const TriangleSoup& hair, const TriangleGrid& grid, double reach) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : mesh.positions) box.extend(p);
  const Eigen::Vector3f size = box.sizes(), all = hair.box.sizes();
  const double width = std::min(all.x(), all.z());
  if (std::min(size.x(), size.z()) < kLeastWidth * width || size.y() < kLeastHeight * width) return false;
  const std::size_t step = std::max<std::size_t>(1, mesh.positions.size() / kLooked);
  std::size_t looked = 0, close = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); v += step) {
    ++looked;
    close += grid.distance(mesh.positions[v], 0.5 * reach) < reach ? 1 : 0;
  }
  return double(close) >= kMostOfIt * double(looked);
}

}  // namespace

std::vector<bool> find_scalp_caps(const importer::SourceModel& source, const HairChoice& choice) {
  std::vector<bool> caps(source.meshes.size(), false);
  const TriangleSoup hair = chosen_hair(source, choice);
  if (hair.triangles.empty() || hair.triangles.size() == 3) return caps;
  const Eigen::Vector3f size = hair.box.sizes();
  const double reach = kClose * double(std::min(size.x(), size.z()));
  if (!(reach > 0)) return caps;
  const TriangleGrid grid(hair.positions, hair.triangles, reach);
  for (std::size_t m = 0; m < caps.size(); ++m) {
    caps[m] =
        choice.taken[m].empty() && !source.meshes[m].positions.empty() && is_cap(source.meshes[m], hair, grid, reach);
  }
  return caps;
}

}  // namespace coif::cook
