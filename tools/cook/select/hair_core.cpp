#include "cook/select/under_hair.h"

#include "cook/select/hair_evidence.h"
#include "cook/select/mesh_topology.h"
#include "cook/select/triangle_distance.h"

#include <algorithm>
#include <map>

namespace coif::cook {
namespace {

// Lengths are shares of the head's width.
constexpr double kWrapsWithin = 0.13;  ///< Largest distance of hair from a core's corner.
/// Share of a core's corners with hair that near; strips leave gaps.
constexpr double kWrapped = 0.8;
constexpr double kThickest = 0.65;   ///< The second largest size of a core's box.
constexpr double kLeastReach = 0.3;  ///< Smallest distance of its end from everything else.

/// One island of a mesh that gave no hair.
struct Island {
  std::uint32_t mesh = 0;
  std::vector<std::size_t> triangles;
  Eigen::AlignedBox3f box;
  bool follows_head = false;
  bool is_wrapped = false;  ///< Hair lies close around it.
};

std::vector<Island> islands_beside(const importer::SourceModel& source, const HairChoice& choice,
                                   std::uint32_t head_node) {
  const std::vector<bool> bones = find_hair_bones(source);
  std::vector<Island> islands;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const importer::SourceMesh& mesh = source.meshes[m];
    if (!choice.taken[m].empty()) continue;
    const MeshPieces pieces = find_islands(mesh, 0);
    const std::vector<PieceEvidence> evidence = weigh_pieces(source, mesh, pieces, bones, head_node);
    const std::size_t first = islands.size();
    islands.resize(first + pieces.count);
    for (std::size_t t = 0; t < pieces.piece_of.size(); ++t) {
      Island& island = islands[first + pieces.piece_of[t]];
      island.triangles.push_back(t);
      for (std::size_t k = 0; k < 3; ++k) island.box.extend(mesh.positions[mesh.triangles[3 * t + k]]);
    }
    for (std::uint32_t p = 0; p < pieces.count; ++p) {
      const PieceEvidence& piece = evidence[p];
      islands[first + p].mesh = m;
      islands[first + p].follows_head = piece.head_share >= kOnHead && piece.eye_bone_share < kMovedByEyes;
    }
  }
  return islands;
}

double width_of_head(std::span<const Island> islands) {
  Eigen::AlignedBox3f box;
  for (const Island& island : islands) {
    if (island.follows_head) box.extend(island.box);
  }
  return box.isEmpty() ? 0 : double(std::min(box.sizes().x(), box.sizes().z()));
}

double median_of(Eigen::Vector3f sizes) {
  std::ranges::sort(sizes);
  return double(sizes[1]);
}

/// Counts the corners of its triangles that `fit`; stops at `most`.
template <typename Fits>
std::size_t count_corners(const importer::SourceMesh& mesh, const Island& island, std::size_t most, const Fits& fits) {
  std::size_t count = 0;
  for (const std::size_t t : island.triangles) {
    for (std::size_t k = 0; k < 3 && count < most; ++k) {
      count += fits(mesh.positions[mesh.triangles[3 * t + k]]) ? 1 : 0;
    }
  }
  return count;
}

bool is_wrapped(const importer::SourceMesh& mesh, const Island& island, const TriangleGrid& hair, double close) {
  const auto too_many = std::size_t((1 - kWrapped) * double(3 * island.triangles.size())) + 1;
  const auto is_apart = [&](const Eigen::Vector3f& p) { return hair.distance(p, close) >= close; };
  return count_corners(mesh, island, too_many, is_apart) < too_many;
}

/// Islands that may be cores, joined where they touch: their numbers.
std::vector<std::vector<std::size_t>> groups_of(std::span<const Island> islands, float touch) {
  std::vector<std::size_t> wrapped;
  for (std::size_t i = 0; i < islands.size(); ++i) {
    if (islands[i].is_wrapped) wrapped.push_back(i);
  }
  DisjointSets sets(wrapped.size());
  for (std::uint32_t a = 0; a < wrapped.size(); ++a) {
    for (std::uint32_t b = a + 1; b < wrapped.size(); ++b) {
      const float apart = islands[wrapped[a]].box.squaredExteriorDistance(islands[wrapped[b]].box);
      if (apart <= touch * touch) sets.unite(a, b);
    }
  }
  std::map<std::uint32_t, std::vector<std::size_t>> groups;
  for (std::uint32_t k = 0; k < wrapped.size(); ++k) groups[sets.find(k)].push_back(wrapped[k]);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [root, group] : groups) result.push_back(std::move(group));
  return result;
}

