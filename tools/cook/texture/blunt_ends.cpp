#include "base/parallel_for.h"
#include "cook/select/mesh_topology.h"
#include "cook/texture/patch_coverage.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>

namespace coif::cook {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// Places along a patch, 0 its first row .. 1 its last. At its very end a texture's border may be antialiased.
constexpr std::array kBody = {0.05f, 0.15f, 0.25f, 0.35f, 0.45f, 0.55f, 0.65f, 0.75f, 0.85f};
constexpr std::array kTip = {0.95f, 0.97f, 0.985f};
constexpr float kRimFrom = 0.85f;  ///< The corners of a last row need not be equally far along.
constexpr float kBlunt = 0.5f;     ///< Share of the greatest width; an end that narrows further is soft enough.
/// Share of the width at the tip that must be a free edge: closed shapes have none.
constexpr float kRimAtLeast = 0.5f;
constexpr std::size_t kRimEdges = 16;  ///< Most edges that are looked at per patch.
constexpr std::size_t kBlock = 64;     ///< Triangles that a ray misses together.
constexpr int kRowSamples = 8;         ///< Samples of alpha along the part of a row in one triangle.
constexpr float kTiedWithin = 0.3f;    ///< Share of the head's radius.
/// Some ends that are tied into other hair look like blunt ends to this test, so a smaller share is fine.
constexpr float kWarnShare = 0.15f;

struct RimEdge {
  Vector3f middle{0, 0, 0};
  Vector3f along{0, 0, 0};  ///< Unit, where the strands run.
  float across = 0;         ///< Metres perpendicular to the strands.
};

struct Corner {
  Vector3f position;
  Vector2f uv;
  float place = 0;
};

Corner between(const Corner& a, const Corner& b, float place) {
  const float t = (place - a.place) / (b.place - a.place);
  return {a.position + t * (b.position - a.position), a.uv + t * (b.uv - a.uv), place};
}

/// Share of the line that is opaque.
float opaque_share(const Corner& a, const Corner& b, const AlphaTest& opaque) {
  int passing = 0;
  for (int i = 0; i < kRowSamples; ++i) {
    const float t = (float(i) + 0.5f) / float(kRowSamples);
    passing += opaque.passes(a.uv + t * (b.uv - a.uv)) ? 1 : 0;
  }
  return float(passing) / float(kRowSamples);
}

/// The data about all patches of one mesh.
class TipEnds {
 public:
  TipEnds(const HairStrips& hair, const AlphaTest& opaque)
      : hair_(hair), mesh_(hair.mesh), strands_(hair.strands), opaque_(opaque), views_(hair.views()) {
    for (std::uint32_t p = 0; p < views_.size(); ++p) {
      Eigen::AlignedBox1f range;
      for (const std::uint32_t v : views_[p].vertices) range.extend(Eigen::Matrix<float, 1, 1>(strands_.place[v]));
      ranges_.push_back(range);
      add_blocks(p);
    }
  }

  /// Free edges near the tips of each patch. An edge is free where no other triangle of any patch lies along it.
  [[nodiscard]] std::vector<std::vector<RimEdge>> find_rims() const {
    std::vector<std::vector<RimEdge>> rims(views_.size());
    for_each_edge(sorted_edges(mesh_.triangles, hair_.welded), [&](std::span<const EdgeUse> uses) {
      if (uses.size() != 1) return;
      const std::size_t first = 3 * std::size_t(uses[0].triangle);
      const std::uint32_t a = mesh_.triangles[first + uses[0].side];
      const std::uint32_t b = mesh_.triangles[first + (uses[0].side + 1) % 3];
      const std::uint32_t patch = hair_.patches.patch_of[uses[0].triangle];
      if (std::min(strands_.place[a], strands_.place[b]) < level(patch, kRimFrom)) return;
      const Vector3f edge = mesh_.positions[b] - mesh_.positions[a];
      const Vector3f along = (strands_.tangent[a] + strands_.tangent[b]).stableNormalized();
      rims[patch].push_back(
          {(mesh_.positions[a] + mesh_.positions[b]) / 2, along, (edge - along * along.dot(edge)).norm()});
    });
    return rims;
  }

  [[nodiscard]] bool is_open(std::uint32_t patch, std::span<const RimEdge> rim, const FittedHead& head) const {
    float free = 0, looked_at = 0, shown = 0;
    for (const RimEdge& edge : rim) free += edge.across;
    if (!(free >= kRimAtLeast * width(patch, kTip.back(), false))) return false;
    // For a finely modelled end some edges are enough.
    const std::size_t step = (rim.size() + kRimEdges - 1) / kRimEdges;
    for (std::size_t i = 0; i < rim.size(); i += step) {
      looked_at += rim[i].across;
      if (!goes_under(patch, rim[i], head)) shown += rim[i].across;
    }
    return shown >= 0.5f * looked_at;
  }

  [[nodiscard]] bool is_blunt(std::uint32_t patch) const {
    float widest = 0, tip = width(patch, kTip[0], true);
    for (const float at : kBody) widest = std::max(widest, width(patch, at, true));
    for (const float at : kTip) tip = std::min(tip, width(patch, at, true));
    return tip > 0 && tip >= kBlunt * widest;
  }

 private:
  /// A few triangles of one patch, which follow each other in the file and so lie near each other.
  struct Block {
    std::uint32_t patch = 0;
    std::size_t first = 0, count = 0;
    Eigen::AlignedBox3f box;
  };

