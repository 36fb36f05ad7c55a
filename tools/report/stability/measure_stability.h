#pragma once

#include "lab/placed_solid.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "motion/head_path.h"
#include "report/page/report_heading.h"
#include "report/solvers/measured_solvers.h"
#include "report/stability/stability_report.h"
#include "report/stability/stress_body.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace coif::report {

/// Chains that exist in no model, made to be simulated under stress. They start behind a head sphere, and hang.
struct StressRig {
  std::uint32_t chains = 2;     ///< Side by side, with `chain_spacing` between them.
  double chain_spacing = 0.04;  ///< Metres; 0: all in the same place.
  std::uint32_t bones_per_chain = 8;
  std::uint32_t branching = 1;  ///< Children of each bone; 1: no branches.
  double bone_length = 0.04;    ///< Metres.
  double length_ratio = 1;      ///< Every second bone is longer by this factor.
  double tip_ratio = 1;         ///< The last bone of a chain is longer by this factor, and as much heavier.
  double root_resistance = 0.3, tip_resistance = 0.08;
  double friction = 1;  ///< 1/s
  /// At least this share of critical damping; below 1 also without the damping that comes with the resistance.
  double damping_ratio = 1;
  double gravity_scale = 1;
  double torsion = 20;       ///< 1/s; kShortestArc: never a twist.
  double head_radius = 0.1;  ///< Metres; the surface stays where it is behind the head's joint.
  /// The limit of every bone, with the rest direction as its middle, turned about that from bone to bone.
  LimitKind limit = LimitKind::kUnlimited;
  float limit_angles[2] = {0.4f, 0.2f};  ///< Radians, as LimitRecord::angles; the second of a spherical limit alone.
  /// Each bone is linked to that of the next chain, at 0.5 to 1 + link_stretch times their distance.
  bool is_linked = false;
  double link_stretch = 0.1;
  double root_offset = 0.01;  ///< Metres from the surface to the chains' roots; negative: inside the head.
};

/// An asset in memory.
class StressAsset {
 public:
  /// Simulates as cooked hair does: stiffness from the resistance, damped to critical or more.
  /// `model`: which moves it.
  explicit StressAsset(const StressRig& rig, ChainModel model = ChainModel::kCascade);

  /// False where the format does not allow such a rig.
  [[nodiscard]] bool is_open() const { return asset().is_open(); }
  [[nodiscard]] const Asset& asset() const { return opened_.asset(); }

 private:
  lab::OpenedAsset opened_;
};

using StressedHead = std::function<HeadPose(double seconds)>;

/// One of the motions that every report measures.
[[nodiscard]] StressedHead moving(motion::Motion motion);

/// The stress on hair in one StressCase. After it the head stands still at its place, and frames are normal, until hair
/// has had time to settle.
struct Stress {
  StressCase about;
  std::optional<StressRig> rig;  ///< Empty: the asset's own hair.
  lab::SolverScene scene;
  StressedHead head;
  /// Colliders that move near the hair, world; `hair` is the hair's place in head space. Such cases are for `coif`
  /// only, on a character (kCharacterSolver): the other solvers have no such colliders. They are gone while hair
  /// settles.
  std::function<std::vector<MovingCollider>(const lab::HairPlace& hair, double seconds)> colliders;
  /// The motion of the asset's own body; such cases are for assets with body colliders, and for `coif` only. The body
  /// stays at its last place while hair settles.
  BodyMotion body;
  /// Step lengths, repeated; seconds. Entries that are no lengths (0, negative, not a number) take no time.
  std::vector<double> dt{1.0 / 60};
  std::size_t steps = 240;
  /// For solvers that do not ship: they are up to a hundred times slower, and get fewer steps.
  std::optional<std::size_t> steps_of_others;
  double top_speed = 10;  ///< m/s of the fastest point of the head's intended path near the hair.
  bool settles = true;    ///< Hair must come to rest within the settling time.
};

/// Time steps, parameters, shapes, movements, then long runs.
[[nodiscard]] std::vector<Stress> stress_cases();

/// The cases with moving colliders, and with heads of other sizes.
[[nodiscard]] std::vector<Stress> character_cases();

/// The cases with colliders on a body.
[[nodiscard]] std::vector<Stress> body_cases();

/// The cases with linked chains.
[[nodiscard]] std::vector<Stress> link_cases();

/// A rig under stress, and its resting place: made once for all solvers.
class StressSubject {
 public:
  StressSubject(const Stress& stress, const Asset& asset, lab::RigSample sample);

  /// False for a solver without the feature of the case: it has no row.
  [[nodiscard]] bool is_for(const MeasuredSolver& solver) const;

  /// Runs one solver for which is_for() holds, with the least effort at which it is measured, through the case, from
  /// its rest pose. The outcomes:
  /// - nan: a bone's end was not finite after some step.
  /// - diverged: a bone's end was further from the bone's start than ten of its lengths; or faster, ten steps in a row,
  ///   than a hundred times what gravity, the head and the pull to the pose can make it; or a refused step moved a
  ///   bone.
  /// - restless: none of that, but after eight seconds to settle, hair is faster than kAtRest.
  /// - rejected: none of that, and at least one step was refused with everything kept as it was.
  /// - ok: none of that.
  ///
  /// Figures are the worst up to the end, or to the step that decided. Settling is judged where hair is free of the
  /// head and comes to rest in 8 s.
  [[nodiscard]] StabilityRow run(const MeasuredSolver& solver) const;

 private:
  const Stress& stress_;
  const Asset& asset_;
  lab::RigSample sample_;
  lab::HairPlace place_;
  double top_speed_;  ///< m/s in head space.
};

struct StabilitySettings {
  std::vector<std::string> solvers;  ///< Names; empty: all of report_solvers().
};

/// Runs every solver through every stress case. Errors: kUsage for an unknown solver, kBadInput for an asset without
/// simulated bones.
tl::expected<StabilityReport, ToolError> measure_stability(const Asset& asset, const StabilitySettings& settings,
                                                           const ReportProgress& progress);

}  // namespace coif::report
