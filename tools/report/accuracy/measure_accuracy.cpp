#include "report/accuracy/measure_accuracy.h"

#include "base/parallel_for.h"
#include "lab/reference_solver.h"

#include <coif/hair.h>
#include <coif/instruction_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostBones = 128;  ///< Side by side; more trees of an asset add nothing.
constexpr double kSettleSeconds = 6;
constexpr double kSettleRate = 60;
constexpr double kPercent = 100;
constexpr double kLeastMoved = 1e-3;  ///< Lengths, RMS: below it no share is reported.

class AccuracyMeasurement {
 public:
  AccuracyMeasurement(const Asset& asset, const AccuracySettings& settings, const ReportProgress& progress)
      : asset_(asset),
        settings_(settings),
        progress_(progress),
        sample_(lab::sample_of(lab::rig_of(asset), kMostBones)) {}

  AccuracyReport run(std::span<const NamedPath> motions, std::span<const MeasuredSolver* const> solvers) {
    report_.budget_rms_pct = settings_.budget_rms_pct;
    for (const NamedPath& motion : motions) measure_motion(motion, solvers);
    measure_settling(solvers);
    const auto passive = std::ranges::count(sample_.rig.bones, ChainModel::kPassive, &lab::RigBone::model);
    const auto changed =
        std::ranges::count_if(sample_.rig.bones, [](const lab::RigBone& bone) { return bone.asked.has_value(); });
    const double bones = double(std::max<std::size_t>(sample_.rig.bones.size(), 1));
    report_.passive_share = double(passive) / bones;
    report_.conditioned_share = double(changed) / bones;
    report_.tells_velocities = settings_.tells_velocities;
    tell("swings");
    report_.swings = measure_swings(asset_);
    if (settings_.motions.empty() && !settings_.clip && has_ours(solvers)) {
      tell("stroke");
      report_.stroke = measure_stroke(asset_, {settings_.fps, settings_.substeps, settings_.seconds});
    }
    choose();
    return std::move(report_);
  }

 private:
  [[nodiscard]] static bool has_ours(std::span<const MeasuredSolver* const> solvers) {
    return std::ranges::any_of(solvers,
                               [](const MeasuredSolver* one) { return one->name == solver_on_a_character().name; });
  }

  [[nodiscard]] std::vector<int> efforts_of(const MeasuredSolver& solver) const {
    if (solver.is_runtime()) return {settings_.substeps.begin(), settings_.substeps.end()};
    return {solver.efforts.begin(), solver.efforts.end()};
  }

  void measure_motion(const NamedPath& motion, std::span<const MeasuredSolver* const> solvers) {
    tell(fmt::format("reference, {}", motion.name));
    const lab::ReferenceRun reference = lab::solve_reference(
        sample_.rig, scene_, *motion.path,
        {.sample_times = frame_times(settings_.fps, settings_.seconds), .threads = platform::all_threads()});
    report_.reference.push_back({motion.name, reference.self_difference_pct(), reference.steps_per_second()});
    std::vector<FramePoses> frames;
    for (const double fps : settings_.fps) {
      frames.emplace_back(*motion.path, fps, settings_.seconds, settings_.tells_velocities);
    }
    const std::size_t first_row = report_.rows.size();
    for (const MeasuredSolver* solver : solvers) {
      tell(fmt::format("{}, {}", solver->name, motion.name));
      const auto own = own_model(*solver, motion, reference);
      for (const int effort : efforts_of(*solver)) {
        measure_setting({motion.name, *solver, effort}, frames, reference, own ? &*own : nullptr);
      }
    }
    mark_fronts(std::span(report_.rows).subspan(first_row));
  }

  /// Also empty where the solver's own motion is not well-defined: then there are no errors relative to it.
  std::optional<lab::ReferenceRun> own_model(const MeasuredSolver& solver, const NamedPath& motion,
                                             const lab::ReferenceRun& reference) {
    auto own = own_model_run(solver, sample_.rig, scene_, *motion.path, reference);
    if (!own) return own;
    const double apart = own->self_difference_pct();
    report_.own_reference.push_back({std::string(solver.name), motion.name, apart});
    if (!(apart <= largest_self_difference(report_.budget_rms_pct))) own.reset();
    return own;
  }

  struct Setting {
    const std::string& motion;
    const MeasuredSolver& solver;
    int effort;
  };

  /// `own` may be null.
  void measure_setting(const Setting& setting, std::span<const FramePoses> frames, const lab::ReferenceRun& reference,
                       const lab::ReferenceRun* own) {
    const auto& [motion, solver, effort] = setting;
    std::vector<MotionTrial> trials;
    for (const FramePoses& at_rate : frames) {
      SolverAtWork at_work = make_solver(solver, asset_, sample_, scene_, effort);
      trials.push_back(try_motion(*at_work.solver, sample_.rig, at_rate));
      const MotionTrial& trial = trials.back();
      AccuracyRow row{.motion = motion, .solver = std::string(solver.name), .fps = at_rate.fps};
      row.substeps = std::uint32_t(effort);
      row.code = solver.is_runtime() ? fmt::format("float, {}", name_of(best_instruction_set())) : "double, scalar";
      const TipError error = tip_error(trial, at_rate, sample_.rig, reference);
      row.rms_error_pct = kPercent * error.rms;
      row.max_error_pct = kPercent * error.max;
      row.worst_second_pct = kPercent * error.worst_second;
      if (own != nullptr) {
        row.own_error_pct = kPercent * tip_error(trial, at_rate, sample_.rig, *own).rms;
        row.model_distance_pct = kPercent * rms_between(*own, reference, at_rate, sample_.rig);
      }
      if (error.moved > kLeastMoved) row.of_motion_pct = kPercent * error.rms / error.moved;
      row.stretch_max_pct = trial.is_finite ? kPercent * trial.worst.stretch : kNoNumber;
      if (trial.is_finite && meter_.sees_colliders()) {
        row.penetration_max_pct = kPercent * trial.worst.point_depth;
        row.segment_penetration_max_pct = kPercent * trial.worst.segment_depth;
      }
      row.ns_per_bone_frame = time_steps(at_work, at_rate);
      report_.rows.push_back(std::move(row));
    }
    report_.spread.push_back({motion, std::string(solver.name), std::uint32_t(effort), spread_of(trials, frames)});
  }

