#pragma once

#include "bench/timed_crowd.h"

#include <string>

namespace coif {

/// Which lengths the frames of a benchmark have.
enum class FrameLengths {
  kSteady,   ///< All 1/60 s.
  kVarying,  ///< None as long as the one before, as on a screen without vertical sync: what depends on the step's
             ///< length alone is computed anew in every frame.
};

/// Adds the benchmark `name` to those of this program. Reported are medians over frames: `ns_per_bone` of set_head()
/// for all heads and step(), `step_ns_per_bone` and `set_head_ns` (per head) of each alone, `us_per_frame`,
/// `bytes_per_head`.
void add_crowd_benchmark(const std::string& name, const CrowdRun& run, FrameLengths lengths = FrameLengths::kSteady);

}  // namespace coif
