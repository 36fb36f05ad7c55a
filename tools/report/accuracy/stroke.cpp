#include "report/accuracy/stroke.h"

#include "base/parallel_for.h"
#include "lab/placed_solid.h"
#include "report/accuracy/measure_accuracy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostStrokedBones = 128;
constexpr double kInHundredths = 100;

/// A hand as a capsule that points at the head and moves in an upright ellipse through the hair's middle, once in two
/// seconds: down on one side and up on the other.
MovingCollider hand_at(const lab::HairPlace& hair, double seconds) {
  constexpr double kRadius = 0.025, kLength = 0.12, kAside = 0.10, kUp = 0.08;
  const double angle = std::numbers::pi * seconds;
  const Vector3d aside = Vector3d::UnitY().cross(hair.outward);
  const Vector3d place = hair.middle + aside * (kAside * std::cos(angle)) + Vector3d::UnitY() * (kUp * std::sin(angle));
  const Vector3d axis = kLength * hair.outward, end = place - 0.5 * axis;
  MovingCollider hand;
  hand.shape = ColliderShape::kCapsule;
  std::copy_n(end.data(), 3, hand.center);
  hand.axis = {float(axis.x()), float(axis.y()), float(axis.z())};
  hand.radius = float(kRadius);
  return hand;
}

class Stroke {
 public:
  explicit Stroke(const Asset& asset)
      : asset_(asset),
        sample_(lab::sample_of(lab::rig_of(asset), kMostStrokedBones)),
        place_(lab::place_of(sample_.rig)) {}

  [[nodiscard]] const lab::Rig& rig() const { return sample_.rig; }

  /// `times`: of frames, ascending; it begins at the first.
  struct Run {
    MotionTrial trial;
    double depth = 0;
  };
  /// Divides each frame into equal parts at which the hand is set, and each of those into `substeps`.
  [[nodiscard]] Run run(const std::vector<double>& times, double parts_per_second, int substeps) const {
    const SolverAtWork at_work =
        make_solver(solver_on_a_character(), asset_, sample_, lab::SolverScene{.moving_colliders = 1}, substeps);
    lab::ConstraintMeter meter(sample_.rig);
    lab::MovingMeter moving(sample_.rig);
    Run run;
    at_work.solver->reset({});
    for (std::size_t frame = 1; frame < times.size() && run.trial.is_finite; ++frame) {
      run.trial.is_finite = go_on(*at_work.solver, times[frame - 1], times[frame], parts_per_second);
      const auto ends = at_work.solver->bone_ends();
      if (!std::ranges::all_of(ends, [](const Vector3d& end) { return end.allFinite(); })) run.trial.is_finite = false;
      const lab::PlacedSolid hand(hand_at(place_, times[frame]), {});
      moving.look(ends, {&hand, 1});
      meter.look(ends);
      for (const std::uint32_t tip : sample_.rig.tips) run.trial.tips.push_back(ends[tip]);
    }
    run.trial.worst = meter.worst();
    run.depth = moving.worst();
    return run;
  }

  /// Runs twice, like the references of other motions, the second time with steps of double length.
  [[nodiscard]] lab::ReferenceRun converged(const std::vector<double>& times, double steps_per_second) const {
    MotionTrial trials[2];
    parallel_for(2, platform::all_threads(),
                 [&](std::size_t i) { trials[i] = run(times, steps_per_second / double(i + 1), 1).trial; });
    lab::ReferenceRun reference{.times = times, .agreement = {}, .places = {}};
    const std::size_t tips = sample_.rig.tips.size();
    for (std::size_t tip = 0; tip < tips; ++tip) {
      double sum = 0;
      lab::TipAgreement agreement{.steps_per_second = steps_per_second};
      // At time 0 all are the same; trials have no frame there.
      reference.places.push_back(Vector3d::Zero());
      for (std::size_t at = tip; at < trials[0].tips.size(); at += tips) {
        const bool both = at < trials[1].tips.size();
        const double apart = both ? (trials[0].tips[at] - trials[1].tips[at]).norm() : kNoNumber;
        const double pct = kInHundredths * apart / sample_.rig.tip_length[tip];
        sum += pct * pct;
        agreement.max_pct = std::max(agreement.max_pct, pct);
        reference.places.push_back(trials[0].tips[at]);
      }
      reference.places.resize((tip + 1) * times.size(), Vector3d::Constant(kNoNumber));
      agreement.rms_pct = std::sqrt(sum / double(std::max<std::size_t>(times.size() - 1, 1)));
      reference.agreement.push_back(agreement);
    }
    return reference;
  }

 private:
  [[nodiscard]] bool go_on(lab::ChainSolver& solver, double from, double until, double parts_per_second) const {
    const auto parts = std::max(1L, long(std::ceil((until - from) * parts_per_second - 1e-6)));
    for (long i = 1; i <= parts; ++i) {
      const double time = i < parts ? from + (until - from) * double(i) / double(parts) : until;
      const MovingCollider hand = hand_at(place_, time);
      if (!solver.set_colliders({&hand, 1}) || !solver.step({}, (until - from) / double(parts))) return false;
    }
    return true;
  }

  const Asset& asset_;
  lab::RigSample sample_;
  lab::HairPlace place_;
};

}  // namespace

std::vector<StrokeRow> measure_stroke(const Asset& asset, const StrokeSettings& settings) {
  const Stroke stroke(asset);
  const auto still = motion::path_of(motion::Motion::kStill);
  const lab::ReferenceRun reference =
      stroke.converged(frame_times(settings.fps, settings.seconds), settings.reference_steps_per_second);
  std::vector<StrokeRow> rows;
  for (const double fps : settings.fps) {
    const FramePoses frames(*still, fps, settings.seconds);
    for (const std::uint32_t substeps : settings.substeps) {
      const Stroke::Run run = stroke.run(frames.times, 0, int(substeps));
      const TipError error = tip_error(run.trial, frames, stroke.rig(), reference);
      StrokeRow row{.fps = fps, .substeps = substeps};
      row.rms_error_pct = kInHundredths * error.rms;
      row.max_error_pct = kInHundredths * error.max;
      row.self_difference_pct = reference.self_difference_pct();
      if (error.moved > 0) row.of_motion_pct = kInHundredths * error.rms / error.moved;
      if (run.trial.is_finite) row.stretch_max_pct = kInHundredths * run.trial.worst.stretch;
      if (run.trial.is_finite) row.penetration_max_pct = kInHundredths * run.depth;
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace coif::report
