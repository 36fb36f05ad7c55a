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

/// The motions that a cook runs to judge an asset: how many sub-steps it needs, and where frames need a twist. Assets
/// store their names, so this list may differ from the motions that users choose from (all_motions()). `jog` is
/// missing: it builds up from a small sway to a large one, which takes longer than a cook's trial.
inline constexpr motion::Motion kCookSuite[] = {
    motion::Motion::kStill, motion::Motion::kNod,  motion::Motion::kTurn,   motion::Motion::kCharge,
    motion::Motion::kRun,   motion::Motion::kJump, motion::Motion::kTumble, motion::Motion::kTeleport,
    motion::Motion::kBow,   motion::Motion::kLie};

// Tests whether a chain's motion is well-posed: over motions of the suite, two computations of the reference agree, and
// the runtime follows them (runtime/docs/MODEL.md, "Well-posed or not").

inline constexpr std::uint32_t kTrialRate = 60, kTrialSubsteps = 4;

/// In the order in which they separate two computations, the worst first; still and nod never did so alone.
inline constexpr motion::Motion kTrialMotions[] = {motion::Motion::kTumble, motion::Motion::kTurn, motion::Motion::kRun,
                                                   motion::Motion::kCharge, motion::Motion::kJump};

/// Steps per second at which a cook's reference begins. For most chains twice as many agree to a fiftieth of the wanted
/// error; the others get more.
inline constexpr double kCoarsestSteps = 360;

/// How a chain failed.
struct ChainFinding {
  bool is_good = true;
  motion::Motion motion = motion::Motion::kStill;
  double self_difference_pct = 0;
  double runtime_error = 0;
  double growth = 0;  ///< Too large: nothing was computed.
};

/// If the chain is good, `runs` are its motions, in the order of kTrialMotions.
struct ChainTrial {
  ChainFinding finding;
  std::vector<lab::ReferenceRun> runs;
};

/// When trials look, seconds.
[[nodiscard]] std::vector<double> trial_times();

/// The reference of all that moves, with as many steps as it needs, or as few as show that it does not converge.
[[nodiscard]] lab::ReferenceRun solve_trial(const lab::Rig& rig, motion::Motion motion,
                                            const std::stop_token& stop = {});

/// True where a cascade amplifies rounding errors until they are visible: then it need not be computed.
[[nodiscard]] bool grows_beyond_hope(const AssetContents& alone);

/// Tries contents with one chain (chains_alone()) in the model that they are meant for. `threads`: without influence on
/// the result.
[[nodiscard]] ChainTrial try_chain(const AssetContents& alone, const platform::Threads& threads);
/// As try_chain(), even where it grows beyond hope.
[[nodiscard]] ChainTrial try_any_chain(const AssetContents& alone, const platform::Threads& threads);

/// RMS difference over all samples of one chain's runs, share of its length; infinite values count as the largest
/// error. `rig` has the chain's tips, and both lists have the same motions.
[[nodiscard]] double rms_apart(const lab::Rig& rig, std::span<const lab::ReferenceRun> a,
                               std::span<const lab::ReferenceRun> b);

[[nodiscard]] std::string what_failed(const ChainFinding& finding);

}  // namespace coif::cook
