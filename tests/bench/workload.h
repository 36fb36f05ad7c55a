#pragma once
// The crowds that every program of this folder times, so that their figures can stand in one table.

#include "write/asset_writer.h"

#include <coif/math.h>

#include <cstdint>

namespace coif {

/// So many heads with so many chains of so many bones.
struct CrowdShape {
  std::uint32_t heads = 1;
  std::uint32_t chains = 1;
  std::uint32_t bones = 1;  ///< Simulated, of each chain.

  [[nodiscard]] std::uint32_t bones_per_head() const { return chains * bones; }
  [[nodiscard]] double bone_count() const { return double(heads) * bones_per_head(); }
};

inline constexpr CrowdShape kCrowd{200, 3, 3};     ///< Workload (a): many heads with little hair.
inline constexpr CrowdShape kOneHead{1, 100, 16};  ///< Workload (b): one head with much hair.
inline constexpr double kFrameSeconds = 1.0 / 60;  ///< Where not said otherwise.
inline constexpr float kBoneLength = 0.08f;        ///< Metres.
inline constexpr float kHeadRadius = 0.1f;         ///< Metres; a sphere about the head's joint.

/// Chains around a head sphere, hanging down and a little outwards, bones that keep 0.01 m from the sphere.
/// They move as the cooker bakes its default curve: resistance 0.35 at the root to 0.06 at the tip, critically damped.
[[nodiscard]] AssetContents crowd_contents(const CrowdShape& shape);

/// Where head `index` is at `seconds`: it sways by 0.3 m at 0.5 Hz and turns by 57 degrees at 0.7 Hz, each head at
/// a phase of its own; heads stand in rows of 15, two metres apart.
[[nodiscard]] HeadPose head_pose_at(std::uint32_t index, double seconds);

}  // namespace coif
