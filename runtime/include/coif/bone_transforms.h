#pragma once
// Bones relative to their parents, for engines with skeletons of their own, which want a translation and a
// rotation for each node instead of matrices. From the same palette that is drawn with.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// From a bone's own frame to its parent's: p' = translation + rotation p.
struct BoneTransform {
  Vec3 translation;  ///< Metres, before HeadPose::scale: that belongs to the node that the head hangs from.
  Quat rotation;     ///< Unit, w >= 0.
};

/// One transform for each of the asset's bones, in their order, in which parents come first. Bone 0 is relative to
/// the head's pose: a node with HeadPose, its scale included, is the parent of all.
///
/// In the rest pose every bone's frame has the axes of head space and stands at BoneRecord::joint. So a skeleton's
/// bind pose has no rotations, its translations are those between joints (what a palette of identities gives
/// here), and its inverse bind matrices are translations by -joint: with them the engine's own skinning makes the
/// palette again. Translations of simulated bones keep their lengths.
///
/// `palette` from Hair::palette(), whose numbers are believed: rotations and places. Composed along parents the
/// transforms are the palette again to 1e-6, as far as its matrices are rotations: those of bones that fold over
/// are to some 1e-5. Allocates nothing. kAssetLacksData where the asset is not open; kSizeMismatch unless palette
/// and `transforms` have one element for each bone. `transforms` is then as it was.
COIF_API Status bone_transforms(const Asset& asset, std::span<const Mat34> palette,
                                std::span<BoneTransform> transforms);

}  // namespace coif