  void add_blocks(std::uint32_t patch) {
    const std::vector<std::size_t>& triangles = views_[patch].triangles;
    for (std::size_t first = 0; first < triangles.size(); first += kBlock) {
      Block block{patch, first, std::min(kBlock, triangles.size() - first), {}};
      for (std::size_t i = 0; i < 3 * block.count; ++i) {
        block.box.extend(mesh_.positions[mesh_.triangles[triangles[first + i / 3] + i % 3]]);
      }
      blocks_.push_back(block);
    }
  }

  [[nodiscard]] float level(std::uint32_t patch, float at) const {
    return ranges_[patch].min().x() + at * (ranges_[patch].max().x() - ranges_[patch].min().x());
  }

  [[nodiscard]] Corner corner(std::size_t i) const {
    const std::uint32_t v = mesh_.triangles[i];
    return {mesh_.positions[v], mesh_.uvs.empty() ? Vector2f(0, 0) : mesh_.uvs[v], strands_.place[v]};
  }

  /// Length of the line at one place along the strands, of its opaque part only if so wished, metres.
  [[nodiscard]] float width(std::uint32_t patch, float at, bool opaque_only) const {
    const float place = level(patch, at);
    const bool sample = opaque_only && !mesh_.uvs.empty();
    float sum = 0;
    for (const std::size_t t : views_[patch].triangles) {
      std::array<Corner, 3> ends;
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner a = corner(t + k), b = corner(t + (k + 1) % 3);
        if ((a.place < place) != (b.place < place)) ends[count++] = between(a, b, place);
      }
      if (count != 2) continue;
      const float length = (ends[1].position - ends[0].position).norm();
      sum += sample ? length * opaque_share(ends[0], ends[1], opaque_) : length;
    }
    return sum;
  }

  /// True where another patch lies over the edge, seen from outside, or takes up its strands: ends that are tied into a
  /// braid or a bun.
  [[nodiscard]] bool goes_under(std::uint32_t own, const RimEdge& edge, const FittedHead& head) const {
    const Vector3f away = (edge.middle - head.center.cast<float>()).stableNormalized();
    return meets_hair(own, edge.middle, away, std::numeric_limits<float>::infinity()) ||
           meets_hair(own, edge.middle, edge.along, kTiedWithin * float(head.radii.mean()));
  }

  [[nodiscard]] bool meets_hair(std::uint32_t own, const Vector3f& from, const Vector3f& direction, float reach) const {
    for (const Block& block : blocks_) {
      if (block.patch == own || !may_meet(block.box, from, direction)) continue;
      const auto triangles = std::span(views_[block.patch].triangles).subspan(block.first, block.count);
      if (std::ranges::any_of(triangles, [&](std::size_t t) { return meets(t, from, direction, reach); })) return true;
    }
    return false;
  }

  /// False where the ray passes by the ball around the box.
  static bool may_meet(const Eigen::AlignedBox3f& box, const Vector3f& from, const Vector3f& direction) {
    const Vector3f to_middle = box.center() - from;
    const float radius = 0.5f * box.diagonal().norm();
    const float along = std::max(0.0f, to_middle.dot(direction));
    return (to_middle - along * direction).squaredNorm() <= radius * radius;
  }

  /// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
  [[nodiscard]] bool meets(std::size_t t, const Vector3f& from, const Vector3f& direction, float reach) const {
    const Vector3f& a = mesh_.positions[mesh_.triangles[t]];
    const Vector3f ab = mesh_.positions[mesh_.triangles[t + 1]] - a, ac = mesh_.positions[mesh_.triangles[t + 2]] - a;
    const Vector3f p = direction.cross(ac), s = from - a, q = s.cross(ab);
    const float det = ab.dot(p);
    if (det == 0) return false;
    const float u = s.dot(p) / det, v = direction.dot(q) / det;
    const float distance = ac.dot(q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < reach;
  }

  const HairStrips& hair_;
  const HairMesh& mesh_;
  const StrandField& strands_;
  const AlphaTest& opaque_;
  std::vector<PatchView> views_;
  std::vector<Block> blocks_;
  std::vector<Eigen::AlignedBox1f> ranges_;  ///< Ranges of places along the strands.
};

}  // namespace

std::vector<std::uint32_t> find_blunt_ends(const HairStrips& hair, const FittedHead& head, const AlphaTest& opaque,
                                           const platform::Threads& threads, Findings& findings) {
  const TipEnds ends(hair, opaque);
  const std::vector<std::vector<RimEdge>> rims = ends.find_rims();
  const std::uint32_t count = hair.patches.count;
  std::vector<std::uint8_t> blunt(count, 0);
  parallel_for(count, threads, [&](std::size_t p) {
    const auto patch = std::uint32_t(p);
    blunt[p] = ends.is_blunt(patch) && ends.is_open(patch, rims[p], head);
  });
  std::vector<std::uint32_t> patches;
  for (std::uint32_t p = 0; p < count; ++p) {
    if (blunt[p] != 0) patches.push_back(p);
  }
  const float share = count > 0 ? float(patches.size()) / float(count) : 0;
  if (share >= kWarnShare) {
    findings.warn(
        "C151",
        fmt::format("{:.0f} % of the patches ({} of {}) end hard: opaque up to an edge about as wide as the strip; let "
                    "the alpha of the texture fade towards the tips, or model the strips to a point",
                    100 * share, patches.size(), count));
  }
  return patches;
}

}  // namespace coif::cook
