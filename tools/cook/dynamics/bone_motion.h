#pragma once

// The formulas that make a bone's numbers from what is said of it: pure, for whoever has said it. runtime/docs/MODEL.md
// derives them.

#include "cook/recipe/hair_preset.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <coif/asset_records.h>
#include <coif/step_settings.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace coif::cook {

inline constexpr double kGravity = 9.81;  ///< m/s^2

/// What damping is measured by: the square root of the stiffness of a bone of `length` metres, 1/s. Gravity stiffens a
/// hanging bone as a pendulum, and so does the head's own acceleration, taken to be as large.
[[nodiscard]] double natural_rate(const DynamicsRecord& record, double length);

/// The damping that, with the friction, brings a bone of `length` metres to this share of critical damping; 0 where
/// friction alone does more.
[[nodiscard]] double damping_for(double ratio, double length, const DynamicsRecord& record);

/// Stiffness and damping of `record` from its resistance, authoring rate, friction and gravity, up to kMostStiffness
/// and kMostDamping. `ratio`: share of critical damping; none: what the resistance brings.
void bake_oscillator(std::optional<double> ratio, double length, DynamicsRecord& record);

/// 1/s^2: of the joint where bone `i` of the rig starts, of hair that its own weight just bends over at
/// `bending_length` metres.
[[nodiscard]] double natural_stiffness(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                                       double bending_length);

/// 1/s: how fast bone `i` swings with this stiffness and what hangs from it, in the passive model.
[[nodiscard]] double swing_rate(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                                double stiffness);

/// How hair moves that nobody gave numbers to.
struct NaturalMotion {
  double bending_length = 0;  ///< Metres.
  double damping_ratio = 0;   ///< Share of what keeps a joint from swinging past its rest.
  /// Only the bending is damped, not the swinging: a tied bundle has no neighbours along which it rubs as it swings.
  /// The ratio, 1.6 times as large, is then that of the joint's stiffness alone, as seen at the rate at which it
  /// swings: half of the bending's loss factor.
  bool is_tied = false;
};

/// Stiffness, damping and, for Algorithm 1, resistance of `record`, which is bone `i` of the rig.
void bake_natural(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                  const NaturalMotion& motion, DynamicsRecord& record);

/// 1/s: the preset's for loose locks. A tied bundle is thicker, and has as much less surface for its mass that air
/// pulls at, and no neighbours.
[[nodiscard]] double friction_of(const HairPreset& preset, bool is_tied);

/// Leans the pull of each bone of the rig for which `takes` is true against the weight that it carries, so that it
/// rests as modelled under an upright head. A bone too soft for that is made as stiff as it takes, its damping with it.
/// `bones`, `records` and `takes` begin at the asset's first simulated bone; the rig has the records' gravity and
/// parent shares. Returns how many were too soft.
std::size_t lean_against_weight(const lab::Rig& rig, std::span<const BoneRecord> bones, const std::vector<bool>& takes,
                                std::span<DynamicsRecord> records);

}  // namespace coif::cook
