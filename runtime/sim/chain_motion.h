#pragma once
// A chain's velocities, whatever else its solver's state has.

#include "solver.h"
#include "vector_math.h"

namespace coif {

/// One chain on one head.
class ChainMotion {
 public:
  ChainMotion(const Solver& solver, const ChainLane& chain) : solver_(solver), chain_(chain) {}

  /// The bone's direction, or its particle's place, as Solver::keeps_places says.
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

/// The head goes and turns faster by so much, in the hair's metres, and its hair with it, as if it were rigid. Only
/// particles that go where they go, and not where their bones do, feel `velocity`.
inline void add_motion(const Solver& solver, const ChainLane& chain, const Vec3& velocity, const Vec3& turning) {
  ChainMotion motion(solver, chain);
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    const float length = solver.keeps_places ? 1.0f : chain.constants[i].length.v[chain.constant_lane];
    const Vec3 gain = cross(turning, motion.first(i) * length);
    motion.set_velocity(i, motion.velocity(i) + gain + (solver.keeps_places ? velocity : Vec3{}));
  }
}

}  // namespace coif
