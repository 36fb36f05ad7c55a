#pragma once

// How far a simulated pose violates the two constraints of the solver.

#include "base/tool_error.h"
#include "motion/head_path.h"

#include <coif/asset.h>
#include <coif/hair.h>
#include <coif/math.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace coif::animation {

/// Worst |length / rest length - 1| over the simulated bones; 0 for an asset without any.
/// `bone_ends`: one per bone, head space, metres, as Hair::bone_ends() gives them.
[[nodiscard]] float worst_stretch(const Asset& asset, std::span<const Vec3> bone_ends);

/// Worst depth of a simulated particle inside a collider of its bone's set, as a share of the collider's radius: 0
/// outside, 1 at the centre; for colliders that keep hair inside, how far it is outside. Planes count as if their
/// radius were 0.1 m. Hit radii are a margin and do not count. Exact for spheres and capsules. For an ellipsoid the
/// depth is measured along the line through its centre, in the space in which it is a unit sphere; the nearest way out
/// can be shorter, so flat ellipsoids give too large values, never too small ones.
[[nodiscard]] float worst_penetration(const Asset& asset, std::span<const Vec3> bone_ends);

// Recordings of the runtime during a motion.

inline constexpr double kShortestFrame = 0.001, kLongestFrame = 1;  ///< Seconds, of FrameLengths.
inline constexpr double kMostJitter = 0.9;                          ///< Largest FrameLengths::jitter.

/// Frames of different lengths, as in a game.
struct FrameLengths {
  std::vector<double> seconds{};  ///< Used in turn, kShortestFrame..kLongestFrame each. Empty: all frames take 1 / fps.
  double jitter = 0;       ///< Each frame is longer or shorter by up to this share of its length, 0..kMostJitter.
  std::uint32_t seed = 1;  ///< Seed of the jitter.

  [[nodiscard]] bool is_even() const { return seconds.empty() && jitter == 0; }
};

struct RecordingSettings {
  motion::Motion motion = motion::Motion::kTurn;
  std::shared_ptr<const motion::HeadPath> clip{};  ///< Instead of `motion`, unless null.
  double fps = 60;                                 ///< Steps and frames per second, 1 / kMaxTimeStep .. 1000.
  FrameLengths lengths{};  ///< Lengths of the recording's frames; hair settles at `fps` whatever they are.
  double seconds = 4;      ///< Length of the recording, 0..3600.
  /// Steps at the first pose before the recording starts, so that gravity has sagged the hair.
  double settle_seconds = 2;
  const Solver* solver = &kCoifSolver;
  StepSettings step{};  ///< dt follows from fps.
  /// Only with kCoifSolver, except for a scale. It stays at its first moment while hair settles.
  motion::HairCompany company{};
};

struct RecordedFrame {
  double seconds = 0;
  HeadPose head;
  std::vector<Mat34> palette;   ///< One per bone, head space.
  std::vector<Vec3> bone_ends;  ///< One per bone, head space, metres.
};

struct Recording {
  std::vector<RecordedFrame> frames;  ///< frames[0] is t = 0.
  float stretch_max = 0;              ///< Worst |length / rest - 1| of a simulated bone.
  float penetration_max = 0;          ///< Worst depth of a particle inside the head, as a share of the head's radius.
  /// In the last frame: largest distance of a bone end from the rest pose, share of the longest chain's length.
  float from_rest = 0;
  float last_speed = 0;  ///< Fastest bone end against the head in the last second, metres of the hair a second.
};

/// Times of the recording's frames, seconds: 0, then the end of each step, up to settings.seconds.
[[nodiscard]] std::vector<double> frame_ends(const RecordingSettings& settings);

/// Simulates one head. Errors: kUsage for settings outside their ranges or a recording above 1 GiB, kBadInput for an
/// asset that the runtime refuses. Deterministic.
tl::expected<Recording, ToolError> record(const Asset& asset, const RecordingSettings& settings);

/// One row per frame and bone: frame,seconds,bone,name,x,y,z (head space) and world_x,world_y,world_z, metres.
[[nodiscard]] std::string to_csv(const Asset& asset, const Recording& recording);

/// A binary glTF 2.0: skinned mesh, joints, one animation of the recording. Opens in Blender and any glTF viewer.
/// `base_color_png`: encoded texture for the material, embedded unchanged; empty: the plain base colour. Empty where
/// the recording has no frame or the file would exceed glTF's limit of 4 GiB.
[[nodiscard]] std::vector<std::byte> to_glb(const Asset& asset, const Recording& recording,
                                            std::span<const std::uint8_t> base_color_png = {});

}  // namespace coif::animation
