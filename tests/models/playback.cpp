#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {
namespace {

constexpr double kTau = 6.28318530717958648;

/// From 0 at time 0 to 1 after half a second, with two continuous derivatives.
double rising(double seconds) {
  const double s = std::clamp(2 * seconds, 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

double radians(double degrees) { return degrees * kTau / 360; }

}  // namespace

HeadPose still(double) { return {}; }

HeadPose nod(double t) {
  return {{0, 0, 0}, turned_about({1, 0, 0}, radians(20) * rising(t) * std::sin(kTau * 0.77 * t))};
}

HeadPose turn(double t) { return {{0, 0, 0}, turned_about({0, 1, 0}, radians(28.5) * rising(t) * std::sin(kTau * t))}; }

HeadPose run(double t) { return {{0, 0.03 * rising(t) * std::sin(kTau * 2.4 * t), 3 * rising(t) * t}, {}}; }

HeadPose wander(double t) {
  const double r = rising(t);
  return {{0.2 * r * std::sin(4 * t), 0.05 * r * std::sin(7 * t), r * t},
          turned_about({0.36f, 0.8f, 0.48f}, 0.6 * r * std::sin(5 * t))};
}

HeadMotion until(double end, const HeadMotion& motion) {
  return [end, motion](double t) { return motion(std::min(t, end)); };
}

double Violence::between(double low, double high) {
  state_ = state_ * 1664525u + 1013904223u;
  return low + (high - low) * (state_ >> 8) / 16777216.0;
}

HeadPose Violence::next() {
  const double heading = between(0, kTau), height = between(-1, 1), flat = std::sqrt(1 - height * height);
  const Vec3 axis{float(flat * std::cos(heading)), float(height), float(flat * std::sin(heading))};
  const double x = between(-0.5, 0.5), y = between(-0.5, 0.5), z = between(-0.5, 0.5);
  return {{x, y, z}, turned_about(axis, between(0, kTau / 2))};
}

std::vector<double> even_frames(double fps, double seconds) {
  std::vector<double> frames;
  for (int i = 1; i <= int(std::lround(seconds * fps)); ++i) frames.push_back(i / fps);
  return frames;
}

std::vector<double> uneven_frames(double shortest, double longest, double seconds) {
  std::vector<double> frames;
  Violence random(5);
  double now = 0;
  for (const double meeting : even_frames(6, seconds)) {
    while (true) {
      const double next = now + random.between(shortest, longest);
      if (next > meeting - shortest) break;
      frames.push_back(now = next);
    }
    frames.push_back(now = meeting);
  }
  return frames;
}

Playback play(TestHair& test, const HeadMotion& motion, const std::vector<double>& frames, StepSettings settings) {
  Playback playback;
  EXPECT_EQ(test.hair.reset(0, motion(0)), Status::kOk);
  double last = 0;
  for (const double now : frames) {
    settings.dt = float(now - last);
    EXPECT_EQ(test.hair.set_head(0, motion(now)), Status::kOk);
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    playback.seconds.push_back(now);
    playback.ends.push_back(test.ends());
    last = now;
  }
  return playback;
}

Playback play(const TestRig& rig, const HeadMotion& motion, const std::vector<double>& frames,
              const StepSettings& settings) {
  TestHair test(rig);
  return play(test, motion, frames, settings);
}

double rms_tip_difference(const Playback& a, const Playback& b) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0, k = 0; i < a.seconds.size() && k < b.seconds.size();) {
    const double apart = a.seconds[i] - b.seconds[k];
    if (std::fabs(apart) < 1e-6) {
      const double d = distance(a.ends[i].back(), b.ends[k].back());
      sum += d * d;
      ++count;
    }
    i += apart < 1e-6 ? 1 : 0;
    k += apart > -1e-6 ? 1 : 0;
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(sum / count);
}

Vec3 start_of(const TestRig& rig, const std::vector<Vec3>& ends, std::size_t i) {
  const BoneRecord& bone = rig.bones[i + 1];
  return bone.parent == 0 ? Vec3{bone.joint[0], bone.joint[1], bone.joint[2]} : ends[bone.parent - 1];
}

float worst_stretch(const TestRig& rig, const std::vector<Vec3>& ends) {
  float worst = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const float stretch = std::fabs(distance(start_of(rig, ends, i), ends[i]) / rig.bones[i + 1].length - 1);
    worst = stretch <= worst ? worst : stretch;  // a NaN wins
  }
  return worst;
}

}  // namespace coif
