#include "report/stability/measure_stability.h"

#include "lab/hair_segment.h"
#include "lab/placed_solid.h"
#include "lab/reference_solver.h"
#include "report/stability/held_heads.h"
#include "report/stability/stress_meters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::report {
namespace {

using Colliders = std::vector<MovingCollider>;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kFarthest = 10;  ///< Lengths of a bone.
constexpr double kFastest = 100;  ///< Times the plausible speed.
constexpr int kFastSteps = 10;    ///< A single fast step may be a correction.
constexpr double kSettleSeconds = 8;
constexpr double kWatchedAtRest = 0.5;  ///< Seconds, the last of them.
constexpr double kSettleDt = 1.0 / 60;

bool is_on_character(const Stress& stress) { return bool(stress.colliders) || bool(stress.body); }

bool is_length(double dt) { return dt > 0 && std::isfinite(dt); }

/// The largest speed that forces can give a bone's tail, m/s: falling from above to below, carried by the head, and
/// swung by its pull to the pose.
double plausible_speed(const lab::Rig& rig, const Stress& stress) {
  double fastest = 0;
  std::vector<double> reach(rig.bones.size());
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const lab::RigBone& bone = rig.bones[i];
    reach[i] = bone.length + (bone.parent < 0 ? bone.joint.norm() : reach[std::size_t(bone.parent)]);
    const double fall = std::sqrt(4 * stress.scene.gravity.norm() * std::abs(bone.gravity_scale) * reach[i]);
    const double swing = std::min(std::sqrt(bone.stiffness), 1.0e3) * reach[i];
    fastest = std::max(fastest, fall + swing + stress.top_speed * (1 + reach[i] / 0.1));
  }
  return fastest;
}

/// Watches one solver.
class StressRun {
 public:
  StressRun(const lab::Rig& rig, double top_speed, lab::ChainSolver& solver)
      : rig_(rig), top_speed_(top_speed), solver_(solver), meter_(rig), limits_(rig), links_(rig), moving_meter_(rig) {}

  /// False once the outcome is decided.
  bool step(const HeadPose& head, double dt, std::span<const MovingCollider> colliders, const StressBody& body) {
    const auto ends = solver_.bone_ends();
    before_.assign(ends.begin(), ends.end());
    if (!solver_.set_colliders(colliders) || !solver_.set_body(body.poses()) || !solver_.step(head, dt)) {
      was_refused_ = true;
      if (!std::ranges::equal(before_, solver_.bone_ends())) outcome_ = Outcome::kDiverged;
    } else {
      look(dt);
      std::vector<lab::PlacedSolid> solids;
      for (const MovingCollider& collider : colliders) solids.emplace_back(collider, head);
      if (outcome_ == Outcome::kOk) moving_meter_.look(solver_.bone_ends(), solids);
      if (outcome_ == Outcome::kOk) moving_meter_.look(solver_.bone_ends(), body.solids(), body.sets());
    }
    return outcome_ == Outcome::kOk;
  }

  [[nodiscard]] Outcome outcome() const {
    return outcome_ == Outcome::kOk && was_refused_ ? Outcome::kRejected : outcome_;
  }
  [[nodiscard]] double fastest() const { return fastest_; }
  [[nodiscard]] double speed() const { return speed_; }  ///< In the last step.
  [[nodiscard]] const lab::ConstraintMeter& meter() const { return meter_; }
  [[nodiscard]] const LimitMeter& limits() const { return limits_; }
  [[nodiscard]] const LinkMeter& links() const { return links_; }
  [[nodiscard]] const lab::MovingMeter& moving_meter() const { return moving_meter_; }

 private:
  void look(double dt) {
    const auto ends = solver_.bone_ends();
    speed_ = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!ends[i].allFinite()) {
        outcome_ = Outcome::kNan;
        return;
      }
      const lab::RigBone& bone = rig_.bones[i];
      const Vector3d& start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
      if ((ends[i] - start).norm() > kFarthest * bone.length) outcome_ = Outcome::kDiverged;
      if (is_length(dt)) speed_ = std::max(speed_, (ends[i] - before_[i]).norm() / dt);
    }
    meter_.look(ends);
    limits_.look(ends);
    links_.look(ends);
    fastest_ = std::max(fastest_, speed_);
    fast_steps_ = speed_ > kFastest * top_speed_ ? fast_steps_ + 1 : 0;
    if (fast_steps_ >= kFastSteps) outcome_ = Outcome::kDiverged;
  }

  const lab::Rig& rig_;
  double top_speed_;
  lab::ChainSolver& solver_;
  lab::ConstraintMeter meter_;
  LimitMeter limits_;
  LinkMeter links_;
  lab::MovingMeter moving_meter_;
  std::vector<Vector3d> before_;
  Outcome outcome_ = Outcome::kOk;
  bool was_refused_ = false;
  double speed_ = 0, fastest_ = 0;
  int fast_steps_ = 0;
};

