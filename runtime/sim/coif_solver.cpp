#include "solver.h"

namespace coif {
namespace {

const Solver* solver_of(const Asset& asset) {
  return is_passive(asset.skeleton()) ? &kPassiveSolver : &kCascadeSolver;
}

}  // namespace

const Solver kCoifSolver{.for_asset = &solver_of};

}  // namespace coif
