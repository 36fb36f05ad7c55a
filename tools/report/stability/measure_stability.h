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
  std::uint32_t branching = 1;  ///< Children of each bone; 1: none branches.
  double bone_length = 0.04;    ///< Metres.
  double length_ratio = 1;      ///< Every second bone is longer by this factor.
  double tip_ratio = 1;         ///< The last bone of a chain is longer by this factor, and as much heavier.
  double root_resistance = 0.3, tip_resistance = 0.08;
  double friction = 1;       ///< 1/s
  double damping_ratio = 1;  ///< At least this share of critical; below 1 not what the resistance brings along either.
  double gravity_scale = 1;
  double torsion = 20;       ///< 1/s; kShortestArc: never a twist.
  double head_radius = 0.1;  ///< Metres; the surface stays where it is behind the head's joint.
  LimitKind limit =
      LimitKind::kUnlimited;  ///< Of every bone, its middle the rest direction, from bone to bone turned about that.
  float limit_angles[2] = {0.4f, 0.2f};  ///< Radians, as LimitRecord::angles; the second of a spherical limit alone.
  bool is_linked = false;  ///< Each bone to that of the next chain, at 0.5 to 1 + link_stretch times their distance.
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

/// What is done to hair in one StressCase. After it the head stands still where it is, and frames are as usual, until
/// hair has had time to settle.
struct Stress {
  StressCase about;
  std::optional<StressRig> rig;  ///< Empty: the asset's own hair.
  lab::SolverScene scene;
  StressedHead head;
  /// What moves near the hair, world; `hair` is where that is in head space. Such cases are for `coif` alone, on a
  /// character (kCharacterSolver): what others do knows no such colliders. They are gone while hair settles.
  std::function<std::vector<MovingCollider>(const lab::HairPlace& hair, double seconds)> colliders;
  /// How the asset's own body moves; such cases are for assets that have colliders on one, and for `coif` alone. It
  /// stays where it came to while hair settles.
  BodyMotion body;
  /// Step lengths, repeated; seconds. Entries that are no lengths (0, negative, not a number) take no time.
  std::vector<double> dt{1.0 / 60};
  std::size_t steps = 240;
  /// For solvers that do not ship: they are up to a hundred times slower, and take fewer.
  std::optional<std::size_t> steps_of_others;
  double top_speed = 10;  ///< m/s of the fastest point of the head's path near the hair, as it is meant to be.
  bool settles = true;    ///< Hair comes to rest within the time for it.
};

/// Time steps, parameters, shapes, movements, then long runs.
[[nodiscard]] std::vector<Stress> stress_cases();

/// Those of them with colliders that move, and with heads of other sizes.
[[nodiscard]] std::vector<Stress> character_cases();

/// Those of them with colliders that hang on a body.
[[nodiscard]] std::vector<Stress> body_cases();

/// Those of them with chains that hang together.
[[nodiscard]] std::vector<Stress> link_cases();

/// A rig under stress, and where it would come to rest: made once for all solvers.
class StressSubject {
 public:
  StressSubject(const Stress& stress, const Asset& asset, lab::RigSample sample);

  /// False for a solver that knows nothing of what the case is about: it has no row.
  [[nodiscard]] bool is_for(const MeasuredSolver& solver) const;

  /// Runs one solver that it is for, with the least effort that it is measured with, through the case, from its rest
  /// pose. What the outcomes mean:
  /// - nan: a bone's end was not finite after some step.
  /// - diverged: a bone's end was further from the bone's start than ten of its lengths; or faster, ten steps in a row,
  ///   than a hundred times what gravity, the head and the pull to the pose can make it; or a step that was refused
  ///   moved a bone.
  /// - restless: none of that, but after hair has had eight seconds to settle it is faster than kAtRest.
  /// - rejected: none of that, and at least one step was refused with everything kept as it was.
  /// - ok: none of that.
  /// Figures are the worst up to the end, or to the step that decided. Settling is looked at where hair is free of the
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