bool is_usable(const HeadPose& head) {
  return std::isfinite(head.position[0]) && std::isfinite(head.position[1]) && std::isfinite(head.position[2]);
}

/// RMS distance of tips that touch nothing to where they hang at rest, share of their chain's length; NaN without any.
double distance_to_rest(const lab::Rig& rig, const lab::SolverScene& scene, const HeadPose& head,
                        std::span<const Vector3d> ends) {
  const Quat& q = head.rotation;
  const lab::StaticPose rest = lab::static_pose(rig, scene, Quaterniond(q.w, q.x, q.y, q.z).normalized());
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < rig.tips.size(); ++i) {
    const std::uint32_t tip = rig.tips[i];
    if (!rest.is_free[tip]) continue;
    sum += (ends[tip] - rest.ends[tip]).squaredNorm() / (rig.tip_length[i] * rig.tip_length[i]);
    ++count;
  }
  return count == 0 ? kNoNumber : std::sqrt(sum / double(count));
}

}  // namespace

StressSubject::StressSubject(const Stress& stress, const Asset& asset, lab::RigSample sample)
    : stress_(stress),
      asset_(asset),
      sample_(std::move(sample)),
      place_(lab::place_of(sample_.rig)),
      top_speed_(plausible_speed(sample_.rig, stress)) {}

bool StressSubject::is_for(const MeasuredSolver& solver) const {
  if (!sample_.rig.links.empty() && (!solver.is_runtime() || solver.runtime == &kThesisSolver)) return false;
  if (stress_.body && asset_.body_colliders().empty()) return false;
  return !is_on_character(stress_) || solver.name == solver_on_a_character().name;
}

StabilityRow StressSubject::run(const MeasuredSolver& solver) const {
  const lab::Rig rig = solver.model ? lab::in_model(sample_.rig, *solver.model) : sample_.rig;
  lab::SolverScene scene = stress_.scene;
  if (stress_.colliders) scene.moving_colliders = kMaxMovingColliders;
  scene.follows_body = bool(stress_.body);
  const SolverAtWork at_work = make_solver(is_on_character(stress_) ? solver_on_a_character() : solver, asset_, sample_,
                                           scene, solver.efforts.front());
  StressRun watched(rig, top_speed_, *at_work.solver);
  HeadPose head = stress_.head(0);
  at_work.solver->reset(head);
  double seconds = 0;
  const bool takes_fewer = !solver.is_runtime() && stress_.steps_of_others;
  const std::size_t steps = takes_fewer ? *stress_.steps_of_others : stress_.steps;
  StressBody body(asset_, sample_);
  double rest_speed = 0;
  bool goes_on = true;
  for (std::size_t i = 0; i < steps && goes_on; ++i) {
    const double dt = stress_.dt[i % stress_.dt.size()];
    if (is_length(dt)) seconds += dt;
    const HeadPose next = stress_.head(seconds);
    if (stress_.body) body.move(stress_.body, seconds, next);
    goes_on = watched.step(next, dt, stress_.colliders ? stress_.colliders(place_, seconds) : Colliders(), body);
    if (is_usable(next)) head = next;
  }
  for (double t = 0; t < kSettleSeconds && goes_on; t += kSettleDt) {
    goes_on = watched.step(head, kSettleDt, {}, body);
    if (t + kWatchedAtRest > kSettleSeconds) rest_speed = std::max(rest_speed, watched.speed());
  }

  StabilityRow row{.stress_case = stress_.about.name, .solver = std::string(solver.name)};
  row.outcome = watched.outcome();
  row.max_speed = watched.fastest();
  if (row.outcome != Outcome::kNan) row.stretch_max_pct = 100 * watched.meter().worst().stretch;
  if (row.outcome != Outcome::kNan) row.limit_max_rad = watched.limits().worst();
  if (row.outcome != Outcome::kNan) row.link_stretch_max_pct = 100 * watched.links().worst();
  if (row.outcome != Outcome::kNan && watched.meter().sees_colliders()) {
    row.penetration_max_pct = 100 * watched.meter().worst().point_depth;
  }
  if (row.outcome != Outcome::kNan && is_on_character(stress_)) {
    const double moving = 100 * watched.moving_meter().worst();
    if (!(row.penetration_max_pct >= moving)) row.penetration_max_pct = moving;
  }
  if (goes_on && stress_.settles) {
    row.rest_speed = rest_speed;
    if (row.outcome == Outcome::kOk && rest_speed > kAtRest) row.outcome = Outcome::kRestless;
    row.settle_error_pct = 100 * distance_to_rest(rig, stress_.scene, head, at_work.solver->bone_ends());
  }
  return row;
}

