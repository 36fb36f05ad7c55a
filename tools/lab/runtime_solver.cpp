#include "lab/runtime_solver.h"

#include "base/geometry.h"

#include <new>

namespace coif::lab {

RuntimeSolver::RuntimeSolver(const Asset& asset, const SolverScene& scene, const Solver& solver, int effort)
    : rigid_count_(asset.skeleton().bone_count - asset.skeleton().simulated_count) {
  HairDesc desc;
  desc.solver = &solver;
  desc.moving_colliders = scene.moving_colliders;
  desc.follows_body = scene.follows_body;
  desc.links = links_of(asset, solver);
  const MemoryNeed need = Hair::memory_need(asset, desc);
  memory_ = allocate(need);
  if (!memory_) throw std::bad_alloc();
  // An open asset and its memory are all that create() needs; without them step() refuses.
  (void)hair_.create(asset, desc, {memory_.get(), need.bytes});
  if (&solver == &kThesisSolver) settings_.iterations = std::uint32_t(effort);
  if (&solver != &kThesisSolver) settings_.substeps = std::uint32_t(effort);
  settings_.environment.gravity = to_vec3(scene.gravity);
  settings_.environment.wind = to_vec3(scene.wind);
  ends_.resize(asset.skeleton().simulated_count);
  all_ends_.resize(asset.skeleton().bone_count);
}

void RuntimeSolver::reset(const HeadPose& head) { (void)hair_.reset(0, head); }

bool RuntimeSolver::set_colliders(std::span<const MovingCollider> colliders) {
  if (colliders.empty() && !has_colliders_) return true;  // Most solvers were created without any.
  if (hair_.set_colliders(0, colliders) != Status::kOk) return false;
  has_colliders_ = !colliders.empty();
  return true;
}

bool RuntimeSolver::set_body(std::span<const BodyPose> bones) {
  return bones.empty() || hair_.set_body(0, bones) == Status::kOk;
}

bool RuntimeSolver::step(const HeadPose& head, double dt) {
  settings_.dt = float(dt);
  return hair_.set_head(0, head) == Status::kOk && hair_.step(settings_) == Status::kOk;
}

bool RuntimeSolver::step_told(const HeadPose& head, const HeadVelocity& velocity, double dt) {
  settings_.dt = float(dt);
  return hair_.set_head(0, head, velocity) == Status::kOk && hair_.step(settings_) == Status::kOk;
}

std::span<const Eigen::Vector3d> RuntimeSolver::bone_ends() const {
  (void)hair_.bone_ends(0, all_ends_);
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const Vec3& end = all_ends_[rigid_count_ + i];
    ends_[i] = {double(end.x), double(end.y), double(end.z)};
  }
  return ends_;
}

}  // namespace coif::lab
