#pragma once
// VRM's spring bones as this project's dynamics.
//
// Source: VRMC_springBone-1.0, "SpringBone Algorithm"; VRM 0.x computes the same. With h the time of a frame, x a
// joint's tail, x' the tail one frame ago, u the unit rest direction (turned with the parent), l the length, every
// frame is
//
//     next = x + (x - x') (1 - drag) + h stiffness u + h gravityPower g,   then |next - joint| = l,
//
// from root to tip. Neither h nor (1 - drag) is corrected for the frame rate, so a spring bone has one look per rate;
// the one that artists tune at, and that this mapping reproduces, is 60 frames per second.
//
// Seen from the joint the tail is l times a unit vector, and only the sum's direction matters. Divide it by
// 1 + k with k = h stiffness / l and r = k / (1 + k):
//
//     (1 - r) (x + (x - x') (1 - drag) + h gravityPower g) + r l u.
//
// That is lines 1 to 8 of the thesis's Algorithm 1: velocity braked, gravity added, then a pull of weight r towards the
// default position. Comparing term by term gives, exactly and not only for small angles,
//
//     resistance = k / (1 + k) at an authoring rate of 1/h,     friction = -ln(1 - drag) / h,
//
// and for the gravity a, as an acceleration, h^2 a = h gravityPower, or a = gravityPower / h. The published algorithm
// brakes gravity's share within the same step, so there the hair sags 1 - drag times as far; the oscillator that
// resistance stands for (a spring of r / ((1 - r) h^2) per unit of mass) has no such factor and sags as VRM's does,
// which is why there is none here.
//
// k is a rate of turning and belongs to VRM's length l. Where the cooked bone has another length L (the 7 cm behind a
// leaf of VRM 0.x become the length of the hair there), the same turning takes the same resistance, and gravity a L /
// l.
//
// What has no counterpart: gravity in other directions than the scene's (its vertical part is kept), and `center`. VRM
// simulates a spring with a center in that node's space: it does not feel the node's motion, so with the head as its
// center a hair only feels where down is. Here hair is simulated in the world and feels every motion of the head.
// Both are reported.

#include "base/tool_error.h"
#include "cook/dynamics/bone_motion.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/hair_preset.h"
#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <span>
#include <string>
#include <vector>

namespace coif::cook {

struct RigRecipe;

inline constexpr double kSpringRate = 60;  ///< Frames per second at which spring bones have their look.

/// Settings of one joint for a bone of `length` metres; hit_radius is left at 0.
[[nodiscard]] DynamicsRecord dynamics_of_joint(const importer::SourceSpringJoint& joint, double length);

/// Rate at which a twist decays where the recipe gives none, 1/s: it is gone within a swing of the hair, and not so
/// fast that one sees it.
inline constexpr double kUsualTorsion = 20;

/// The source of a bone's motion.
enum class MotionSource { kRigid, kSpring, kCurve, kPreset };

/// The requested motion: one entry per bone of a skeleton; empty where nothing is simulated.
struct SaidMotion {
  std::vector<DynamicsRecord> records;  ///< Hit radii 0; bones that a preset moves have no stiffness yet.
  std::vector<MotionSource> sources;
  /// The preset that the bone has, or would have if a preset moved it; never null.
  std::vector<const HairPreset*> presets;
  /// For bones that a preset moves: damping as a share of the damping that keeps them from swinging past their rest.
  std::vector<double> damping_ratios;
  /// NaturalMotion::is_tied of bones that a preset moves; empty: none is.
  std::vector<bool> tied{};

  [[nodiscard]] bool is_tied(std::size_t bone) const { return bone < tied.size() && tied[bone]; }
};

/// The asset's SkeletonRecord::air_lag: the recipe's value, else the usual one for the source of most of the hair's
/// numbers. VRM damps velocities in the world; Algorithm 1's friction acts against air that follows the head; human
/// hair has its head's air around it, but not all of it.
[[nodiscard]] float air_lag(const RigRecipe& recipe, const SaidMotion& said);

/// How each bone moves: by the file's spring bones or by the recipe's curves, as "dynamics.source" says. A bone takes
/// the values of a curve at its middle, so that a chain of one bone has the mean and not the tip's value. `of_chain`,
/// empty or one for each chain, has the recipe's values for that chain; they take precedence over the file's springs.
/// Notes how many bones have springs; warns of settings of springs that are lost.
[[nodiscard]] SaidMotion bake_dynamics(const importer::SourceModel& source, const Skeleton& skeleton,
                                       const RigRecipe& recipe, std::span<const PatchOverride> of_chain,
                                       Findings& findings);

/// Whether the hair of each chain is tied: a pony tail, a pigtail or a braid, which hangs free as one round bundle.
/// Loose hair hangs in sheets, or beside other locks.
///
/// A chain is tied where it is at least 15 cm long, its hair is no wider than 0.6 of that and at least 0.45 times as
/// thick as wide (both: two standard deviations across the bones, by area), and no other chain of at least half its
/// length hangs nearer beside its lower half than a quarter of both their widths from surface to surface.
[[nodiscard]] std::vector<bool> find_tied_chains(const HairStrips& hair, const HairRig& rig);

/// Lets the bones of tied chains that a preset moves swing as tied hair does, unless the recipe or `of_chain` (empty,
/// or one for each chain) gives a friction or a damping. Notes which chains are tied.
void loosen_tied_chains(const Skeleton& skeleton, const std::vector<bool>& tied, const RigRecipe& recipe,
                        std::span<const PatchOverride> of_chain, SaidMotion& motion, Findings& findings);

/// The allowed directions of each bone, one record per bone of the skeleton: the recipe's, else those of the file's
/// springs (VRMC_springBone_limit; not where "dynamics.source" is "curves"). Empty where no bone has a limit. The
/// recipe's limits are around the direction in which a bone was modelled, and their axes are perpendicular to it. Error
/// (kBadInput): the recipe names bones that do not exist, or do not move.
[[nodiscard]] tl::expected<std::vector<LimitRecord>, ToolError> bake_limits(const importer::SourceModel& source,
                                                                            const Skeleton& skeleton,
                                                                            const RigRecipe& recipe,
                                                                            Findings& findings);

}  // namespace coif::cook
