#pragma once
// The numbers of the passive solver's integrator, which depend only on the step.

#include "lanes/lane_layout.h"

#include <cstddef>
#include <cstdint>

namespace coif {

/// Generalized-alpha (Chung and Hulbert 1993, "A Time Integration Algorithm for Structural Dynamics With Improved
/// Numerical Dissipation"): second order. Motion that is too fast for the step keeps this share of its amplitude in
/// each step.
inline constexpr double kPassiveRho = 0.4;

/// With the acceleration a and the method's own lagging one l, over a step of dt in which a particle moves by w:
/// l1 = lagged_per_way (w - dt v - lag l), a1 = mean l1 + from_lagged l + from_acceleration a,
/// v1 = v + early l + late l1.
struct PassiveMethod {
  explicit PassiveMethod(double seconds) : dt(seconds) {
    constexpr double kMass = (2 * kPassiveRho - 1) / (kPassiveRho + 1), kForce = kPassiveRho / (kPassiveRho + 1);
    constexpr double kGamma = 0.5 + kForce - kMass, kBeta = 0.25 * (1 + kForce - kMass) * (1 + kForce - kMass);
    mean = (1 - kMass) / (1 - kForce);
    from_lagged = kMass / (1 - kForce);
    from_acceleration = -kForce / (1 - kForce);
    lag = dt * dt * (0.5 - kBeta);
    lagged_per_way = 1 / (kBeta * dt * dt);
    early = dt * (1 - kGamma);
    late = dt * kGamma;
    velocity_per_way = late * lagged_per_way;
    acceleration_per_way = mean * lagged_per_way;
  }

  double dt;                                    ///< s
  double mean, from_lagged, from_acceleration;  ///< 1
  double lag;                                   ///< s^2
  double lagged_per_way;                        ///< 1/s^2
  double early, late;                           ///< s
  double velocity_per_way;                      ///< 1/s
  double acceleration_per_way;                  ///< 1/s^2
};

/// Scratch bytes of a step for each bone, the same for every instruction set.
inline constexpr std::size_t kPassiveScratch = 147 * sizeof(Lanes);
inline constexpr std::size_t kCharacterScratch = kPassiveScratch + 6 * sizeof(Lanes);  ///< The same on a character.
/// Rows of up to so many bones have their scratch on the stack, at most 75 kB; longer rows use the crowd's memory.
inline constexpr std::uint32_t kPassiveBonesOnStack = 8;

}  // namespace coif
