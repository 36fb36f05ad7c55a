#pragma once

#include "base/encodings.h"
#include "cook/texture/image.h"

namespace coif::cook {

/// Where green of a normal map leads as it grows: up the image, as glTF and OpenGL have it, or down, as DirectX has.
enum class GreenAxis { kUp, kDown };

/// What is known of a map before its texels are looked at.
struct NormalMapUse {
  std::optional<GreenAxis> green;  ///< None: found from the map.
  double strength = 1;             ///< Multiplies slopes; 0 or more.
};

struct NormalMap {
  Image normals;      ///< Two channels: TextureRole::kNormal.
  std::string found;  ///< What kind of map it was taken for, for messages: "a normal map, green up (...)".
};

/// Reads an RGBA image as a map of normals in the texture's own axes, or as one of heights, which is grey all over.
/// Heights have no unit: their slopes are scaled to a common steepness.
///
/// Which way green leads shows in the map itself where nobody says it. Normals are those of a surface of heights, so
/// that the change of one slope along the other axis and of the other along the first are the same; with green turned
/// round they are opposite.
///
/// Error: a sentence that ends in what the image is instead (normals in the model's axes, or no unit vectors at all).
tl::expected<NormalMap, std::string> read_normal_map(const Image& map, const NormalMapUse& use);

/// How strands run where a map of normals (two channels) shows their ridges: TextureRole::kStrandAxis, with about a
/// hundred texels along the longer side. Across a strand normals change, along it they do not: the axis of least spread
/// of the normals in a block, of which the mean, the form of whole locks, is taken off. Sure is what spreads one way
/// only (the coherence of the structure tensor, Foerstner and Guelch 1987).
[[nodiscard]] Image strand_axes(const Image& normals);

}  // namespace coif::cook
