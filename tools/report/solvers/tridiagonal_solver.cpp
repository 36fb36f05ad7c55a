#include "report/solvers/tridiagonal_solver.h"

#include "report/solvers/point_collisions.h"

#include <cmath>
#include <limits>

namespace coif {
namespace {

std::vector<std::vector<std::size_t>> strands_of(const Rig& rig) {
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

TridiagonalSolver::TridiagonalSolver(const Rig& rig, const SolverScene& scene, int iterations)
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

}  // namespace coif
