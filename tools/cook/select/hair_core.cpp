#include "cook/select/hair_core.h"

#include "cook/select/chosen_hair.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/mesh_topology.h"
#include "cook/select/triangle_distance.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace coif {
namespace {

// Lengths are shares of the head's width.
constexpr double kWrapsWithin = 0.13;  ///< So far from hair may lie
constexpr double kWrapped = 0.8;       ///< all but a few of a core's corners, whose strips leave gaps.
constexpr double kThickest = 0.65;     ///< The second largest size of a core's box.
constexpr double kLeastReach = 0.3;    ///< So far its end is from everything else.
constexpr double kFollowsHead = 0.3;   ///< Of its skin weight.
constexpr double kFollowsEyes = 0.15;  ///< The same: then it is a lid or a lash.

/// Triangles that are joined in the model and in the texture.
MeshPieces find_islands(const SourceMesh& mesh) {
  if (mesh.uvs.empty()) return find_pieces(mesh, 0);
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, 0);
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> first_at;
  DisjointSets sets(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const auto [at, is_new] = first_at.try_emplace({place[v], mesh.uvs[v].x(), mesh.uvs[v].y()}, v);
    sets.unite(at->second, v);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sets.unite(mesh.triangles[i / 3 * 3], mesh.triangles[i]);
  MeshPieces islands;
  std::map<std::uint32_t, std::uint32_t> number;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const auto [at, is_new] = number.try_emplace(sets.find(mesh.triangles[i]), islands.count);
    islands.count += is_new ? 1 : 0;
    islands.piece_of.push_back(at->second);
  }
  return islands;
}

/// One island of a mesh that gave no hair.
struct Island {
  std::uint32_t mesh = 0;
  std::vector<std::uint32_t> corners;  ///< Vertices of its triangles, three for each.
  Eigen::AlignedBox3f box;
  bool follows_head = false;
  bool is_wrapped = false;  ///< Hair lies close around it.
};

std::vector<Island> islands_beside(const SourceModel& source, const HairChoice& choice, std::uint32_t head_node) {
  const std::vector<bool> bones = find_hair_bones(source);
  std::vector<Island> islands;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    if (!choice.taken[m].empty()) continue;
    const MeshPieces pieces = find_islands(mesh);
    const std::vector<PieceEvidence> evidence = weigh_pieces(source, mesh, pieces, bones, head_node);
    const std::size_t first = islands.size();
    islands.resize(first + pieces.count);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      Island& island = islands[first + pieces.piece_of[i / 3]];
      island.corners.push_back(mesh.triangles[i]);
      island.box.extend(mesh.positions[mesh.triangles[i]]);
    }
    for (std::uint32_t p = 0; p < pieces.count; ++p) {
      const PieceEvidence& piece = evidence[p];
      islands[first + p].mesh = m;
      islands[first + p].follows_head = piece.head_share >= kFollowsHead && piece.eye_bone_share < kFollowsEyes;
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

bool is_wrapped(const SourceMesh& mesh, const Island& island, const TriangleGrid& hair, double close) {
  const auto most_apart = std::size_t((1 - kWrapped) * double(island.corners.size()));
  std::size_t apart = 0;
  for (const std::uint32_t v : island.corners) {
    apart += hair.distance(mesh.positions[v], {true}, close) < close ? 0 : 1;
    if (apart > most_apart) return false;
  }
  return true;
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

/// All triangles but those of hair and of wrapped islands.
struct Rest {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> triangles, group;

  Rest(const SourceModel& source, std::span<const Island> islands, const Eigen::AlignedBox3f& around) {
    for (const Island& island : islands) {
      if (island.is_wrapped || !island.box.intersects(around)) continue;
      for (const std::uint32_t v : island.corners) {
        triangles.push_back(std::uint32_t(positions.size()));
        positions.push_back(source.meshes[island.mesh].positions[v]);
      }
    }
    group.assign(triangles.size() / 3, 0);
  }
};

class Cores {
 public:
  Cores(const SourceModel& source, std::span<const Island> islands, double head_width,
        const Eigen::AlignedBox3f& around)
      : source_(source),
        islands_(islands),
        width_(head_width),
        rest_(source, islands, around),
        grid_(rest_.positions, rest_.triangles, rest_.group, kLeastReach * head_width) {}

  [[nodiscard]] bool is_core(std::span<const std::size_t> group) const {
    Eigen::AlignedBox3f box;
    for (const std::size_t i : group) box.extend(islands_[i].box);
    if (median_of(box.sizes()) > kThickest * width_) return false;
    return std::ranges::any_of(group, [this](std::size_t i) { return reaches_out(islands_[i]); });
  }

 private:
  [[nodiscard]] bool reaches_out(const Island& island) const {
    const double reach = kLeastReach * width_;
    const auto is_far = [&](std::uint32_t v) {
      return grid_.distance(source_.meshes[island.mesh].positions[v], {true}, reach) >= reach;
    };
    return std::ranges::any_of(island.corners, is_far);
  }

  const SourceModel& source_;
  std::span<const Island> islands_;
  double width_;
  Rest rest_;
  TriangleGrid grid_;
};

void take(const SourceModel& source, const Island& island, HairChoice& cores) {
  const SourceMesh& mesh = source.meshes[island.mesh];
  std::vector<bool>& taken = cores.taken[island.mesh];
  taken.resize(mesh.triangles.size() / 3, false);
  std::size_t next = 0;  // corners are in the order of the triangles
  for (std::size_t t = 0; t < taken.size() && next < island.corners.size(); ++t) {
    if (!std::equal(mesh.triangles.begin() + std::ptrdiff_t(3 * t), mesh.triangles.begin() + std::ptrdiff_t(3 * t + 3),
                    island.corners.begin() + std::ptrdiff_t(next)))
      continue;
    taken[t] = true;
    next += 3;
  }
}

}  // namespace

namespace {

/// A mesh that is nothing but core is a band or an ornament, and stays where it is worn.
void leave_what_is_worn(HairChoice& cores) {
  for (std::vector<bool>& taken : cores.taken) {
    if (std::ranges::count(taken, false) == 0) taken.clear();
  }
}

}  // namespace

HairChoice find_hair_cores(const SourceModel& source, const HairChoice& choice, std::uint32_t head_node) {
  HairChoice cores;
  cores.taken.resize(source.meshes.size());
  const ChosenHair hair(source, choice);
  if (head_node == kNoIndex || hair.triangles.empty()) return cores;
  std::vector<Island> islands = islands_beside(source, choice, head_node);
  const double width = width_of_head(islands);
  if (!(width > 0)) return cores;
  const double close = kWrapsWithin * width;
  const TriangleGrid grid(hair.positions, hair.triangles, hair.group, close);
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
    for (const std::size_t i : group) take(source, islands[i], cores);
  }
  leave_what_is_worn(cores);
  return cores;
}

}  // namespace coif