/// All triangles except those of hair and of wrapped islands.
TriangleSoup rest_of(const importer::SourceModel& source, std::span<const Island> islands,
                     const Eigen::AlignedBox3f& around) {
  TriangleSoup rest;
  for (const Island& island : islands) {
    if (island.is_wrapped || !island.box.intersects(around)) continue;
    for (const std::size_t t : island.triangles) rest.add(source.meshes[island.mesh], t);
  }
  return rest;
}

class Cores {
 public:
  Cores(const importer::SourceModel& source, std::span<const Island> islands, double head_width,
        const Eigen::AlignedBox3f& around)
      : source_(source),
        islands_(islands),
        width_(head_width),
        rest_(rest_of(source, islands, around)),
        grid_(rest_.positions, rest_.triangles, kLeastReach * head_width) {}

  [[nodiscard]] bool is_core(std::span<const std::size_t> group) const {
    Eigen::AlignedBox3f box;
    for (const std::size_t i : group) box.extend(islands_[i].box);
    if (median_of(box.sizes()) > kThickest * width_) return false;
    return std::ranges::any_of(group, [this](std::size_t i) { return reaches_out(islands_[i]); });
  }

 private:
  [[nodiscard]] bool reaches_out(const Island& island) const {
    const double reach = kLeastReach * width_;
    const auto is_far = [&](const Eigen::Vector3f& p) { return grid_.distance(p, reach) >= reach; };
    return count_corners(source_.meshes[island.mesh], island, 1, is_far) == 1;
  }

  const importer::SourceModel& source_;
  std::span<const Island> islands_;
  double width_;
  TriangleSoup rest_;
  TriangleGrid grid_;
};

/// A mesh that is nothing but core is a band or an ornament, and stays where it is worn.
void leave_what_is_worn(HairChoice& cores) {
  for (std::vector<bool>& taken : cores.taken) {
    if (std::ranges::count(taken, false) == 0) taken.clear();
  }
}

}  // namespace

HairChoice find_hair_cores(const importer::SourceModel& source, const HairChoice& choice, std::uint32_t head_node) {
  HairChoice cores;
  cores.taken.resize(source.meshes.size());
  const TriangleSoup hair = chosen_hair(source, choice);
  if (head_node == importer::kNoIndex || hair.triangles.empty()) return cores;
  std::vector<Island> islands = islands_beside(source, choice, head_node);
  const double width = width_of_head(islands);
  if (!(width > 0)) return cores;
  const double close = kWrapsWithin * width;
  const TriangleGrid grid(hair.positions, hair.triangles, close);
  Eigen::AlignedBox3f around(hair.box.min().array() - float(close), hair.box.max().array() + float(close));
  for (Island& island : islands) {
    const bool is_slim = median_of(island.box.sizes()) <= kThickest * width;
    island.is_wrapped = island.follows_head && is_slim && around.contains(island.box) &&
                        is_wrapped(source.meshes[island.mesh], island, grid, close);
  }
  const auto groups = groups_of(islands, float(1e-3 * width));
  if (groups.empty()) return cores;
  const Cores found(source, islands, width, around);
  for (const std::vector<std::size_t>& group : groups) {
    if (!found.is_core(group)) continue;
    for (const std::size_t i : group) {
      std::vector<bool>& taken = cores.taken[islands[i].mesh];
      taken.resize(source.meshes[islands[i].mesh].triangles.size() / 3, false);
      for (const std::size_t t : islands[i].triangles) taken[t] = true;
    }
  }
  leave_what_is_worn(cores);
  return cores;
}

}  // namespace coif::cook
