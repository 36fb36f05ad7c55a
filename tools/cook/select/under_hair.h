#pragma once

#include "cook/select/select_hair.h"

#include <Eigen/Geometry>

#include <vector>

namespace coif::cook {

/// Triangles out of several meshes, three vertices each.
struct TriangleSoup {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> triangles;
  Eigen::AlignedBox3f box;

  void add(const importer::SourceMesh& mesh, std::size_t triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      triangles.push_back(std::uint32_t(positions.size()));
      positions.push_back(mesh.positions[mesh.triangles[3 * triangle + k]]);
      box.extend(positions.back());
    }
  }
};

/// The triangles of a choice.
[[nodiscard]] inline TriangleSoup chosen_hair(const importer::SourceModel& source, const HairChoice& choice) {
  TriangleSoup hair;
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    for (std::size_t t = 0; t < source.meshes[m].triangles.size() / 3; ++t) {
      if (choice.takes(m, t)) hair.add(source.meshes[m], t);
    }
  }
  return hair;
}

/// Triangles that the chosen hair is wrapped around: the core of a ponytail, braid or bun, which artists model as part
/// of the head's mesh with a texture of its own. Moving strips would tear off it. Such a core is one of the texture's
/// islands, or several that touch. Hair lies close around nearly all of it; it is slimmer than the head; and its end is
/// far from everything else, whereas ears, lids and lips lie close to the face and a scalp is as wide as the head. A
/// mesh with nothing else is worn in the hair. Per mesh and triangle, as in HairChoice; empty for meshes without a
/// core, and for those that gave hair.
[[nodiscard]] HairChoice find_hair_cores(const importer::SourceModel& source, const HairChoice& choice,
                                         std::uint32_t head_node);

/// Meshes that lie close under the chosen hair, within a tenth of its width, on a good part of the head, and nowhere
/// else: the caps that artists paint between strips so that no skin shows. Other meshes differ: a head comes out of its
/// hair at the face, lashes and teeth are small, a body reaches beyond it. Per mesh of the source; false for those that
/// gave hair.
[[nodiscard]] std::vector<bool> find_scalp_caps(const importer::SourceModel& source, const HairChoice& choice);

}  // namespace coif::cook
