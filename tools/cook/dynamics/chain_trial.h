#pragma once

#include "lab/reference_solver.h"
#include "motion/head_path.h"
#include "platform/stop.h"
#include "write/asset_writer.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// The motions that a cook runs to judge an asset: how many sub-steps it wants, and where frames need a twist. An asset
/// stores their names, so that this list may change without those that users choose from (all_motions()). `jog` is not
/// one of them: it pumps hair from a small sway to a large one, which takes longer than a cook looks.
inline constexpr motion::Motion kCookSuite[] = {
    motion::Motion::kStill, motion::Motion::kNod,  motion::Motion::kTurn,   motion::Motion::kCharge,
    motion::Motion::kRun,   motion::Motion::kJump, motion::Motion::kTumble, motion::Motion::kTeleport,
    motion::Motion::kBow,   motion::Motion::kLie};

// Whether a chain has one motion: over motions of the suite two computations of the reference agree, and the runtime
// follows it (runtime/docs/MODEL.md, "Well-posed or not").

inline constexpr std::uint32_t kTrialRate = 60, kTrialSubsteps = 4;

/// From what most easily parts two computations to what least does; still and nod never did so alone.
inline constexpr motion::Motion kTrialMotions[] = {motion::Motion::kTumble, motion::Motion::kTurn, motion::Motion::kRun,
                                                   motion::Motion::kCharge, motion::Motion::kJump};

/// Steps a second that a reference of the cook begins with. Most chains agree with twice as many to a fiftieth of what
/// is wanted; for the others there are more.
inline constexpr double kCoarsestSteps = 360;

/// How a chain failed.
struct ChainFinding {
  bool is_good = true;
  motion::Motion motion = motion::Motion::kStill;
  double self_difference_pct = 0;
  double runtime_error = 0;
  double growth = 0;  ///< So large that nothing was computed.
};

/// Where it is good, `runs` are its motions, in the order of kTrialMotions.
struct ChainTrial {
  ChainFinding finding;
  std::vector<lab::ReferenceRun> runs;
};

/// When trials look, seconds.
[[nodiscard]] std::vector<double> trial_times();

/// The motion of all that moves, as finely as it takes, or as coarsely as shows that there is none.
[[nodiscard]] lab::ReferenceRun solve_trial(const lab::Rig& rig, motion::Motion motion,
                                            const std::stop_token& stop = {});

/// True where a cascade amplifies rounding into sight: there is no need to compute it.
[[nodiscard]] bool grows_beyond_hope(const AssetContents& alone);

/// Tries contents with one chain (chains_alone()) in the model that they are meant for. `threads`: without influence on
/// the result.
[[nodiscard]] ChainTrial try_chain(const AssetContents& alone, const platform::Threads& threads);
/// The same, however hopeless it is.
[[nodiscard]] ChainTrial try_any_chain(const AssetContents& alone, const platform::Threads& threads);

/// RMS over all samples of the runs of one chain, share of its length; what was not finite is as far off as can be.
/// `rig` has the chain's tips, and both have the same motions.
[[nodiscard]] double rms_apart(const lab::Rig& rig, std::span<const lab::ReferenceRun> a,
                               std::span<const lab::ReferenceRun> b);

[[nodiscard]] std::string what_failed(const ChainFinding& finding);

}  // namespace coif::cook
