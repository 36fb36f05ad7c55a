#pragma once
// The parts of a step, and which heads are stepped together: those that are treated alike share blocks, so that a block
// has no idle lanes and no branches between its lanes.

#include "crowd.h"
#include "step_settings.h"

namespace coif {

/// `velocity` may be null. In a plain FloatEnvironment.
Status move_head(CrowdState& crowd, std::uint32_t instance, const HeadPose& pose, const HeadVelocity* velocity);

/// Of the instances from `first` on, but those that are told again what they were told; the first bad status, if any.
Status move_heads(CrowdState& crowd, std::uint32_t first, std::span<const HeadPose> poses);

/// Chooses the blocks to step and computes what they have in common. `settings` have been checked.
void begin_step(CrowdState& crowd, const StepSettings& settings);

/// Steps one block. Touches nothing that another block's job touches.
void step_block(CrowdState& crowd, std::uint32_t block);

/// Lets those fall asleep that have come to rest.
void finish_step(CrowdState& crowd);

/// Number of treatments: idle, and for each set of dynamics each level of detail at each phase of each interval. With
/// the interval 2^p, every 2^p-th group of sixteen instances is stepped in the same step, so that steps cost about the
/// same; the group is that of the instance's number, so that its turn does not depend on what the others do.
[[nodiscard]] std::uint32_t treatment_count(std::uint32_t levels, std::uint32_t intervals, std::uint32_t sets);

/// Blocks that suffice for any division of the instances among the treatments.
[[nodiscard]] std::uint32_t block_count(std::uint32_t instances, std::uint32_t treatments);

[[nodiscard]] std::uint32_t treatment_of(const CrowdState& crowd, std::uint32_t instance);
[[nodiscard]] std::uint32_t set_of(const CrowdState& crowd, std::uint32_t treatment);
[[nodiscard]] std::uint32_t level_of(const CrowdState& crowd, std::uint32_t treatment);
[[nodiscard]] std::uint32_t interval_power_of(const CrowdState& crowd, std::uint32_t treatment);
/// Whether the treatment, not kIdle, is to be stepped in the present step.
[[nodiscard]] bool has_its_turn(const CrowdState& crowd, std::uint32_t treatment);

/// Gives the instance the interval that it was asked to have, if its last step ended both that and the present one: at
/// any other time, time would be stepped twice or not at all. Else crowd.has_asked says that one waits. To be called
/// between steps, and followed by sort_in().
void take_up_interval(CrowdState& crowd, std::uint32_t instance);

/// All instances, in order, in blocks of the treatment that new instances get.
void fill_blocks(CrowdState& crowd);

/// What HairDesc and Detail may ask for: 1, 2 or 4, which are 2 to the power 0, 1 and 2.
[[nodiscard]] inline bool is_interval(std::uint32_t interval) {
  return interval == 1 || interval == 2 || interval == 4;
}
[[nodiscard]] inline std::uint32_t power_of(std::uint32_t interval) { return interval / 2; }

/// Ends the sleep of an instance: it has to be at rest for the whole time again before the next.
void wake(CrowdState& crowd, std::uint32_t instance);

/// Moves the instance to where crowd.details says that it belongs. Its numbers move along; nothing is computed.
void sort_in(CrowdState& crowd, std::uint32_t instance);

}  // namespace coif
