#pragma once

#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "motion/head_path.h"
#include "platform/stop.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif::lab {

struct ReferenceSettings {
  std::vector<double> sample_times;          ///< Seconds, ascending, >= 0. Steps end there: nothing is interpolated.
  double steps_per_second = 720;             ///< At least so many; bones that are too stiff for it get more.
  double most_steps_per_second = 11520;      ///< For the finer of the two compared runs, unless more is needed.
  double wanted_self_difference_pct = 0.05;  ///< RMS over a tree of bones; finer steps are taken until it is met.
  platform::Threads threads = 1;             ///< solve_reference() throws Stopped where its token is requested.
  /// Limit of one tree's steps over all its runs, as a multiple of the steps of its first run (first_run_work()): a
  /// bound of the work that is the same on every machine. Finer steps that would need more are not taken; a tree whose
  /// first two runs need more is not solved. The second run has twice as many steps as the first, and hair that whips
  /// round needs up to 16 times as many. 0: no bound.
  double most_work = 0;
};

/// The certainty of a tip's path: the finest run against the one with steps of twice the length.
struct TipAgreement {
  double rms_pct = 0;  ///< Distance in % of the chain's length, over the samples. NaN where a run exploded.
  double max_pct = 0;
  double steps_per_second = 0;  ///< In the finest run.
  bool was_cut = false;         ///< ReferenceSettings::most_work ended the search for better agreement.
  bool is_solved = true;        ///< False where it ended it before there was a result: places and agreement are NaN.
};

/// Tips of the converged solution along one path.
struct ReferenceRun {
  std::vector<double> times;
  std::vector<TipAgreement> agreement;  ///< One per entry of Rig::tips.
  std::vector<Eigen::Vector3d> places;  ///< Head space, metres; times.size() for each tip.

  [[nodiscard]] std::span<const Eigen::Vector3d> path_of_tip(std::size_t tip) const {
    return std::span(places).subspan(tip * times.size(), times.size());
  }
  /// Over all tips.
  [[nodiscard]] double self_difference_pct() const;
  [[nodiscard]] double worst_difference_pct() const;
  [[nodiscard]] double steps_per_second() const;  ///< In the coarsest tree's finest run.
  [[nodiscard]] bool is_solved() const;           ///< True for every tip.
  [[nodiscard]] bool was_cut() const;             ///< True for some tip.
  std::uint64_t bone_steps = 0;                   ///< The work done.
};

/// Steps times bones of the first runs of all trees, without steps that are cut because hair whips round.
[[nodiscard]] double first_run_work(const Rig& rig, const SolverScene& scene, const ReferenceSettings& settings);

/// Solves the continuous model along `path` from the rest pose at time 0. Never fails: where the model is chaotic or
/// too stiff for the allowed steps, the agreement shows it.
[[nodiscard]] ReferenceRun solve_reference(const Rig& rig, const SolverScene& scene, const motion::HeadPath& path,
                                           const ReferenceSettings& settings);

/// The hair under a head that stands still: the equilibrium of the model's forces.
struct StaticPose {
  std::vector<Eigen::Vector3d> ends;  ///< Bone tails, head space, metres; the order of Rig::bones.
  /// False where a bone, or one that it hangs from, would be inside a collider or beyond its angle limit, or is linked:
  /// the pose then is only the one without these. Also false in the passive model, for which there is no pose.
  std::vector<bool> is_free;
};

/// In closed form, root to tip: a bone points along stiffness times length times its default direction, plus gravity
/// and wind, and its frame is turned there by the shortest arc.
[[nodiscard]] StaticPose static_pose(const Rig& rig, const SolverScene& scene,
                                     const Eigen::Quaterniond& head_rotation = Eigen::Quaterniond::Identity());

}  // namespace coif::lab
