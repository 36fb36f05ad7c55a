#pragma once

#include "report/chain_solver.h"

namespace coif {

/// `solver` run `count` times per step, each time for an equal share of it, the head moving evenly in between. With a
/// count of 1 (or less) it is `solver` itself.
[[nodiscard]] std::unique_ptr<ChainSolver> in_sub_steps(std::unique_ptr<ChainSolver> solver, int count);

}  // namespace coif
