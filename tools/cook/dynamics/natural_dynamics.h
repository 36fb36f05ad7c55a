#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "write/asset_writer.h"

#include <span>
#include <vector>

namespace coif {

[[nodiscard]] inline bool is_passive(const AssetContents& contents) {
  return (contents.skeleton.flags & kSkeletonPassive) != 0;
}

/// Chooses the model that moves the hair, as "dynamics.model" says or for what has a preset the passive one, and gives bones that
/// nobody gave numbers to those of the preset; all but those that a spring moves keep the shape that was modelled, unless
/// "dynamics.sags". `sources` and `damping_ratios`: one for each bone of `contents`, which holds skeleton and dynamics.
void settle_model(const Recipe& recipe, const std::vector<MotionSource>& sources,
                  std::span<const double> damping_ratios, AssetContents& contents, Findings& findings);

/// What "dynamics.preset" means.
struct HairPreset {
  const char* name;
  double bending_length;  ///< Metres.
  double damping_ratio;
  double friction;  ///< 1/s, against the air.
};

[[nodiscard]] const HairPreset& preset_of(const Recipe& recipe);

/// Stiffness and damping of hair that nobody gave numbers to, from what hair is, for the passive model: of those bones of
/// `contents` (skeleton and dynamics) for which `takes` is true.
///
/// Free hairs of a lock bend like one: the stiffness of hair against its weight is a length, that of hair which its own weight just
/// bends over, (E I / (rho g))^(1/3), whatever the lock's thickness; 5 cm for human hair (Goldstein, Warren and Ball 2012, "Shape
/// of a Ponytail and the Statistical Physics of Hair Fiber Bundles"), more where locks hold together. So a joint between bones
/// of the mean length l has the stiffness rho g b^3 / l against bending; hair shorter than b stands and longer hair hangs, and
/// swings as a pendulum. Each joint is damped at its share, one of `damping_ratios`, of what would keep it from swinging past.
void bake_natural_dynamics(const HairPreset& preset, std::span<const double> damping_ratios,
                           const std::vector<bool>& takes, AssetContents& contents, Findings& findings);

/// Leans each bone's pull, of those for which `takes` is true, against the weight that it carries, so that under an upright head
/// hair rests exactly as modelled. Closed form, in the model that contents.skeleton.flags says. A bone too soft to carry that
/// is made as stiff as it takes; a note says how many.
void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings);

}  // namespace coif
