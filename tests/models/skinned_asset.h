#pragma once

#include "write/asset_writer.h"

#include <coif/asset.h>
#include <coif/skinning.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// `bones` rigid bones and one vertex for each of `skin`, none two in one place.
[[nodiscard]] AssetContents skinned_contents(std::uint32_t bones, std::span<const SkinRecord> skin);

/// Matrices that turn, move and shear, no two alike.
[[nodiscard]] std::vector<Mat34> bent_palette(std::uint32_t bones);

/// One vertex with three 4-vectors times a blended matrix, all in double precision.
struct ExactVertex {
  double position[3];
  double normal[3];
  double tangent[3];
};
[[nodiscard]] ExactVertex exactly_skinned(const Asset& asset, std::span<const Mat34> palette, std::uint32_t vertex);

/// Largest difference of any component: metres for positions.
[[nodiscard]] double difference(const SkinnedVertex& a, const ExactVertex& b);

struct WigSettings {
  std::uint32_t strips = 60;  ///< Evenly around the crown, in three layers.
  std::uint32_t bones_per_chain = 4;
  std::uint32_t texture_size = 256;  ///< Texels each way, a power of two.
};

/// A made-up bob: curved strips over an ellipsoid head, one chain of bones per strip, a procedural strand texture with
/// soft tips. The bytes of a .coif.
[[nodiscard]] std::vector<std::byte> made_up_wig(const WigSettings& settings = {});

}  // namespace coif
