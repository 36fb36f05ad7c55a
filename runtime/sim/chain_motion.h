#pragma once
// Access to a chain's velocities, whatever else its solver's state has.

#include "solver.h"
#include "vector_math.h"

namespace coif {

/// One chain on one head.
class ChainMotion {
 public:
  ChainMotion(const Solver& solver, const ChainLane& chain) : solver_(solver), chain_(chain) {}

  /// The bone's direction, or its particle's place where Solver::keeps_places is set.
  [[nodiscard]] Vec3 first(std::size_t bone) const { return lane(lanes(bone, 0), chain_.state_lane); }
  [[nodiscard]] Vec3 velocity(std::size_t bone) const {
    return lane(lanes(bone, solver_.velocity_at), chain_.state_lane);
  }
  void set_velocity(std::size_t bone, const Vec3& value) {
    set_lane(lanes(bone, solver_.velocity_at), chain_.state_lane, value);
  }

 private:
  [[nodiscard]] Lanes3& lanes(std::size_t bone, std::size_t at) const {
    return *reinterpret_cast<Lanes3*>(static_cast<std::byte*>(chain_.state) + bone * solver_.state_bytes + at);
  }
  const Solver& solver_;
  const ChainLane& chain_;
};

/// Adds motion to the head and its hair, as if the hair were rigid: `velocity` in the hair's metres. Particles with a
/// state relative to their bones need no `velocity`; those with world places do.
inline void add_motion(const Solver& solver, const ChainLane& chain, const Vec3& velocity, const Vec3& turning) {
  ChainMotion motion(solver, chain);
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    const float length = solver.keeps_places ? 1.0f : chain.constants[i].length.v[chain.constant_lane];
    const Vec3 gain = cross(turning, motion.first(i) * length);
    motion.set_velocity(i, motion.velocity(i) + gain + (solver.keeps_places ? velocity : Vec3{}));
  }
}

}  // namespace coif
