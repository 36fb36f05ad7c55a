#pragma once
// The parts of a step, and the sorting of heads into blocks. Heads with equal treatment share blocks, so a block has no
// idle lanes and no branches between its lanes.

#include "crowd.h"
#include "step_settings.h"

namespace coif {

/// `velocity` may be null. Needs a plain FloatEnvironment.
Status move_head(CrowdState& crowd, std::uint32_t instance, const HeadPose& pose, const HeadVelocity* velocity);

/// Moves the instances from `first` on; a pose that did not change is skipped. Returns the first bad status, if any.
Status move_heads(CrowdState& crowd, std::uint32_t first, std::span<const HeadPose> poses);

/// Chooses the blocks to step and computes the values that they share. `settings` must have passed check_settings().
void begin_step(CrowdState& crowd, const StepSettings& settings);

/// Steps one block. Touches no data that another block's job touches.
void step_block(CrowdState& crowd, std::uint32_t block);

/// Puts instances to sleep that have come to rest.
void finish_step(CrowdState& crowd);

/// Number of treatments: idle, and one for each set of dynamics, level of detail, and phase of each interval. With the
/// interval 2^p every 2^p-th group of sixteen instances is stepped in the same step, so that all steps cost about the
/// same. The group follows from the instance's number, so its turn does not depend on the other instances.
[[nodiscard]] std::uint32_t treatment_count(std::uint32_t levels, std::uint32_t intervals, std::uint32_t sets);

/// Number of blocks that suffices for any division of the instances among the treatments.
[[nodiscard]] std::uint32_t block_count(std::uint32_t instances, std::uint32_t treatments);

[[nodiscard]] std::uint32_t treatment_of(const CrowdState& crowd, std::uint32_t instance);
[[nodiscard]] std::uint32_t set_of(const CrowdState& crowd, std::uint32_t treatment);
[[nodiscard]] std::uint32_t level_of(const CrowdState& crowd, std::uint32_t treatment);
[[nodiscard]] std::uint32_t interval_power_of(const CrowdState& crowd, std::uint32_t treatment);
/// Whether the treatment, not kIdle, is to be stepped in the present step.
[[nodiscard]] bool has_its_turn(const CrowdState& crowd, std::uint32_t treatment);

/// Gives the instance its requested interval if its last step ended both that and the present one; at any other time,
/// time would be stepped twice or not at all. Otherwise sets crowd.has_asked, since one waits. Call it between steps,
/// and sort_in() after it.
void take_up_interval(CrowdState& crowd, std::uint32_t instance);

/// Puts all instances, in order, into blocks of the treatment that new instances get.
void fill_blocks(CrowdState& crowd);

/// The intervals that HairDesc and Detail accept: 1, 2 or 4, which are 2 to the power 0, 1 and 2.
[[nodiscard]] inline bool is_interval(std::uint32_t interval) {
  return interval == 1 || interval == 2 || interval == 4;
}
[[nodiscard]] inline std::uint32_t power_of(std::uint32_t interval) { return interval / 2; }

/// Wakes an instance. It must be at rest for the whole time again before it sleeps.
void wake(CrowdState& crowd, std::uint32_t instance);

/// Moves the instance and its numbers to the block that crowd.details asks for. Computes nothing.
void sort_in(CrowdState& crowd, std::uint32_t instance);

}  // namespace coif