namespace {

constexpr std::size_t kMostBones = 64;  ///< Bones of the asset: what breaks, breaks on any of its chains.

void measure(const Stress& stress, const Asset& asset, std::size_t most_bones,
             std::span<const MeasuredSolver* const> solvers, const ReportProgress& progress, StabilityReport& report) {
  const StressSubject subject(stress, asset, lab::sample_of(lab::rig_of(asset), most_bones));
  const auto is_for = [&](const MeasuredSolver* solver) { return subject.is_for(*solver); };
  if (std::ranges::any_of(solvers, is_for)) report.stress_cases.push_back(stress.about);
  for (const MeasuredSolver* solver : solvers) {
    if (!subject.is_for(*solver)) continue;
    if (progress) progress(fmt::format("{}, {}", stress.about.name, solver->name));
    report.rows.push_back(subject.run(*solver));
  }
}

/// About 15 s. Usually 20 to 200 bones move on a head, for which this suffices; with more the slowest ways are left
/// out.
constexpr std::uint64_t kMostHeldSteps = 500'000'000;

/// The asset's own hair under heads that are held, as a game runs it.
void measure_held(const Asset& asset, const ReportProgress& progress, StabilityReport& report) {
  for (const HeldHeads& held : ways_to_hold(asset, kMostHeldSteps)) {
    const std::string name = name_of(held);
    if (progress) progress(name + ", coif");
    const HeldHeadsFinding found = hold_heads(asset, held);
    report.stress_cases.push_back({name, "26 attitudes, each turned to within 0.8 s and held for 30 s"});
    StabilityRow row{.stress_case = name, .solver = "coif"};
    if (!found.is_finite) {
      row.outcome = Outcome::kNan;
    } else {
      row.outcome = found.is_restless() ? Outcome::kRestless : Outcome::kOk;
      row.max_speed = found.max_speed;
      row.rest_speed = found.rest_speed;
    }
    report.rows.push_back(std::move(row));
  }
}

/// A rig that the format refuses never reaches a solver.
void refuse(const Stress& stress, std::span<const MeasuredSolver* const> solvers, StabilityReport& report) {
  report.stress_cases.push_back(stress.about);
  for (const MeasuredSolver* solver : solvers) {
    StabilityRow row{.stress_case = stress.about.name, .solver = std::string(solver->name)};
    row.outcome = Outcome::kRejected;
    report.rows.push_back(std::move(row));
  }
}

}  // namespace

tl::expected<StabilityReport, ToolError> measure_stability(const Asset& asset, const StabilitySettings& settings,
                                                           const ReportProgress& progress) {
  const auto solvers = chosen_solvers(settings.solvers.empty() ? report_solvers() : settings.solvers);
  if (!solvers) return tl::unexpected(solvers.error());
  if (asset.skeleton().simulated_count == 0 || asset.dynamics().empty()) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, "no simulated bones: there is nothing to measure"});
  }
  StabilityReport report;
  for (const Stress& stress : stress_cases()) {
    if (!stress.rig) {
      // Moving colliders reach hair anywhere on the head, and only the runtime is watched.
      measure(stress, asset, is_on_character(stress) ? kMaxBones : kMostBones, *solvers, progress, report);
      continue;
    }
    const StressAsset made(*stress.rig);
    if (made.is_open()) {
      measure(stress, made.asset(), kMaxBones, *solvers, progress, report);
    } else {
      refuse(stress, *solvers, report);
    }
  }
  if (std::ranges::any_of(*solvers, [](const MeasuredSolver* solver) { return solver->name == "coif"; })) {
    measure_held(asset, progress, report);
  }
  return report;
}

}  // namespace coif::report
