#pragma once

// A single step of Algorithm 1 from a state that the test chooses, which no public interface lets one do.

#include "models/test_rig.h"

#include <coif/instruction_set.h>

#include <cstdint>
#include <vector>

namespace coif {

/// Metres from the head's position, world axes; m/s.
struct Particle {
  Vec3 position;
  Vec3 velocity;
};

/// What a step of one head reads and what it leaves. Nothing acts unless the test says so.
class ThesisStep {
 public:
  explicit ThesisStep(const TestRig& rig);  ///< Its particles at rest.

  /// Advances particles and palette by one step, on every instruction set that this processor has; expects that all of
  /// them leave the same bits. The head is one of several in its block.
  void run();

  float dt = 0.1f;
  std::uint32_t iterations = 1;
  Vec3 gravity;
  Vec3 air_velocity;
  Vec3 head_displacement;           ///< World, metres.
  Quat head_rotation;               ///< World from head space at the end of the step.
  std::vector<Particle> particles;  ///< Per simulated bone.
  std::vector<Mat34> palette;       ///< Per bone; of the last step.

 private:
  [[nodiscard]] std::vector<Particle> stepped(const Asset& asset, InstructionSet set);

  TestRig rig_;
};

}  // namespace coif
