#pragma once

// Heads that move as a function of time, and what hair did while they moved: for tests that compare one motion at
// several frame rates.

#include "models/test_rig.h"

#include <functional>
#include <vector>

namespace coif {

using HeadMotion = std::function<HeadPose(double seconds)>;

/// Smooth, from rest at time 0, all of them.
[[nodiscard]] HeadPose still(double seconds);
[[nodiscard]] HeadPose nod(double seconds);     ///< 40 degrees at 0.77 Hz.
[[nodiscard]] HeadPose turn(double seconds);    ///< 57 degrees at 1 Hz, about the vertical.
[[nodiscard]] HeadPose run(double seconds);     ///< 3 m/s, 6 cm up and down at 2.4 Hz.
[[nodiscard]] HeadPose wander(double seconds);  ///< Every axis at its own rate: nothing about it is symmetric.

/// `motion` until `end`, then its pose there for ever: an abrupt halt.
[[nodiscard]] HeadMotion until(double end, const HeadMotion& motion);

/// Other poses than the last every time: up to half a metre and half a turn away from the origin.
class Violence {
 public:
  explicit Violence(std::uint32_t seed) : state_(seed) {}
  HeadPose next();
  double between(double low, double high);

 private:
  std::uint32_t state_;
};

/// Ends of frames, seconds: every 1 / fps until `seconds`.
[[nodiscard]] std::vector<double> even_frames(double fps, double seconds);
/// Frames of random lengths between two bounds, and one that ends at every sixth of a second, where all the usual frame
/// rates meet as well.
[[nodiscard]] std::vector<double> uneven_frames(double shortest, double longest, double seconds);

struct Playback {
  std::vector<double> seconds;
  std::vector<std::vector<Vec3>> ends;  ///< Per frame, the simulated bones'.
};

/// Resets the hair to the motion's start, then steps from frame to frame. settings.dt is the frames'.
[[nodiscard]] Playback play(TestHair& test, const HeadMotion& motion, const std::vector<double>& frames,
                            StepSettings settings = {});
[[nodiscard]] Playback play(const TestRig& rig, const HeadMotion& motion, const std::vector<double>& frames,
                            const StepSettings& settings = {});

/// Root mean square of the distances between the last bones' ends at the times that both have frames at, metres; NaN
/// where there are none.
[[nodiscard]] double rms_tip_difference(const Playback& a, const Playback& b);

/// Worst | length / rest length - 1| over the bones.
[[nodiscard]] float worst_stretch(const TestRig& rig, const std::vector<Vec3>& ends);
/// Where the simulated bone `i` starts: its joint, or its parent's end.
[[nodiscard]] Vec3 start_of(const TestRig& rig, const std::vector<Vec3>& ends, std::size_t i);

}  // namespace coif
