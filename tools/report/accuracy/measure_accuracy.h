#pragma once

#include "base/tool_error.h"
#include "lab/hair_segment.h"
#include "lab/reference_solver.h"
#include "motion/head_path.h"
#include "report/accuracy/accuracy_report.h"
#include "report/solvers/measured_solvers.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif::report {

/// A movement of the head that is not built in.
struct NamedPath {
  std::string name;                              ///< Printable, as in the report.
  std::shared_ptr<const motion::HeadPath> path;  ///< Not null.
};

struct AccuracySettings {
  std::vector<motion::Motion> motions;  ///< Empty: the whole suite, unless `clip` is set.
  std::optional<NamedPath> clip;        ///< An additional motion.
  std::vector<double> fps{24, 30, 60, 90, 120, 144, 240};
  std::vector<std::uint32_t> substeps{1, 2, 4};  ///< Per frame, for solvers with sub-steps.
  double seconds = 4;                            ///< Length of each motion, at most 60.
  std::vector<std::string> solvers;              ///< Names; empty: the default of chosen_solvers().
  double budget_rms_pct = 2;                     ///< The limit for AccuracyReport::chosen.
  bool tells_velocities = false;  ///< Give the head's velocities; solvers that cannot use them ignore them.
};

/// Runs every solver through every motion at every frame rate beside a converged reference. Takes seconds to minutes.
/// Errors: kUsage for settings out of range or an unknown solver, kBadInput for an asset without simulated bones.
tl::expected<AccuracyReport, ToolError> measure_accuracy(const Asset& asset, const AccuracySettings& settings,
                                                         const ReportProgress& progress);

/// A head's poses, frame by frame from time 0, as a game has them.
struct FramePoses {
  FramePoses(const motion::HeadPath& path, double fps, double seconds, bool tells_velocities = false);

  double fps;
  std::vector<double> times;  ///< Seconds; the first is 0.
  std::vector<HeadPose> poses;
  std::vector<HeadVelocity> velocities;  ///< The head's velocity at each frame; empty where the game gives none.
};

/// Times of all frames at all rates, ascending, each once.
[[nodiscard]] std::vector<double> frame_times(std::span<const double> rates, double seconds);

/// A solver's result for a motion.
struct MotionTrial {
  bool is_finite = true;              ///< False where it refused a step or left finite numbers; then `tips` ends there.
  std::vector<Eigen::Vector3d> tips;  ///< Head space, metres; Rig::tips for each frame but the first.
  lab::ConstraintErrors worst;
};

/// Runs from the rest pose through all frames.
[[nodiscard]] MotionTrial try_motion(lab::ChainSolver& solver, const lab::Rig& rig, const FramePoses& frames);

/// Distance of tips to the reference, as shares of their chain's length.
struct TipError {
  double rms = 0;
  double max = 0;
  double worst_second = 0;  ///< RMS over the worst second, or all where that is shorter.
  double moved = 0;         ///< RMS distance of the reference's tips from their rest.
};
/// Over all frames and tips; NaN for a trial that is not finite. Every frame's time is one of the reference's.
[[nodiscard]] TipError tip_error(const MotionTrial& trial, const FramePoses& frames, const lab::Rig& rig,
                                 const lab::ReferenceRun& reference);

/// RMS distance of two trials' tips at the times of frames of both, as a share of the chain's length; NaN where one is
/// not finite or there is no such time.
[[nodiscard]] double rms_between(const MotionTrial& a, const FramePoses& a_frames, const MotionTrial& b,
                                 const FramePoses& b_frames, const lab::Rig& rig);

/// RMS distance of two runs' tips at the frames, as a share of the chain's length.
[[nodiscard]] double rms_between(const lab::ReferenceRun& a, const lab::ReferenceRun& b, const FramePoses& frames,
                                 const lab::Rig& rig);

/// Nanoseconds of one step per bone, by the thread's own clock: the least of some rounds through the motion's first
/// frames, on the calling thread. NaN where a step is refused.
[[nodiscard]] double time_steps(SolverAtWork& at_work, const FramePoses& frames);

/// Where a solver would come to with ever finer steps: the motion of its own model, which need not be the asset's. Of
/// the runtime's it is the reference of that model; of research::historical_solvers() the solver itself, with 15360
/// steps a second, on the head's own way, and again with half as many: how far the two are apart is the run's
/// agreement. Samples as in `reference`, which is the asset's and what a solver without a model of its own choosing
/// comes to. Empty where finer steps come to nothing (research::ListedSolver::has_model).
[[nodiscard]] std::optional<lab::ReferenceRun> own_model_run(const MeasuredSolver& solver, const lab::Rig& rig,
                                                             const lab::SolverScene& scene,
                                                             const motion::HeadPath& path,
                                                             const lab::ReferenceRun& reference);

}  // namespace coif::report
