#pragma once

#include "import/spring_sink.h"

namespace coif {

/// Reads `VRMC_springBone` 1.0 (and its beta, which differs in nothing that is read), with the shapes of
/// `VRMC_springBone_extended_collider`, which replace a collider's plain shape. Joints that skip nodes keep skipping
/// them. The last joint of a spring is only the end of the one before it.
void read_vrm1_springs(const nlohmann::json& spring_bone, SpringSink& sink);

}  // namespace coif
