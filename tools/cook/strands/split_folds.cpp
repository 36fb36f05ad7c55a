#include "cook/select/mesh_topology.h"
#include "cook/strands/patches.h"
#include "cook/strands/strand_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace coif::cook {
namespace {

/// Share of the reach of triangles at a fold along the axis: the fold's edges are shorter along it.
constexpr float kAcrossAxis = 0.5f;
constexpr double kLeastPart = 0.03;  ///< Share of the patch's area: a smaller part is no strip.

/// Per patch the texture axis along which it is long, 0 or 1; -1: neither.
std::vector<int> long_axes(const HairStrips& hair) {
  std::vector<int> axes;
  for (const PatchView& view : hair.views()) {
    const float preference = texture_preference(hair.mesh, view);
    axes.push_back(std::abs(preference) <= kLonger ? -1 : preference > 0 ? 1 : 0);
  }
  return axes;
}

/// The orientation of a triangle in the texture: 1, -1, or 0 where it has no area there.
int turn_of(const HairMesh& mesh, std::uint32_t t) {
  const auto uv = [&](std::size_t k) -> const Eigen::Vector2f& {
    return mesh.uvs[mesh.triangles[3 * std::size_t(t) + k]];
  };
  const Eigen::Vector2f a = uv(1) - uv(0), b = uv(2) - uv(0);
  const float area = a.x() * b.y() - a.y() * b.x();
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// The seam between two parts of opposite orientation: summed over its edges, the distance of their ends along the
/// strands' axis, and the reach of the triangles along it.
struct Seam {
  float ends_apart = 0, reach = 0;

  void add(const HairMesh& mesh, std::span<const EdgeUse> uses, int axis) {
    for (const EdgeUse& use : uses) {
      const auto at = [&](std::uint32_t corner) {
        return mesh.uvs[mesh.triangles[3 * use.triangle + corner % 3]][axis];
      };
      const float a = at(use.side), b = at(use.side + 1);
      ends_apart += std::abs(a - b);
      reach += std::abs(at(use.side + 2) - (a + b) / 2);
    }
  }
  /// It runs across the strands: both parts go on in the same direction from there. A seam along them is a texture used
  /// twice side by side.
  [[nodiscard]] bool is_fold() const { return ends_apart < kAcrossAxis * reach; }
};

struct Parts {
  DisjointSets sets;
  std::vector<std::array<std::uint32_t, 2>> folds;  ///< The triangles at each edge of one.
};

/// Whether the two triangles at an edge have opposite orientations.
bool turns_back(const HairMesh& mesh, std::span<const EdgeUse> uses) {
  return uses.size() == 2 && turn_of(mesh, uses[0].triangle) * turn_of(mesh, uses[1].triangle) < 0;
}

/// Cuts patches that are long along an axis of the texture: triangles stay together except across folds.
Parts cut_at_folds(const HairStrips& hair) {
  const HairMesh& mesh = hair.mesh;
  const std::vector<int> axes = long_axes(hair);
  const auto patch_at = [&](const EdgeUse& use) { return hair.patches.patch_of[use.triangle]; };
  Parts parts{DisjointSets(mesh.triangle_count()), {}};
  std::vector<std::array<EdgeUse, 2>> turns;
  for_each_edge(sorted_edges(mesh.triangles, hair.welded), [&](std::span<const EdgeUse> uses) {
    const std::uint32_t patch = patch_at(uses[0]);
    const bool is_inner = std::ranges::all_of(uses, [&](const EdgeUse& use) { return patch_at(use) == patch; });
    if (!is_inner || axes[patch] < 0) return;
    if (turns_back(mesh, uses)) {
      turns.push_back({uses[0], uses[1]});
    } else {
      for (const EdgeUse& use : uses) parts.sets.unite(uses[0].triangle, use.triangle);
    }
  });
  std::map<std::pair<std::uint32_t, std::uint32_t>, Seam> seams;
  const auto seam_at = [&](const std::array<EdgeUse, 2>& uses) {
    const std::uint32_t a = parts.sets.find(uses[0].triangle), b = parts.sets.find(uses[1].triangle);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (const auto& uses : turns) seams[seam_at(uses)].add(mesh, uses, axes[patch_at(uses[0])]);
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (const auto& uses : turns) {
    const bool is_fold = seams.at(seam_at(uses)).is_fold();
    (is_fold ? parts.folds : sides).push_back({uses[0].triangle, uses[1].triangle});
  }
  for (const auto& [a, b] : sides) parts.sets.unite(a, b);
  return parts;
}

/// Joins parts that are too small with the part across their fold.
void join_crumbs(const HairStrips& hair, Parts& parts) {
  std::vector<double> of_patch(hair.patches.count, 0), of_part(hair.mesh.triangle_count(), 0);
  for (std::uint32_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    const auto area = double(doubled_area(hair.mesh, 3 * t));
    of_patch[hair.patches.patch_of[t]] += area;
    of_part[parts.sets.find(t)] += area;
  }
  for (const auto& [a, b] : parts.folds) {
    const std::uint32_t one = parts.sets.find(a), other = parts.sets.find(b);
    const double least = kLeastPart * of_patch[hair.patches.patch_of[a]];
    if (one == other || std::min(of_part[one], of_part[other]) >= least) continue;
    const double both = of_part[one] + of_part[other];
    parts.sets.unite(one, other);
    of_part[parts.sets.find(one)] = both;
  }
}

}  // namespace

std::uint32_t split_folds(HairStrips& hair, Findings& findings) {
  if (hair.mesh.uvs.empty()) return 0;
  Parts parts = cut_at_folds(hair);
  if (parts.folds.empty()) return 0;
  join_crumbs(hair, parts);
  PatchSet& patches = hair.patches;
  const std::uint32_t before = patches.count;
  // A patch whose parts are also connected elsewhere stays whole.
  std::vector<bool> is_cut(before, false);
  for (const auto& [a, b] : parts.folds) {
    if (parts.sets.find(a) != parts.sets.find(b)) is_cut[patches.patch_of[a]] = true;
  }
  const auto folded = std::uint32_t(std::ranges::count(is_cut, true));
  if (folded == 0) return 0;
  std::vector<std::uint32_t> part_of(hair.mesh.triangle_count(), importer::kNoIndex);
  for (std::uint32_t t = 0; t < part_of.size(); ++t) {
    if (is_cut[patches.patch_of[t]]) part_of[t] = parts.sets.find(t);
  }
  patches.cut(part_of);
  hair.separate_patches();
  findings.note(fmt::format("patches: the texture turns back within {}, which are cut there into {}", folded,
                            folded + patches.count - before));
  return patches.count - before;
}

}  // namespace coif::cook
