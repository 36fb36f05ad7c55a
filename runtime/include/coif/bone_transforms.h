#pragma once
// Bones relative to their parents, for engines with skeletons of their own that want a translation and a rotation for
// each node instead of matrices. Computed from the palette that is drawn with.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// From a bone's own frame to its parent's: p' = translation + rotation p.
struct BoneTransform {
  Vec3 translation;  ///< Metres, before HeadPose::scale, which belongs to the node that the head hangs from.
  Quat rotation;     ///< Unit, w >= 0.
};

/// One transform for each of the asset's bones, in their order, parents first. Bone 0 is relative to the head's pose: a
/// node with HeadPose, its scale included, is the parent of all.
///
/// In the rest pose every bone's frame has the axes of head space and stands at BoneRecord::joint. So a skeleton's bind
/// pose has no rotations, its translations are those between joints (the result for a palette of identities), and its
/// inverse bind matrices are translations by -joint. With these the engine's own skinning reproduces the palette.
/// Translations of simulated bones keep their lengths.
///
/// `palette` comes from Hair::palette(); its numbers are not checked. Composed along parents, the transforms give the
/// palette again to 1e-6 where its matrices are rotations; for bones that fold over, to about 1e-5. Allocates nothing.
/// kAssetLacksData where the asset is not open; kSizeMismatch unless `palette` and `transforms` have one element for
/// each bone. After an error `transforms` is as it was.
COIF_API Status bone_transforms(const Asset& asset, std::span<const Mat34> palette,
                                std::span<BoneTransform> transforms);

}  // namespace coif
