#pragma once
// The few types of the runtime's interface. Plain data; hosts convert their own.

namespace coif {

struct Vec3 {
  float x = 0, y = 0, z = 0;
};

/// Rotation (x, y, z, w), unit length.
struct Quat {
  float x = 0, y = 0, z = 0, w = 1;
};

/// Affine transform, three rows of four, row-major: p' = rows * (p, 1). Uploads as three vec4 per bone.
struct Mat34 {
  float m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
};

inline constexpr float kSmallestScale = 0.05f, kLargestScale = 20.0f;  ///< A head's size against its asset's.

/// World from head space: p' = position + rotation (scale p). Double precision, so that hair does not shake far from
/// the world's origin.
struct HeadPose {
  double position[3] = {0, 0, 0};  ///< Metres.
  Quat rotation;
  float scale = 1;     ///< Uniform, kSmallestScale..kLargestScale; may change while hair moves.
  float reserved = 0;  ///< Zero.
};

/// How a head moves at an instant, world axes.
struct HeadVelocity {
  Vec3 linear;   ///< How HeadPose::position moves, m/s.
  Vec3 angular;  ///< rad/s.
};

}  // namespace coif
