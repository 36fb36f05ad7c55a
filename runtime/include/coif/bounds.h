#pragma once
// Where the hair of one head is in the pose that it has now, for renderers that cull, choose levels of detail or
// fit shadow maps by themselves. Boxes of the vertices that hang on each bone are found once per asset; from then
// on a head's box follows from its matrices alone. coif/drawing.h has the ball that hair never leaves whatever its
// pose, which is wider.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// Around all that hangs on one bone, in the rest pose, head space, metres.
struct BoneBox {
  Vec3 center;
  Vec3 half{-1, -1, -1};  ///< Half of each side, >= 0; below 0: nothing hangs on the bone.
};

/// Fills one box for each of the asset's bones, over the vertices of all levels of detail. Hair without SKIN hangs
/// on bone 0, which stays as it is. Linear in the vertices; once per asset. kAssetLacksData without a mesh;
/// kSizeMismatch unless there is room for exactly one box a bone.
COIF_API Status find_bone_boxes(const Asset& asset, std::span<BoneBox> boxes);

/// Head space, metres, axes along those of the head.
struct HairBounds {
  Vec3 lowest;
  Vec3 highest;
};

/// The box around a head's hair in the pose of `palette`, from Hair::palette(): every vertex as skin_vertices()
/// and the shaders place it is inside, since it is a mean of what its bones make of it. At rest it is the mesh's
/// own box; bent hair fills less of it. Allocates nothing. Some fifty multiplications and additions for each bone
/// that something hangs on (tests/bench, `bound_hair`: 9 ns). The palette's numbers are believed. kSizeMismatch
/// unless `palette` has one matrix for each of `boxes`; kAssetLacksData where nothing hangs on any bone. `bounds`
/// is then as it was.
COIF_API Status bound_hair(std::span<const BoneBox> boxes, std::span<const Mat34> palette, HairBounds& bounds);

/// World axes, metres.
struct WorldBounds {
  double center[3] = {};
  Vec3 half;  ///< Half the box's sides.
  float radius =
      0;  ///< The radius of the ball around `center` that holds the head's own box: turning does not widen it.
};

/// The same under the head's pose, whose numbers are believed.
[[nodiscard]] COIF_API WorldBounds bounds_in_world(const HairBounds& bounds, const HeadPose& head);

}  // namespace coif