  [[nodiscard]] double spread_of(std::span<const MotionTrial> trials, std::span<const FramePoses> frames) const {
    double widest = kNoNumber;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      for (std::size_t j = i + 1; j < trials.size(); ++j) {
        if (!trials[i].is_finite || !trials[j].is_finite) return kNoNumber;
        const double apart = kPercent * rms_between(trials[i], frames[i], trials[j], frames[j], sample_.rig);
        if (!(apart <= widest) && !std::isnan(apart)) widest = apart;
      }
    }
    return widest;
  }

  /// Tips at rest: in closed form, and by the reference where they lie on something.
  [[nodiscard]] std::vector<Vector3d> resting_tips() const {
    const lab::StaticPose pose = lab::static_pose(sample_.rig, scene_);
    const lab::ReferenceRun settled =
        lab::solve_reference(sample_.rig, scene_, *motion::path_of(motion::Motion::kStill),
                             {.sample_times = {kSettleSeconds}, .threads = platform::all_threads()});
    std::vector<Vector3d> tips;
    for (std::size_t i = 0; i < sample_.rig.tips.size(); ++i) {
      const std::uint32_t tip = sample_.rig.tips[i];
      tips.push_back(pose.is_free[tip] ? pose.ends[tip] : settled.path_of_tip(i)[0]);
    }
    return tips;
  }

  void measure_settling(std::span<const MeasuredSolver* const> solvers) {
    tell("settling");
    const std::vector<Vector3d> tips = resting_tips();
    const FramePoses frames(*motion::path_of(motion::Motion::kStill), kSettleRate, kSettleSeconds);
    for (const MeasuredSolver* solver : solvers) {
      const SolverAtWork at_work = make_solver(*solver, asset_, sample_, scene_, efforts_of(*solver).front());
      const MotionTrial trial = try_motion(*at_work.solver, sample_.rig, frames);
      double sum = 0;
      for (std::size_t i = 0; i < tips.size() && trial.is_finite; ++i) {
        sum += (trial.tips[trial.tips.size() - tips.size() + i] - tips[i]).squaredNorm() /
               (sample_.rig.tip_length[i] * sample_.rig.tip_length[i]);
      }
      const double error = trial.is_finite ? kPercent * std::sqrt(sum / double(tips.size())) : kNoNumber;
      report_.settle.push_back({std::string(solver->name), error});
    }
  }

  /// Chooses among the solvers that games can run.
  void choose() {
    for (const AccuracyRow& mean : means_over_motions(report_, main_frame_rate(report_))) {
      const bool fits = mean.rms_error_pct <= settings_.budget_rms_pct;
      if (!fits || !find_measured_solver(mean.solver)->is_runtime()) continue;
      if (report_.chosen && report_.chosen->ns_per_bone_frame <= mean.ns_per_bone_frame) continue;
      report_.chosen = {mean.solver, mean.substeps, mean.rms_error_pct, mean.ns_per_bone_frame};
    }
  }

  void tell(const std::string& step) const {
    if (progress_) progress_(step);
  }

  const Asset& asset_;
  const AccuracySettings& settings_;
  const ReportProgress& progress_;
  lab::SolverScene scene_;
  lab::RigSample sample_;
  lab::ConstraintMeter meter_{sample_.rig};
  AccuracyReport report_;
};

tl::expected<void, ToolError> check(const AccuracySettings& settings) {
  if (!(settings.seconds > 0) || settings.seconds > 60)
    return usage("seconds of a motion have to be above 0, up to 60");
  if (settings.fps.empty() || settings.substeps.empty()) return usage("there is nothing to measure: give a frame rate");
  for (const double fps : settings.fps) {
    if (!(fps >= 1 && fps <= 10000)) return usage(fmt::format("frame rate {}: has to be 1 to 10000 per second", fps));
  }
  for (const std::uint32_t substeps : settings.substeps) {
    if (substeps < 1 || substeps > kMaxSubsteps) {
      return usage(fmt::format("{} sub-steps: have to be 1 to {}", substeps, kMaxSubsteps));
    }
  }
  return {};
}

std::vector<NamedPath> motions_of(const AccuracySettings& settings) {
  std::vector<NamedPath> motions;
  const bool suite = settings.motions.empty() && !settings.clip;
  for (const motion::MotionInfo& info : motion::all_motions()) {
    const bool wanted = suite || std::ranges::find(settings.motions, info.motion) != settings.motions.end();
    if (wanted) motions.push_back({info.name, motion::path_of(info.motion)});
  }
  if (settings.clip) motions.push_back(*settings.clip);
  return motions;
}

}  // namespace

tl::expected<AccuracyReport, ToolError> measure_accuracy(const Asset& asset, const AccuracySettings& settings,
                                                         const ReportProgress& progress) {
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  const auto solvers = chosen_solvers(settings.solvers);
  if (!solvers) return tl::unexpected(solvers.error());
  if (asset.skeleton().simulated_count == 0 || asset.dynamics().empty()) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, "no simulated bones: there is nothing to measure"});
  }
  return AccuracyMeasurement(asset, settings, progress).run(motions_of(settings), *solvers);
}

}  // namespace coif::report
