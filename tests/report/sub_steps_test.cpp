#include "report/solvers/sub_steps.h"

#include "report/solver_trial.h"
#include "report/solvers/implicit_solver.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

std::unique_ptr<ChainSolver> implicit(const Rig& rig) { return std::make_unique<ImplicitSolver>(rig, SolverScene{}); }

HeadPose moved_to(double x) {
  HeadPose head;
  head.position[0] = x;
  return head;
}

TEST(SubSteps, MoveTheHeadEvenlyInBetween) {
  const Rig rig = forked_rig();
  const auto whole = in_sub_steps(implicit(rig), 4), parts = implicit(rig);
  whole->reset({});
  parts->reset({});
  ASSERT_TRUE(whole->step(moved_to(0.08), 1.0 / 60));
  for (const double x : {0.02, 0.04, 0.06, 0.08}) ASSERT_TRUE(parts->step(moved_to(x), 1.0 / 240));
  EXPECT_LT(worst_distance(whole->bone_ends(), parts->bone_ends()), 1e-12);
}

TEST(SubSteps, TurnTheHeadTheShortWay) {
  const Rig rig = forked_rig();
  const auto near = in_sub_steps(implicit(rig), 4), far = in_sub_steps(implicit(rig), 4);
  HeadPose turned;
  turned.rotation = {0, 0.1f, 0, 0.99498743f};
  near->reset({});
  far->reset({});
  ASSERT_TRUE(near->step(turned, 1.0 / 60));
  turned.rotation = {0, -0.1f, 0, -0.99498743f};  // The same turn.
  ASSERT_TRUE(far->step(turned, 1.0 / 60));
  EXPECT_LT(worst_distance(near->bone_ends(), far->bone_ends()), 1e-9);
}

TEST(SubSteps, BeginFromTheLastHeadThatWasTaken) {
  const Rig rig = forked_rig();
  const auto solver = in_sub_steps(implicit(rig), 2), undisturbed = in_sub_steps(implicit(rig), 2);
  solver->reset({});
  undisturbed->reset({});
  EXPECT_FALSE(solver->step(moved_to(5), 0));
  ASSERT_TRUE(solver->step(moved_to(0.02), 1.0 / 60));
  ASSERT_TRUE(undisturbed->step(moved_to(0.02), 1.0 / 60));
  EXPECT_EQ(worst_distance(solver->bone_ends(), undisturbed->bone_ends()), 0);
}

TEST(SubSteps, OfOneAreTheSolverItself) {
  auto solver = implicit(forked_rig());
  const ChainSolver* itself = solver.get();
  EXPECT_EQ(in_sub_steps(std::move(solver), 1).get(), itself);
}

}  // namespace
}  // namespace coif
