#pragma once

#include "motion/head_path.h"
#include "tool_error.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <tl/expected.hpp>

#include <vector>

namespace coif {

/// One moment of an asset's movement.
struct HairPose {
  HeadPose head;
  std::vector<Mat34> palette;  ///< One per bone, head space.
};

/// Runs the runtime at 60 Hz: two seconds at the motion's first pose, so that gravity has sagged the hair, then the
/// motion up to `seconds`. Without a motion (null): the sagged hair under a head at rest. An asset without dynamics keeps its
/// rest shape.
tl::expected<HairPose, ToolError> simulate_pose(const Asset& asset, const HeadPath* motion, double seconds,
                                                StepSettings step);

}  // namespace coif
