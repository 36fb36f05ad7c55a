#pragma once

#include "cook/recipe/findings.h"
#include "cook/rig/hair_cells.h"
#include "cook/rig/skeleton.h"
#include "cook/select/head.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// Hair that moves as one.
struct HairLock {
  std::vector<std::uint32_t> cells;  ///< Nearer to this lock's tips than to others', ascending.
  std::vector<std::uint32_t> ways;   ///< On the ways from its tips to the scalp, shared with other locks; ascending.
  double length = 0;                 ///< Largest depth, metres.
  bool moves = false;                ///< False: too short for a chain of its own.
  /// Turns around the head's upright axis (0 along +Z, 0.25 along +X) at which its chain hangs; none: wherever its hair
  /// is. A part of a shell has its middle: its hair is measured from other parts, too, which would draw the chain
  /// aside.
  std::optional<double> turn{};

  // Its chain in the skeleton, once it exists.
  std::uint32_t first_bone = 0;
  std::vector<double> joint_depth;  ///< Bones + 1, or empty: the lock follows the head.
};

/// Groups the hanging hair into at most recipe.chain_max_count locks that move, and short ones that do not. Each tip (a
/// local maximum of depth) has a strand, its way to the scalp. Strands form one lock where they run together: near each
/// other on average over their common length, and nearer where the hair between them has gaps. Then the nearest and
/// shortest are merged until the budget holds. `head_radius`, metres, sets the scale.
[[nodiscard]] std::vector<HairLock> group_locks(const HangingHair& hair, double head_radius, const RigRecipe& recipe,
                                                const std::stop_token& stop);

/// Divides locks that go around a good part of the head, as a shell of shoulder-length hair does, into parts of about
/// 60 degrees around its upright axis, and measures their hair anew, each part alone; not where that would be more than
/// recipe.chain_max_count locks that move.
[[nodiscard]] std::vector<HairLock> divide_wide_locks(HangingHair& hair, std::vector<HairLock> locks,
                                                      const FittedHead& head, const RigRecipe& recipe);

/// The bones of one lock as a line of joints: bone i goes from joint i to joint i + 1.
struct LockCurve {
  std::vector<Eigen::Vector3d> joints;  ///< Model space, metres, from the scalp to the tip; empty: too short.
  std::vector<double> depth;  ///< One per joint, ascending from 0: hair of this depth is level with the joint.
};

/// The point itself, or where the ray to it from the head's centre leaves the head, with a little room.
[[nodiscard]] Eigen::Vector3d kept_out_of_head(const FittedHead& head, const Eigen::Vector3d& point);

/// The middle of the lock from the scalp to its tip, or to where only a few wisps go on. It is divided into bones of
/// `recipe.chain_bone_length`, or into longer equal ones where that would be more than `most_bones`. Joints are outside
/// the head, so that its collider does not push the modelled pose.
[[nodiscard]] LockCurve fit_lock_curve(const HangingHair& hair, const HairLock& lock, const FittedHead& head,
                                       const RigRecipe& recipe, std::size_t most_bones);

/// Empties the curves (one per lock; empty: rigid) of hair that does not swing: what is dressed to stand up unless it
/// is slender, what is no longer than wide unless it hangs, and what would run around the head along a hem. Locks that
/// are mirror images in the head's middle get curves that are, and the same number of bones.
void settle_curves(const HangingHair& hair, std::span<const HairLock> locks, const FittedHead& head,
                   std::span<LockCurve> curves);

/// Weights that change smoothly in space, so that no two vertices at one place move apart: along a chain from bone to
/// bone, from the head to its first bone, and from lock to lock over `blend` metres of connected hair.
/// `rigid`: vertices that follow the head.
[[nodiscard]] SkinWeights blend_chain_weights(const HairStrips& strips, const HangingHair& hair,
                                              std::span<const HairLock> locks, const std::vector<bool>& rigid,
                                              double blend);

/// Makes bones for hair without bones: groups the hanging hair into locks, fits a chain to each from the scalp to its
/// tip, and blends skin weights along and between chains. `rigid` has the head bone, the file's map from nodes to it,
/// and no moving bones. Notes the fitted chains and their places.
[[nodiscard]] HairRig fit_chains(const importer::SourceModel& source, const HairStrips& hair, const FittedHead& head,
                                 const Skeleton& rigid, const RigRecipe& recipe, Findings& findings,
                                 const std::stop_token& stop = {});

/// Decides whether fitted chains are what a person would make, by what moves: chains that hang, one for each part of
/// the hair around the head, alike on both sides, and nothing that lies on the head.
void judge_chains(const HairStrips& hair, const FittedHead& head, const HairRig& rig, Findings& findings);

}  // namespace coif::cook
