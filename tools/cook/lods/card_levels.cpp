#include "cook/lods/make_lods.h"

#include "base/nearest_points.h"
#include "base/parallel_for.h"
#include "cook/select/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace coif::cook {
namespace {

constexpr std::size_t kNear = 8;            // vertices that one takes its weights from
constexpr double kLeastWeight = 1.0 / 510;  // Smaller weights of a bone are not stored.
constexpr double kReach = 0.5;              // Share of the head's half height: larger distances count as this.

/// The finest level, as coarser ones follow it.
class FinestCards {
 public:
  FinestCards(const HairStrips& hair, const HairRig& rig)
      : positions_(hair.mesh.positions), weights_(rig.weights), nearest_(positions_), patch_of_(positions_.size(), 0) {
    for (std::size_t i = 0; i < hair.mesh.triangles.size(); ++i) {
      patch_of_[hair.mesh.triangles[i]] = hair.patches.patch_of[i / 3];
    }
  }

  struct Followed {
    std::vector<BoneWeight> weights;
    std::uint32_t patch = 0;  ///< The nearest vertex's patch.
  };

  [[nodiscard]] Followed at(const Eigen::Vector3f& place) const {
    std::vector<NearestPoints::Found> found;
    nearest_.find(place, kNear, found);
    Followed followed{{}, patch_of_[found.front().point]};
    double sum = 0;
    for (const NearestPoints::Found& one : found) {
      const double share = 1 / (double(one.squared) + double(found.front().squared) + 1.0e-12);
      sum += share;
      for (const BoneWeight& of : weights_[one.point]) add_weight(followed.weights, of.bone, share * of.weight);
    }
    for (BoneWeight& weight : followed.weights) weight.weight /= sum;
    std::erase_if(followed.weights, [](const BoneWeight& weight) { return weight.weight < kLeastWeight; });
    return followed;
  }

