#pragma once

#include "base/hair_runtime.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::view {

/// One head's hair and the memory that it lives in.
class SimulatedHead {
 public:
  /// The asset must outlive this object. In gusts the solver coif gives way to kCharacterSolver, which is the same
  /// beside that.
  Status create(const Asset& asset, const Solver& solver, bool in_gusts);

  /// At this pose, as it hangs there after two seconds: what `coif render` shows of a head at rest.
  Status settle(const HeadPose& pose, const StepSettings& step);

  enum class Way : std::uint8_t {
    kMoves,  ///< The head goes to its pose.
    kNone,   ///< It is put there, with its hair as it is.
  };
  Status step(const HeadPose& pose, Way way, const StepSettings& step, const Gusts& gusts);

  /// One matrix per bone; those of the rest pose where the asset has no dynamics.
  [[nodiscard]] std::span<const Mat34> palette() const;
  [[nodiscard]] bool is_asleep() const { return rest_.empty() ? hair_.is_asleep(0) : true; }
  Status set_level(std::uint32_t level);

 private:
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  std::vector<Mat34> rest_;  ///< Of an asset without dynamics.
  bool in_gusts_ = false;
};

}  // namespace coif::view
