#pragma once
// Skinning on the processor, for engines that draw hair with a renderer of their own and want finished vertices.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

/// What moves of a vertex. The rest stays as it is in Asset::vertices(): UV, place along the strand, share of ambient
/// light.
struct SkinnedVertex {
  Vec3 position;  ///< Head space, metres.
  Vec3 normal;    ///< Head space. As long as the bones' blend makes it: normalise it where it is lit, per pixel.
  Vec3 tangent;   ///< As the normal; root to tip.
};

/// Skins Asset::vertices()[first .. first + out.size()) with `palette`, from Hair::palette(): what shaders/hair.vert
/// does before it puts the head in its place, but for the last bit, which drivers round as they like. Hair without SKIN
/// keeps its rest pose. Draw the result under the head's world transform, HeadPose::scale included; under a uniform
/// scale normals and tangents keep their directions.
///
/// Allocates nothing and keeps nothing: parts of one asset may be skinned on several threads at the same time, with the
/// same bits as at once. The palette's numbers are believed. Cost: per vertex, tests/bench (`skin_...`).
///
/// kAssetLacksData without vertices; kBadIndex where the range is not inside of them; kSizeMismatch when the palette
/// has not one matrix per bone (hair without SKIN may also have none). `out` is then as it was.
COIF_API Status skin_vertices(const Asset& asset, std::span<const Mat34> palette, std::uint32_t first,
                              std::span<SkinnedVertex> out);

}  // namespace coif
