#pragma once
// Which heads are stepped together: those that are treated alike share blocks, so that a block has no idle lanes and no
// branches between its lanes.

#include "crowd.h"

namespace coif {

/// Number of treatments: idle, and each level of detail at each interval.
[[nodiscard]] std::uint32_t treatment_count(std::uint32_t levels, std::uint32_t intervals);

/// Blocks that suffice for any division of the instances among the treatments.
[[nodiscard]] std::uint32_t block_count(std::uint32_t instances, std::uint32_t treatments);

[[nodiscard]] std::uint32_t treatment_of(const CrowdState& crowd, const InstanceDetail& detail);
[[nodiscard]] std::uint32_t level_of(const CrowdState& crowd, std::uint32_t treatment);
[[nodiscard]] std::uint32_t interval_power_of(const CrowdState& crowd, std::uint32_t treatment);

/// All instances, in order, in blocks of the treatment that new instances get.
void fill_blocks(CrowdState& crowd);

/// Ends the sleep of an instance: it has to be at rest for the whole time again before the next.
void wake(CrowdState& crowd, std::uint32_t instance);

/// Moves the instance to where crowd.details says that it belongs. Its numbers move along; nothing is computed.
void sort_in(CrowdState& crowd, std::uint32_t instance);

}  // namespace coif
