#include "solver.h"

namespace coif {
namespace {

const Solver* solver_of(const Asset& asset) {
  return (asset.skeleton().flags & kSkeletonPassive) != 0 ? &kPassiveSolver : &kCascadeSolver;
}

}  // namespace

const Solver kCoifSolver{.for_asset = &solver_of};

}  // namespace coif
