#pragma once

#include "base/hair_runtime.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::view {

/// One head's hair and its memory.
class SimulatedHead {
 public:
  /// The asset must outlive this object. In gusts kCharacterSolver replaces the solver coif; without them both are
  /// equal.
  Status create(const Asset& asset, const Solver& solver, bool in_gusts);

  /// Puts the head at this pose with its hair after two seconds of hanging, as `coif render` shows a head at rest.
  Status settle(const HeadPose& pose, const StepSettings& step);

  enum class Way : std::uint8_t {
    kMoves,  ///< The head moves to its pose.
    kNone,   ///< It is put there, and its hair keeps its shape.
  };
  Status step(const HeadPose& pose, Way way, const StepSettings& step, const Gusts& gusts);

  /// One matrix per bone; those of the rest pose where the asset has no dynamics.
  [[nodiscard]] std::span<const Mat34> palette() const;
  [[nodiscard]] bool is_asleep() const { return rest_.empty() ? hair_.is_asleep(0) : true; }
  Status set_level(std::uint32_t level);

 private:
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  std::vector<Mat34> rest_;  ///< For an asset without dynamics.
  bool in_gusts_ = false;
};

}  // namespace coif::view
