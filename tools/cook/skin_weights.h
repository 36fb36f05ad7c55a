#pragma once

#include "cook/hair_mesh.h"
#include "cook/skeleton.h"

namespace coif {

struct BoneWeight {
  std::uint32_t bone = 0;
  double weight = 0;  ///< > 0.
};

/// What carries each vertex: bones of the asset, however many. A vertex without any follows the head.
using SkinWeights = std::vector<std::vector<BoneWeight>>;

/// The artist's weights, summed over the nodes that became one bone.
[[nodiscard]] SkinWeights weights_of_source(const HairMesh& mesh, const Skeleton& skeleton);

/// One record per vertex: the four bones with most weight, in bytes that add up to exactly 255 (largest remainder).
/// Vertices without influences follow the head.
[[nodiscard]] std::vector<SkinRecord> quantize_skin(const SkinWeights& weights);

}  // namespace coif
