#include "report/accuracy/measure_accuracy.h"

#include "base/timing.h"
#include "lab/measure_runtime.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool keep_tips(const lab::Rig& rig, std::span<const Vector3d> ends, std::vector<Vector3d>& tips) {
  for (const std::uint32_t tip : rig.tips) {
    if (!ends[tip].allFinite()) return false;
    tips.push_back(ends[tip]);
  }
  return true;
}

/// Sums squares of shares.
struct SquareMean {
  double sum = 0, worst = 0;
  std::size_t count = 0;

  void add(double square) {
    sum += square;
    worst = std::max(worst, square);
    ++count;
  }
  [[nodiscard]] double mean() const { return count == 0 ? kNan : sum / double(count); }
  [[nodiscard]] double root() const { return std::sqrt(mean()); }
};

std::vector<Vector3d> tips_at_rest(const lab::Rig& rig) {
  std::vector<Vector3d> ends, tips;
  for (const lab::RigBone& bone : rig.bones) {
    const Vector3d start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    ends.push_back(start + bone.length * bone.rest_direction);
  }
  for (const std::uint32_t tip : rig.tips) tips.push_back(ends[tip]);
  return tips;
}

}  // namespace

FramePoses::FramePoses(const motion::HeadPath& path, double frames_per_second, double seconds, bool tells_velocities)
    : fps(frames_per_second) {
  constexpr double kLittle = 1.0e-6;  // In frames: at a corner the head arrives with the velocity that it had.
  const auto count = long(std::floor(seconds * fps + 1.0e-6));
  for (long i = 0; i <= count; ++i) {
    times.push_back(double(i) / fps);
    poses.push_back(path.pose(times.back()));
    if (tells_velocities)
      velocities.push_back(motion::velocity_of(path.at(times.back(), times.back() - kLittle / fps)));
  }
}

std::vector<double> frame_times(std::span<const double> rates, double seconds) {
  std::vector<double> times;
  for (const double fps : rates) {
    // Divided and not added up, so that rates with common times have them to the last bit.
    const auto count = long(std::floor(seconds * fps + 1.0e-6));
    for (long i = 0; i <= count; ++i) times.push_back(double(i) / fps);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

namespace {

bool take_step(lab::ChainSolver& solver, const FramePoses& frames, std::size_t frame) {
  const double dt = frames.times[frame] - frames.times[frame - 1];
  if (frames.velocities.empty()) return solver.step(frames.poses[frame], dt);
  return solver.step_told(frames.poses[frame], frames.velocities[frame], dt);
}

}  // namespace

MotionTrial try_motion(lab::ChainSolver& solver, const lab::Rig& rig, const FramePoses& frames) {
  MotionTrial trial;
  lab::ConstraintMeter meter(rig);
  solver.reset(frames.poses.front());
  for (std::size_t i = 1; i < frames.poses.size(); ++i) {
    trial.is_finite = take_step(solver, frames, i) && keep_tips(rig, solver.bone_ends(), trial.tips);
    if (!trial.is_finite) break;
    meter.look(solver.bone_ends());
  }
  trial.worst = meter.worst();
  return trial;
}

namespace {

std::size_t sample_at(const lab::ReferenceRun& run, double time) {
  return std::size_t(std::ranges::lower_bound(run.times, time) - run.times.begin());
}

}  // namespace

TipError tip_error(const MotionTrial& trial, const FramePoses& frames, const lab::Rig& rig,
                   const lab::ReferenceRun& reference) {
  if (!trial.is_finite) return {kNan, kNan, kNan, kNan};
  SquareMean mean, moved;
  std::vector<double> of_frames;
  const std::vector<Vector3d> rest = tips_at_rest(rig);
  for (std::size_t frame = 1; frame < frames.times.size(); ++frame) {
    SquareMean of_frame;
    const std::size_t sample = sample_at(reference, frames.times[frame]);
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
      const Vector3d& place = trial.tips[(frame - 1) * rig.tips.size() + tip];
      const double apart = (place - reference.path_of_tip(tip)[sample]).norm() / rig.tip_length[tip];
      mean.add(apart * apart);
      of_frame.add(apart * apart);
      moved.add((reference.path_of_tip(tip)[sample] - rest[tip]).squaredNorm() /
                (rig.tip_length[tip] * rig.tip_length[tip]));
    }
    of_frames.push_back(of_frame.mean());
  }
  return {mean.root(), std::sqrt(mean.worst), lab::worst_second(of_frames, frames.fps), moved.root()};
}

double rms_between(const MotionTrial& a, const FramePoses& a_frames, const MotionTrial& b, const FramePoses& b_frames,
                   const lab::Rig& rig) {
  if (!a.is_finite || !b.is_finite) return kNan;
  SquareMean mean;
  std::size_t i = 1, j = 1;
  while (i < a_frames.times.size() && j < b_frames.times.size()) {
    if (a_frames.times[i] == b_frames.times[j]) {
      for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
        const Vector3d apart = a.tips[(i - 1) * rig.tips.size() + tip] - b.tips[(j - 1) * rig.tips.size() + tip];
        mean.add(apart.squaredNorm() / (rig.tip_length[tip] * rig.tip_length[tip]));
      }
    }
    const bool a_is_behind = a_frames.times[i] <= b_frames.times[j];
    const bool b_is_behind = b_frames.times[j] <= a_frames.times[i];
    if (a_is_behind) ++i;
    if (b_is_behind) ++j;
  }
  return mean.root();
}

double rms_between(const lab::ReferenceRun& a, const lab::ReferenceRun& b, const FramePoses& frames,
                   const lab::Rig& rig) {
  SquareMean mean;
  for (std::size_t frame = 1; frame < frames.times.size(); ++frame) {
    const std::size_t sample = sample_at(a, frames.times[frame]);
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
      const double apart = (a.path_of_tip(tip)[sample] - b.path_of_tip(tip)[sample]).norm() / rig.tip_length[tip];
      mean.add(apart * apart);
    }
  }
  return mean.root();
}

double time_steps(SolverAtWork& at_work, const FramePoses& frames) {
  constexpr int kRounds = 7;
  constexpr double kEnough = 0.002;  // Seconds of one round.
  constexpr std::size_t kBatch = 8;  // Steps between two looks at the clock.
  double best = kNan;
  for (int round = 0; round < kRounds; ++round) {
    at_work.solver->reset(frames.poses.front());
    std::size_t frame = 1;
    const double begin = seconds_on(TimingClock::kThread);
    double taken = 0;
    while (frame < frames.poses.size() && taken < kEnough) {
      const std::size_t until = std::min(frame + kBatch, frames.poses.size());
      for (; frame < until; ++frame) {
        if (!take_step(*at_work.solver, frames, frame)) return kNan;
      }
      taken = seconds_on(TimingClock::kThread) - begin;
    }
    const double steps = double(frame - 1) * double(at_work.bones);
    const double each = 1.0e9 * taken / steps;
    if (!(best <= each)) best = each;
  }
  return best;
}

}  // namespace coif::report
