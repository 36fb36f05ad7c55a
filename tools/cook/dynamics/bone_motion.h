#pragma once

// Pure formulas for a bone's numbers, whatever the source of their inputs. runtime/docs/MODEL.md derives them.

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

/// The unit of damping: the square root of the stiffness of a bone of `length` metres, 1/s. Gravity stiffens a hanging
/// bone like a pendulum, and so does the head's own acceleration, which is assumed to be as large.
[[nodiscard]] double natural_rate(const DynamicsRecord& record, double length);

/// The damping that, with the friction, brings a bone of `length` metres to this share of critical damping; 0 where
/// friction alone does more.
[[nodiscard]] double damping_for(double ratio, double length, const DynamicsRecord& record);

/// Sets stiffness and damping of `record` from its resistance, authoring rate, friction and gravity, up to
/// kMostStiffness and kMostDamping. `ratio`: share of critical damping; none: the damping that follows from the
/// resistance.
void bake_oscillator(std::optional<double> ratio, double length, DynamicsRecord& record);

/// Stiffness of the joint where bone `i` of the rig starts, 1/s^2, for hair that its own weight just bends over at
/// `bending_length` metres.
[[nodiscard]] double natural_stiffness(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                                       double bending_length);

/// Rate at which bone `i` swings with this stiffness and everything that hangs from it, 1/s, in the passive model.
[[nodiscard]] double swing_rate(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                                double stiffness);

/// The motion of hair for which nobody gave numbers.
struct NaturalMotion {
  double bending_length = 0;  ///< Metres.
  double damping_ratio = 0;   ///< Share of the damping that keeps a joint from swinging past its rest.
  /// Only the bending is damped, not the swinging: a tied bundle has no neighbours along which it rubs. The ratio, 1.6
  /// times as large, then refers to the joint's stiffness alone, at the rate at which it swings: half of the bending's
  /// loss factor.
  bool is_tied = false;
};

/// Stiffness, damping and, for Algorithm 1, resistance of `record`, which is bone `i` of the rig.
void bake_natural(const lab::Rig& rig, std::span<const lab::Carried> carried, std::size_t i,
                  const NaturalMotion& motion, DynamicsRecord& record);

/// 1/s: the preset's for loose locks. A tied bundle is thicker, and has as much less surface for its mass that air
/// pulls at, and no neighbours.
[[nodiscard]] double friction_of(const HairPreset& preset, bool is_tied);

/// Leans the pull of each bone of the rig for which `takes` is true against the weight that it carries, so that it
/// rests as modelled under an upright head. A bone that is too soft is made stiff enough, with its damping. `bones`,
/// `records` and `takes` begin at the asset's first simulated bone; the rig has the records' gravity and parent shares.
/// Returns how many were too soft.
std::size_t lean_against_weight(const lab::Rig& rig, std::span<const BoneRecord> bones, const std::vector<bool>& takes,
                                std::span<DynamicsRecord> records);

}  // namespace coif::cook
