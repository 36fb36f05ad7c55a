#pragma once
// Where the hair of one head is in its present pose, for renderers that cull, choose levels of detail or fit shadow
// maps by themselves. The boxes of the vertices on each bone are found once per asset; then a head's box follows from
// its matrices alone. coif/drawing.h has a wider bound, the ball that hair never leaves in any pose.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// Box around everything that hangs on one bone, in the rest pose, head space, metres.
struct BoneBox {
  Vec3 center;
  Vec3 half{-1, -1, -1};  ///< Half of each side, >= 0; below 0: nothing hangs on the bone.
};

/// Fills one box for each of the asset's bones, over the vertices of all levels of detail. Hair without SKIN hangs on
/// bone 0, which never moves against the head. Linear in the vertices; call it once per asset. kAssetLacksData without
/// a mesh; kSizeMismatch unless `boxes` has exactly one box per bone.
COIF_API Status find_bone_boxes(const Asset& asset, std::span<BoneBox> boxes);

/// Head space, metres, axes along those of the head.
struct HairBounds {
  Vec3 lowest;
  Vec3 highest;
};

/// The box around a head's hair in the pose of `palette`, from Hair::palette(). It holds every vertex as
/// skin_vertices() and the shaders place it: a vertex is a mean of the places that its bones give it, and the box holds
/// those. At rest it is the mesh's own box; bent hair fills less of it. Allocates nothing. Takes some fifty
/// multiplications and additions for each bone with vertices (tests/bench, `bound_hair`: 9 ns). Does not check the
/// palette's numbers. kSizeMismatch unless `palette` has one matrix for each of `boxes`; kAssetLacksData if no bone has
/// vertices. After an error `bounds` is as it was.
COIF_API Status bound_hair(std::span<const BoneBox> boxes, std::span<const Mat34> palette, HairBounds& bounds);

/// World axes, metres.
struct WorldBounds {
  double center[3] = {};
  Vec3 half;  ///< Half the box's sides.
  /// Radius of the ball around `center` that holds the head's own box. Turning the head does not change it.
  float radius = 0;
};

/// The same box in the world, under the head's pose, whose numbers are not checked.
[[nodiscard]] COIF_API WorldBounds bounds_in_world(const HairBounds& bounds, const HeadPose& head);

}  // namespace coif