 private:
  std::vector<Eigen::Vector3f> positions_;
  SkinWeights weights_;
  NearestPoints nearest_;
  std::vector<std::uint32_t> patch_of_;  ///< Per vertex.
};

/// For each strip, the finest level's patch at which most of its vertices lie.
std::vector<std::uint32_t> patches_met(const importer::SourceLevel& level,
                                       std::span<const FinestCards::Followed> followed) {
  std::vector<std::uint32_t> met;
  for (std::size_t t = 0; t < level.strip_of.size();) {
    std::vector<std::uint32_t> patches;
    for (const std::uint32_t strip = level.strip_of[t]; t < level.strip_of.size() && level.strip_of[t] == strip; ++t) {
      for (std::size_t k = 0; k < 3; ++k) patches.push_back(followed[level.mesh.triangles[3 * t + k]].patch);
    }
    std::ranges::sort(patches);
    std::uint32_t best = patches.front();
    std::ptrdiff_t most = 0;
    for (auto at = patches.begin(); at != patches.end();) {
      const auto end = std::upper_bound(at, patches.end(), *at);
      if (end - at > most) {
        most = end - at;
        best = *at;
      }
      at = end;
    }
    met.push_back(best);
  }
  return met;
}

void append_vertices(const importer::SourceLevel& level, HairStrips& hair) {
  HairMesh& mesh = hair.mesh;
  for (std::size_t v = 0; v < level.mesh.positions.size(); ++v) {
    hair.welded.push_back(std::uint32_t(mesh.positions.size()));
    mesh.positions.push_back(level.mesh.positions[v]);
    mesh.normals.push_back(level.mesh.normals[v]);
    mesh.uvs.push_back(level.mesh.uvs[v]);
    mesh.influence_begin.push_back(mesh.influence_begin.back());
    hair.strands.tangent.push_back(level.along[v]);
    hair.strands.place.push_back(level.place[v]);
  }
}

/// A patch for each strip.
void append_patches(const importer::SourceLevel& level, std::uint32_t first_vertex, std::span<const std::uint32_t> met,
                    HairStrips& hair) {
  const std::uint32_t mesh = hair.mesh.source_meshes.front(), first_patch = hair.patches.count;
  for (const std::uint32_t patch : met) {
    hair.patches.add_part_of(patch);
    hair.patches.stands_for.push_back(patch);
  }
  for (std::size_t t = 0; t < level.strip_of.size(); ++t) {
    hair.patches.patch_of.push_back(first_patch + level.strip_of[t]);
    hair.mesh.mesh_of_triangle.push_back(mesh);
    for (std::size_t k = 0; k < 3; ++k) {
      hair.mesh.triangles.push_back(first_vertex + level.mesh.triangles[3 * t + k]);
    }
  }
}

DetailLevel append_level(const importer::SourceLevel& level, const FinestCards& finest,
                         const platform::Threads& threads, HairStrips& hair, HairRig& rig) {
  const auto first_vertex = std::uint32_t(hair.mesh.positions.size());
  const std::size_t first_triangle = hair.mesh.triangle_count();
  std::vector<FinestCards::Followed> followed(level.mesh.positions.size());
  parallel_for(followed.size(), threads, [&](std::size_t v) { followed[v] = finest.at(level.mesh.positions[v]); });
  append_vertices(level, hair);
  append_patches(level, first_vertex, patches_met(level, followed), hair);
  for (FinestCards::Followed& vertex : followed) rig.weights.push_back(std::move(vertex.weights));
  return level_from(hair, first_triangle);
}

struct Distances {
  double largest = 0, squares = 0;
  std::size_t count = 0;
};

/// Adds the distances of one level's vertices from another's cards.
void add_distances(const HairMesh& mesh, const DetailLevel& of, const DetailLevel& from, double reach,
                   const platform::Threads& threads, Distances& distances) {
  const std::vector<std::uint32_t> triangles = indices_of(from);
  const TriangleGrid grid(mesh.positions, triangles, reach);
  const std::vector<std::uint32_t> vertices = vertices_of(of);
  std::vector<double> far(vertices.size());
  parallel_for(far.size(), threads, [&](std::size_t i) { far[i] = grid.distance(mesh.positions[vertices[i]], 0); });
  for (const double d : far) {
    distances.largest = std::max(distances.largest, d);
    distances.squares += d * d;
  }
  distances.count += far.size();
}

}  // namespace

bool has_card_levels(const importer::SourceModel& source, const HairStrips& hair) {
  if (source.coarser.empty() || hair.is_part || hair.mesh.source_meshes.size() != 1) return false;
  const importer::SourceMesh& cards = source.meshes[hair.mesh.source_meshes.front()];
  return cards.node == source.coarser.front().mesh.node && cards.material == source.coarser.front().mesh.material;
}

std::vector<DetailLevel> card_levels(const importer::SourceModel& source, HairStrips& hair, HairRig& rig,
                                     const FittedHead& head, const LodSettings& settings, Findings& findings) {
  std::vector<DetailLevel> levels{finest_level(hair, rig.skeleton)};
  const FinestCards finest(hair, rig);
  const double reach = kReach * head.radii.y();
  for (std::size_t k = 1; k < settings.levels && k <= source.coarser.size(); ++k) {
    DetailLevel level = append_level(source.coarser[k - 1], finest, settings.threads, hair, rig);
    Distances distances;
    add_distances(hair.mesh, level, levels.front(), reach, settings.threads, distances);
    add_distances(hair.mesh, levels.front(), level, reach, settings.threads, distances);
    level.error = std::max(float(distances.largest), levels.back().error);
    level.shown_error =
        std::max(float(std::sqrt(distances.squares / double(distances.count))), levels.back().shown_error);
    levels.push_back(std::move(level));
  }
  for (DetailLevel& level : levels) level.triangles_of.resize(hair.patches.count);
  place_on_screen(2 * head.radii.y(), rig.skeleton, settings, levels);
  describe_levels(levels, findings);
  return levels;
}

}  // namespace coif::cook
