#include "report/solvers/measured_solvers.h"

#include "lab/runtime_solver.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace coif::report {
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
  for (const research::ListedSolver& listed : research::historical_solvers()) {
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
  const auto listed = std::ranges::find(research::historical_solvers(), measured.name, &research::ListedSolver::name);
  return {listed->create(sample.rig, scene, effort), sample.rig.bones.size()};
}

}  // namespace coif::report
