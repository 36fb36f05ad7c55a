#include "cook/recipe/strip_recipe.h"
#include "cook/select/mesh_topology.h"
#include "cook/strands/strand_direction.h"
#include "cook/strands/strand_evidence.h"
#include "platform/stop.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <array>
#include <queue>
#include <unordered_map>

namespace coif::cook {
namespace {

using Eigen::AlignedBox3f;
using Eigen::Vector3f;

constexpr std::size_t kSections = 8;  ///< Root to tip.
/// Share of the head's radius: a patch that hides its own back half is too wide.
constexpr double kWidestPatch = 0.75;
constexpr float kAlongStrand = 0.7071068f;  ///< Cosine: an edge at less than 45 degrees to the strand runs along it.

/// The extent of a part of a patch, section by section from root to tip.
struct Extent {
  std::array<AlignedBox3f, kSections> boxes;

  void add(const Extent& other) {
    for (std::size_t s = 0; s < kSections; ++s) boxes[s].extend(other.boxes[s]);
  }

  /// Mean over the sections that have anything, metres. Sections are short, so their size is that across the strand.
  [[nodiscard]] float width() const {
    float sum = 0, count = 0;
    for (const AlignedBox3f& box : boxes) {
      if (box.isEmpty()) continue;
      sum += box.diagonal().norm();
      count += 1;
    }
    return count > 0 ? sum / count : 0;
  }
};

Vector3f middle_of(const HairMesh& mesh, std::uint32_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

std::size_t section_of(const HairStrips& hair, std::uint32_t t) {
  float place = 0;
  for (std::size_t k = 0; k < 3; ++k) place += hair.strands.place[hair.mesh.triangles[3 * t + k]] / 3;
  return std::min(kSections - 1, std::size_t(std::max(0.0f, place) * float(kSections)));
}

/// Unit direction of the strands in each triangle, zero where unknown. From the place along the strand rather than from
/// tangents, which depend on normals: the same hair from another exporter is to be cut in the same way.
std::vector<Vector3f> directions_of(const HairStrips& hair) {
  std::vector<Vector3f> directions;
  directions.reserve(hair.mesh.triangle_count());
  for (std::size_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    directions.push_back(gradient(hair.mesh, 3 * t, hair.strands.place).stableNormalized());
  }
  return directions;
}

/// The part of a triangle's offset from `origin` that is across the strands.
Vector3f across(const HairMesh& mesh, const Vector3f& direction, std::uint32_t t, const Vector3f& origin) {
  const Vector3f from = middle_of(mesh, t) - origin;
  return from - direction * direction.dot(from);
}

/// Middle of each section, per patch; offsets of that section are relative to it.
using Origins = std::vector<std::array<Vector3f, kSections>>;

Origins section_origins(const HairStrips& hair) {
  struct Mean {
    Vector3f sum = Vector3f::Zero();
    float count = 0;
  };
  std::vector<std::array<Mean, kSections>> means(hair.patches.count);
  for (std::uint32_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    Mean& mean = means[hair.patches.patch_of[t]][section_of(hair, t)];
    mean.sum += middle_of(hair.mesh, t);
    mean.count += 1;
  }
  Origins origins(means.size());
  for (std::size_t p = 0; p < means.size(); ++p) {
    for (std::size_t s = 0; s < kSections; ++s) origins[p][s] = means[p][s].sum / std::max(means[p][s].count, 1.0f);
  }
  return origins;
}

/// The extent of each group of triangles; kNoIndex: in no group.
std::vector<Extent> extents_of(const HairStrips& hair, std::span<const std::uint32_t> group_of, std::size_t groups) {
  const Origins origins = section_origins(hair);
  const std::vector<Vector3f> directions = directions_of(hair);
  std::vector<Extent> extents(groups);
  for (std::uint32_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    if (group_of[t] == importer::kNoIndex) continue;
    const std::size_t s = section_of(hair, t);
    extents[group_of[t]].boxes[s].extend(across(hair.mesh, directions[t], t, origins[hair.patches.patch_of[t]][s]));
  }
  return extents;
}

float side_length(const HairMesh& mesh, std::uint32_t t, std::uint32_t side) {
  return (mesh.corner(t, (side + 1) % 3) - mesh.corner(t, side)).norm();
}

/// The longest side of both its triangles: the diagonal of a former quad.
bool is_diagonal(const HairMesh& mesh, std::span<const EdgeUse> uses) {
  return std::ranges::all_of(uses, [&](const EdgeUse& use) {
    const float length = side_length(mesh, use.triangle, use.side) * 1.0001f;
    return length >= side_length(mesh, use.triangle, (use.side + 1) % 3) &&
           length >= side_length(mesh, use.triangle, (use.side + 2) % 3);
  });
}

bool runs_along_strand(const HairMesh& mesh, std::span<const Vector3f> directions, std::span<const EdgeUse> uses) {
  const EdgeUse& use = uses[0];
  const Vector3f edge =
      (mesh.corner(use.triangle, (use.side + 1) % 3) - mesh.corner(use.triangle, use.side)).normalized();
  const Vector3f strand = directions[uses[0].triangle] + directions[uses[1].triangle];
  return std::abs(edge.dot(strand)) > kAlongStrand * strand.norm();
}

/// A pair of neighbouring groups and how wide they would be together.
struct Pair {
  float width = 0;
  std::uint32_t a = 0, b = 0;
  std::uint32_t version_a = 0, version_b = 0;

  bool operator>(const Pair& other) const { return std::tie(width, a, b) > std::tie(other.width, other.a, other.b); }
};

/// Joins ribbons while the result is narrow enough.
class RibbonMerger {
 public:
  RibbonMerger(std::vector<Extent> extents, float widest)
      : sets_(extents.size()),
        extents_(std::move(extents)),
        version_(extents_.size(), 0),
        neighbours_(extents_.size()),
        widest_(widest) {}

  void add_neighbours(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
  }

  void run(const std::stop_token& stop) {
    for (std::uint32_t a = 0; a < neighbours_.size(); ++a) propose_all(a);
    while (!queue_.empty()) {
      platform::throw_if_stopped(stop);
      const Pair pair = queue_.top();
      queue_.pop();
      // A part that was joined since has a new proposal in the queue.
      if (version_[pair.a] != pair.version_a || version_[pair.b] != pair.version_b) continue;
      join(pair.a, pair.b);
    }
  }

  std::uint32_t group_of(std::uint32_t ribbon) { return sets_.find(ribbon); }

 private:
  void propose_all(std::uint32_t a) {
    auto& around = neighbours_[a];
    for (std::uint32_t& b : around) b = sets_.find(b);
    std::ranges::sort(around);
    around.erase(std::ranges::unique(around).begin(), around.end());
    std::erase(around, a);
    for (std::uint32_t b : around) {
      Extent both = extents_[a];
      both.add(extents_[b]);
      const float width = both.width();
      if (width <= widest_)
        queue_.push({width, std::min(a, b), std::max(a, b), version_[std::min(a, b)], version_[std::max(a, b)]});
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    sets_.unite(a, b);
    const std::uint32_t kept = sets_.find(a), gone = kept == a ? b : a;
    extents_[kept].add(extents_[gone]);
    neighbours_[kept].insert(neighbours_[kept].end(), neighbours_[gone].begin(), neighbours_[gone].end());
    neighbours_[gone].clear();
    ++version_[kept];
    ++version_[gone];
    propose_all(kept);
  }

  DisjointSets sets_;
  std::vector<Extent> extents_;
  std::vector<std::uint32_t> version_;
  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue_;
  float widest_;
};

struct Ribbons {
  std::vector<std::uint32_t> ribbon_of;  ///< Per triangle; kNoIndex outside of the shells.
  std::uint32_t count = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
};

/// Rows of quads along the strands, inside the patches that are shells.
Ribbons find_ribbons(const HairStrips& hair, const std::vector<bool>& is_shell) {
  const std::vector<std::uint32_t>& patch_of = hair.patches.patch_of;
  const std::vector<Vector3f> directions = directions_of(hair);
  const std::size_t triangles = hair.mesh.triangle_count();
  DisjointSets sets(triangles);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for_each_edge(sorted_edges(hair.mesh.triangles, hair.welded), [&](std::span<const EdgeUse> uses) {
    const std::uint32_t patch = patch_of[uses[0].triangle];
    if (uses.size() != 2 || patch_of[uses[1].triangle] != patch || !is_shell[patch]) return;
    if (is_diagonal(hair.mesh, uses) || !runs_along_strand(hair.mesh, directions, uses)) {
      sets.unite(uses[0].triangle, uses[1].triangle);
    } else {
      sides.emplace_back(uses[0].triangle, uses[1].triangle);
    }
  });
  Ribbons ribbons;
  ribbons.ribbon_of.assign(triangles, importer::kNoIndex);
  std::vector<std::uint32_t> number(triangles, importer::kNoIndex);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (!is_shell[patch_of[t]]) continue;
    std::uint32_t& ribbon = number[sets.find(t)];
    if (ribbon == importer::kNoIndex) ribbon = ribbons.count++;
    ribbons.ribbon_of[t] = ribbon;
  }
  for (const auto& [a, b] : sides) ribbons.neighbours.emplace_back(ribbons.ribbon_of[a], ribbons.ribbon_of[b]);
  return ribbons;
}

}  // namespace

double widest_patch(const StripRecipe& recipe, const FittedHead& head) {
  return recipe.patch_widest > 0 ? recipe.patch_widest : kWidestPatch * head.radii.mean();
}

ShellSplit split_shells(HairStrips& hair, double widest, Findings& findings, const std::stop_token& stop) {
  PatchSet& patches = hair.patches;
  const std::uint32_t before = patches.count;
  const auto limit = float(widest);
  std::vector<bool> is_shell(before);
  ShellSplit split;
  const std::vector<Extent> extents = extents_of(hair, patches.patch_of, before);
  for (std::uint32_t p = 0; p < before; ++p) {
    is_shell[p] = extents[p].width() > limit;
    split.shells += is_shell[p] ? 1 : 0;
  }
  if (split.shells == 0) return split;
  const Ribbons ribbons = find_ribbons(hair, is_shell);
  RibbonMerger merger(extents_of(hair, ribbons.ribbon_of, ribbons.count), limit);
  for (const auto& [a, b] : ribbons.neighbours) merger.add_neighbours(a, b);
  merger.run(stop);
  std::vector<std::uint32_t> part_of = ribbons.ribbon_of;
  for (std::uint32_t& part : part_of) part = part == importer::kNoIndex ? importer::kNoIndex : merger.group_of(part);
  patches.cut(part_of);
  split.parts = split.shells + patches.count - before;
  const std::vector<Extent> after = extents_of(hair, patches.patch_of, patches.count);
  split.left = std::uint32_t(std::ranges::count_if(after, [&](const Extent& e) { return e.width() > limit; }));
  hair.separate_patches();
  findings.note(fmt::format("patches: {} too wide to sort, cut along the strands into {}{}", split.shells, split.parts,
                            split.left == 0 ? "" : fmt::format("; {} still too wide", split.left)));
  return split;
}

}  // namespace coif::cook
