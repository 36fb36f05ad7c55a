#pragma once

#include "cook/recipe.h"
#include "cook/skeleton.h"
#include "import/source_model.h"

#include <span>

namespace coif {

struct BakedDynamics {
  std::vector<DynamicsRecord> records;  ///< One per bone; none where nothing is simulated. Hit radii are 0.
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// Baked stiffness (1/s^2) and damping or friction (1/s) end here: such a bone sags by 3 micrometres under its own weight
/// and looks rigid at every frame rate, and the reference has to resolve it: with more, tuning would take minutes.
inline constexpr double kMostStiffness = 4.0e6, kMostDamping = 1.0e4;

/// Rate at which a twist goes back where the recipe leaves it open, 1/s: a twist is gone within a swing of the hair, and not
/// so fast that it shows.
inline constexpr double kUsualTorsion = 20;

/// Piecewise linear through the points, constant outside them. `curve` is not empty and ascends.
[[nodiscard]] double evaluate_curve(std::span<const CurvePoint> curve, double at);

/// What damping is measured by: the square root of the stiffness of a bone of `length` metres, 1/s. Gravity stiffens a
/// hanging bone as a pendulum, and so does the head's own acceleration, taken to be as large.
[[nodiscard]] double natural_rate(const DynamicsRecord& record, double length);

/// How each bone moves: as the file's spring bones say (spring_dynamics.h) or by the recipe's curves, as
/// "dynamics.source" has it. By its curve a bone takes the value at its middle, so that a chain of one bone has the mean
/// and not the tip's value.
[[nodiscard]] BakedDynamics bake_dynamics(const SourceModel& source, const Skeleton& skeleton, const Recipe& recipe);

}  // namespace coif
