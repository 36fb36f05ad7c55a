#pragma once

#include "motion/head_path.h"

#include <Eigen/Core>

#include <vector>

namespace coif::render {

/// Where a picture of a moving head looks: all that hair and head take up during the first seconds of the motion, and
/// at the picture's own `time`, as far as the head's place (the camera follows it). So moments of one motion share one
/// frame. World axes, metres from the head's joint, of the hair's own. Errors: those of simulate_poses().
tl::expected<std::vector<Eigen::Vector3d>, ToolError> points_in_motion(const Asset& asset, const motion::HeadPath* path,
                                                                       double time, const StepSettings& step,
                                                                       const Solver* solver,
                                                                       const motion::HairCompany* company = nullptr);

}  // namespace coif::render
