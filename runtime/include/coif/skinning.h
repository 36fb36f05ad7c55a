#pragma once
// Skinning on the processor, for engines that draw hair with a renderer of their own and need finished vertices.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

/// The parts of a vertex that move. Asset::vertices() has the rest: UV, place along the strand, share of ambient light.
struct SkinnedVertex {
  Vec3 position;  ///< Head space, metres.
  Vec3 normal;    ///< Head space. Not normalised after the bones' blend: normalise it per pixel, where it is lit.
  Vec3 tangent;   ///< As the normal; root to tip.
};

/// Skins Asset::vertices()[first .. first + out.size()) with `palette`, from Hair::palette(), as shaders/hair.vert does
/// before it places the head (except for the last bit, where drivers round differently). Hair without SKIN keeps its
/// rest pose. Draw the result under the head's world transform, HeadPose::scale included; a uniform scale keeps the
/// directions of normals and tangents.
///
/// Allocates nothing and keeps nothing. Parts of one asset may be skinned on several threads at the same time, with the
/// same bits as in one call. The palette's numbers are not checked. Cost per vertex: tests/bench (`skin_...`).
///
/// kAssetLacksData without vertices; kBadIndex where the range leaves the vertices; kSizeMismatch unless the palette
/// has one matrix per bone (hair without SKIN may also have none). After an error `out` is as it was.
COIF_API Status skin_vertices(const Asset& asset, std::span<const Mat34> palette, std::uint32_t first,
                              std::span<SkinnedVertex> out);

}  // namespace coif
