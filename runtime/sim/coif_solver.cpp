#include "solver.h"

namespace coif {
namespace {

const Solver* solver_of(ChainModel model) { return model == ChainModel::kPassive ? &kPassiveSolver : &kCascadeSolver; }

}  // namespace

const Solver kCoifSolver{.for_model = &solver_of};

}  // namespace coif
