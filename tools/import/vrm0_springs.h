#pragma once

#include "import/spring_sink.h"

namespace coif {

/// Reads `secondaryAnimation` of VRM 0.x.
///
/// A bone group lists roots, and everything below a root swings. Each joint's tail is its first child; other children
/// start a chain of their own; so a root's tree becomes one spring per first-child path, all with the group's settings.
/// A leaf has a tail that is not in the file, 7 cm further along (VRMC_springBone-1.0, "For vrm0"). Vectors are written
/// in Unity's left-handed axes, unlike the rest of the file: z is negated, as UniVRM does on its way to VRM 1.0.
void read_vrm0_springs(const nlohmann::json& secondary_animation, SpringSink& sink);

}  // namespace coif
