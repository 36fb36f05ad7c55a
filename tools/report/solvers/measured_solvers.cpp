#include "report/solvers/measured_solvers.h"

#include "lab/runtime_solver.h"
#include "report/solvers/historical_solvers.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace coif::report {
namespace {

template <typename Solver>
std::unique_ptr<lab::ChainSolver> iterated(const lab::Rig& rig, const lab::SolverScene& scene, int iterations) {
  return std::make_unique<Solver>(rig, scene, iterations);
}

template <typename Solver>
std::unique_ptr<lab::ChainSolver> sub_stepped(const lab::Rig& rig, const lab::SolverScene& scene, int count) {
  return in_sub_steps(std::make_unique<Solver>(rig, scene), count);
}

constexpr std::string_view kIterations = "iterations";
constexpr std::string_view kSubSteps = "sub-steps";

constexpr int kFew[] = {1, 2, 4, 8};
constexpr int kNewton[] = {1, 2, 3, 4};
constexpr int kSmallSteps[] = {1, 2, 4, 8, 16, 32};
constexpr int kExplicit[] = {4, 16, 64, 256};  // At 60 fps, below 4 even three bones explode.
constexpr int kHinged[] = {16, 64,
                           256};  // Three bones hold with the first; a hinge is as strong as all that hangs from it.

const ListedSolver kSolvers[] = {
    {"mass-spring", "point masses on stiff springs, integrated explicitly",
     "thesis 3.1 and 5.2, initial attempt; Rosenblum et al. 1991", kSubSteps, kExplicit, sub_stepped<MassSpringSolver>,
     true},
    {"angular-springs", "the mass-spring system, its pose held by springs at the hinges that turn both segments",
     "thesis 3.1, Figure 5; Rosenblum et al. 1991", kSubSteps, kHinged, sub_stepped<AngularSpringSolver>, true},
    {"impulse", "errors of length and collision become impulses, the pose a constant pull",
     "thesis 5.2, replacing the springs", kIterations, kFew, iterated<ImpulseSolver>},
    {"separate", "positions are put right directly and velocities adjusted to match",
     "thesis 5.2, adjusting positions and velocities separately", kIterations, kFew, iterated<SeparateSolver>},
    {"implicit", "the mass-spring system by backward Euler, one linear solve per step",
     "thesis 3.1; Baraff and Witkin 1998", kSubSteps, kFew, sub_stepped<ImplicitSolver>, true},
    {"projective", "rigid sticks, one equation of motion for each of two angles",
     "thesis 3.2; Anjyo, Usami and Kurihara 1992", kSubSteps, kFew, sub_stepped<ProjectiveSolver>, true},
    {"follow-leader", "dynamic follow-the-leader, one pass from root to tip", "Mueller, Kim and Chentanez 2012",
     kSubSteps, kFew, sub_stepped<FollowLeaderSolver>, true},
    {"tridiagonal", "all lengths of a strand by one direct solve per Newton step", "Han and Harada 2013", kIterations,
     kNewton, iterated<TridiagonalSolver>},
    {"xpbd", "extended position-based dynamics with small steps of one iteration", "Macklin et al. 2016 and 2019",
     kSubSteps, kSmallSteps, sub_stepped<XpbdSolver>, true},
};

}  // namespace

std::span<const ListedSolver> historical_solvers() { return kSolvers; }

namespace {

constexpr int kRuntimeEfforts[] = {1, 2, 4, 8};

/// The sample's bones of a solver that moves all.
class SampledSolver final : public lab::ChainSolver {
 public:
  SampledSolver(std::unique_ptr<lab::ChainSolver> whole, std::vector<std::uint32_t> bones)
      : whole_(std::move(whole)), bones_(std::move(bones)), ends_(bones_.size()) {}

  void reset(const HeadPose& head) override { whole_->reset(head); }
  [[nodiscard]] bool set_colliders(std::span<const MovingCollider> colliders) override {
    return whole_->set_colliders(colliders);
  }
  [[nodiscard]] bool set_body(std::span<const BodyPose> bones) override { return whole_->set_body(bones); }
  [[nodiscard]] bool step(const HeadPose& head, double dt) override { return whole_->step(head, dt); }
  [[nodiscard]] bool step_told(const HeadPose& head, const HeadVelocity& velocity, double dt) override {
    return whole_->step_told(head, velocity, dt);
  }
  [[nodiscard]] std::span<const Eigen::Vector3d> bone_ends() const override {
    const auto all = whole_->bone_ends();
    for (std::size_t i = 0; i < bones_.size(); ++i) ends_[i] = all[bones_[i]];
    return ends_;
  }

 private:
  std::unique_ptr<lab::ChainSolver> whole_;
  std::vector<std::uint32_t> bones_;
  mutable std::vector<Eigen::Vector3d> ends_;
};

std::vector<MeasuredSolver> list_solvers() {
  std::vector<MeasuredSolver> all{{"coif", kRuntimeEfforts, &kCoifSolver},
                                  {"cascade", kRuntimeEfforts, &kCascadeSolver, ChainModel::kCascade},
                                  {"passive", kRuntimeEfforts, &kPassiveSolver, ChainModel::kPassive},
                                  {"thesis", kRuntimeEfforts, &kThesisSolver, {}, false}};
  for (const ListedSolver& listed : historical_solvers()) {
    all.push_back({listed.name, listed.efforts, nullptr, {}, listed.has_model});
  }
  return all;
}

}  // namespace

const MeasuredSolver& solver_on_a_character() {
  static constexpr MeasuredSolver kSolver{"coif", kRuntimeEfforts, &kCharacterSolver};
  return kSolver;
}

std::span<const MeasuredSolver> measured_solvers() {
  static const std::vector<MeasuredSolver> kAll = list_solvers();
  return kAll;
}

std::vector<std::string> report_solvers() {
  std::vector<std::string> names;
  for (const MeasuredSolver& solver : measured_solvers()) names.emplace_back(solver.name);
  return names;
}

const MeasuredSolver* find_measured_solver(std::string_view name) {
  const auto found = std::ranges::find(measured_solvers(), name, &MeasuredSolver::name);
  return found == measured_solvers().end() ? nullptr : &*found;
}

tl::expected<std::vector<const MeasuredSolver*>, ToolError> chosen_solvers(const std::vector<std::string>& names) {
  std::vector<const MeasuredSolver*> solvers;
  if (names.empty()) {
    for (const MeasuredSolver& solver : measured_solvers()) {
      if (!solver.model) solvers.push_back(&solver);
    }
  }
  for (const std::string& name : names) {
    solvers.push_back(find_measured_solver(name));
    if (solvers.back() == nullptr) {
      return tl::unexpected(ToolError{ToolError::Kind::kUsage, fmt::format("'{}' is not a solver; there are {}", name,
                                                                           fmt::join(report_solvers(), ", "))});
    }
  }
  return solvers;
}

SolverAtWork make_solver(const MeasuredSolver& measured, const Asset& asset, const lab::RigSample& sample,
                         const lab::SolverScene& scene, int effort) {
  if (measured.is_runtime()) {
    auto whole = std::make_unique<lab::RuntimeSolver>(asset, scene, *measured.runtime, effort);
    return {std::make_unique<SampledSolver>(std::move(whole), sample.bones), asset.skeleton().simulated_count};
  }
  const auto listed = std::ranges::find(historical_solvers(), measured.name, &ListedSolver::name);
  return {listed->create(sample.rig, scene, effort), sample.rig.bones.size()};
}

}  // namespace coif::report
