#include "research/solvers/historical_solvers.h"
#include "research/solvers/particle_solver.h"

#include <cmath>
#include <limits>

namespace coif::research {

using Eigen::Vector3d;

FollowLeaderSolver::FollowLeaderSolver(const lab::Rig& rig, const lab::SolverScene& scene)
    : PosedSolver(rig, scene), given_back_(rig.bones.size()), corrections_(rig.bones.size()) {
  // The paper's s_damping: 1 gives back all that was taken and is not stable, 0 is plain follow-the-leader.
  constexpr double kGivenBack = 0.9;
  std::vector<int> children(bone_count());
  for (std::size_t i = 0; i < bone_count(); ++i) {
    if (!hangs_from_head(i)) ++children[parent(i)];
  }
  for (std::size_t i = 0; i < bone_count(); ++i) {
    if (!hangs_from_head(i)) given_back_[i] = kGivenBack / children[parent(i)];
  }
}

void FollowLeaderSolver::advance(const ParticleStep& step) {
  before_ = positions_;
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += falling_velocity(i, step) * step.dt;
  renew_default_pose(step);
  for (std::size_t i = 0; i < bone_count(); ++i) follow(i, step);
  renew_velocities(step);
}

void FollowLeaderSolver::follow(std::size_t i, const ParticleStep& step) {
  const Vector3d leader = start(i, step);
  // The leader's real motion: its velocity also contains the part given back, which at rest is not zero.
  const Vector3d leader_velocity =
      hangs_from_head(i) ? step.head_velocity_at(leader) : Vector3d((leader - before_[parent(i)]) / step.dt);
  const Vector3d foreseen =
      positions_[i] + pull(i, positions_[i] - before_[i], leader_velocity + swing_velocity(i), step);
  positions_[i] = clear_of_colliders_at_length(rig(), i, step.head_rotation, leader, foreseen);
  corrections_[i] = positions_[i] - foreseen;
}

void FollowLeaderSolver::renew_velocities(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = (positions_[i] - before_[i]) / step.dt;
  for (std::size_t i = 0; i < bone_count(); ++i) {
    if (!hangs_from_head(i)) velocities_[parent(i)] -= corrections_[i] * (given_back_[i] / step.dt);
  }
}

namespace {

std::vector<std::vector<std::size_t>> strands_of(const lab::Rig& rig) {
  constexpr auto kNoStrand = std::numeric_limits<std::size_t>::max();
  std::vector<std::vector<std::size_t>> strands;
  std::vector<std::size_t> ending_at(rig.bones.size(), kNoStrand);
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const int parent = rig.bones[i].parent;
    std::size_t strand = parent < 0 ? kNoStrand : ending_at[std::size_t(parent)];
    if (strand == kNoStrand) {
      strand = strands.size();
      strands.emplace_back();
    } else {
      ending_at[std::size_t(parent)] = kNoStrand;
    }
    strands[strand].push_back(i);
    ending_at[i] = strand;
  }
  return strands;
}

}  // namespace

using Eigen::Vector3d;

TridiagonalSolver::TridiagonalSolver(const lab::Rig& rig, const lab::SolverScene& scene, int iterations)
    : ParticleSolver(rig, scene), iterations_(iterations), strands_(strands_of(rig)) {}

void TridiagonalSolver::advance(const ParticleStep& step) {
  before_ = positions_;
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += falling_velocity(i, step) * step.dt;
  pull_to_default(step);
  pulled_ = positions_;
  for (const Strand& strand : strands_) keep_lengths(strand, step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    positions_[i] = clear_of_colliders(rig(), i, step.head_rotation, positions_[i]);
    velocities_[i] = (positions_[i] - before_[i]) / step.dt;
  }
}

void TridiagonalSolver::pull_to_default(const ParticleStep& step) {
  const std::vector<Vector3d> directions = shared_directions(step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d off = start(i, step) + directions[i] * bone(i).length - positions_[i];
    positions_[i] += off * bone(i).resistance;
  }
}

void TridiagonalSolver::keep_lengths(const Strand& strand, const ParticleStep& step) {
  constexpr double kFailed = 0.1;  // Share of the length.
  for (int i = 0; i < iterations_; ++i) newton(strand, step);
  if (!(worst_error(strand, step) <= kFailed)) follow(strand, step);
}

void TridiagonalSolver::newton(const Strand& strand, const ParticleStep& step) {
  const std::size_t count = strand.size();
  directions_.resize(count);
  diagonal_.resize(count);
  coupling_.resize(count);
  push_.resize(count);
  for (std::size_t row = 0; row < count; ++row) {
    const Vector3d along = positions_[strand[row]] - start(strand[row], step);
    directions_[row] = along.normalized();
    push_[row] = along.norm() - bone(strand[row]).length;
    diagonal_[row] = row == 0 ? 1 : 2;  // Ends that may move; the strand's root may not.
    if (row == 0) continue;
    coupling_[row] = -directions_[row].dot(directions_[row - 1]);
    const double factor = coupling_[row] / diagonal_[row - 1];
    diagonal_[row] -= factor * coupling_[row];
    push_[row] -= factor * push_[row - 1];
  }
  for (std::size_t row = count; row-- > 0;) {
    if (row + 1 < count) push_[row] -= coupling_[row + 1] * push_[row + 1];
    push_[row] /= diagonal_[row];
  }
  for (std::size_t row = 0; row < count; ++row) {
    positions_[strand[row]] -= directions_[row] * push_[row];
    if (row > 0) positions_[strand[row - 1]] += directions_[row] * push_[row];
  }
}

void TridiagonalSolver::follow(const Strand& strand, const ParticleStep& step) {
  for (const std::size_t i : strand) {
    const Vector3d leader = start(i, step);
    positions_[i] = leader + (pulled_[i] - leader).normalized() * bone(i).length;
  }
}

double TridiagonalSolver::worst_error(const Strand& strand, const ParticleStep& step) const {
  double worst = 0;
  for (const std::size_t i : strand) {
    const double error = std::abs((positions_[i] - start(i, step)).norm() / bone(i).length - 1);
    if (!(error <= worst)) worst = error;  // Lets NaN in, and keeps it: nothing compares above it.
    if (std::isnan(worst)) break;
  }
  return worst;
}

using Eigen::Vector3d;

void XpbdSolver::advance(const ParticleStep& step) {
  before_ = positions_;
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += falling_velocity(i, step) * step.dt;
  renew_default_pose(step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    keep_pose(i, step);
    keep_length(i, step);
  }
  for (std::size_t i = 0; i < bone_count(); ++i) {
    positions_[i] = clear_of_colliders(rig(), i, step.head_rotation, positions_[i]);
  }
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = (positions_[i] - before_[i]) / step.dt;
}

void XpbdSolver::keep_pose(std::size_t i, const ParticleStep& step) {
  const Vector3d start_velocity = hangs_from_head(i) ? step.head_velocity_at(start(i, step))
                                                     : Vector3d((positions_[parent(i)] - before_[parent(i)]) / step.dt);
  positions_[i] += pull(i, positions_[i] - before_[i], start_velocity + swing_velocity(i), step);
}

void XpbdSolver::keep_length(std::size_t i, const ParticleStep& step) {
  const Vector3d along = positions_[i] - start(i, step);
  const Vector3d error = along.normalized() * (along.norm() - bone(i).length);
  if (hangs_from_head(i)) {
    positions_[i] -= error;
  } else {
    positions_[i] -= error * 0.5;
    positions_[parent(i)] += error * 0.5;
  }
}

}  // namespace coif::research
