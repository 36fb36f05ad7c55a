#pragma once
// The runtime's plain types as C has them.

#include <coif.h>
#include <coif/math.h>

namespace coif {

inline coif_head_pose in_c(const HeadPose& pose) {
  return {{pose.position[0], pose.position[1], pose.position[2]},
          {pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w},
          pose.scale,
          pose.reserved};
}

}  // namespace coif
