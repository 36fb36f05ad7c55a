// What every listed solver promises, whatever its method.

#include "report/solver_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace coif {
namespace {

using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Vector3d> ends_of(const ChainSolver& solver) {
  return {solver.bone_ends().begin(), solver.bone_ends().end()};
}

bool all_finite(std::span<const Vector3d> ends) {
  for (const Vector3d& end : ends) {
    if (!end.allFinite()) return false;
  }
  return true;
}

class EverySolver : public testing::TestWithParam<ListedSolver> {
 protected:
  [[nodiscard]] std::unique_ptr<ChainSolver> create(const Rig& rig) const {
    return GetParam().create(rig, {}, GetParam().efforts.back());
  }
};

INSTANTIATE_TEST_SUITE_P(Listed, EverySolver, testing::ValuesIn(historical_solvers()),
                         [](const auto& tested) { return test_name(tested.param.name); });

TEST_P(EverySolver, IsListedWithAllThatAReportShows) {
  const ListedSolver& listed = GetParam();
  EXPECT_FALSE(listed.description.empty());
  EXPECT_EQ(listed.description.find('\n'), std::string_view::npos);
  EXPECT_FALSE(listed.source.empty());
  EXPECT_FALSE(listed.effort_unit.empty());
  ASSERT_FALSE(listed.efforts.empty());
  EXPECT_GT(listed.efforts.front(), 0);
  for (std::size_t i = 1; i < listed.efforts.size(); ++i) EXPECT_LT(listed.efforts[i - 1], listed.efforts[i]);
}

TEST(HistoricalSolvers, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const ListedSolver& listed : historical_solvers()) EXPECT_TRUE(names.insert(listed.name).second) << listed.name;
  EXPECT_EQ(names.size(), 8u);
}

TEST_P(EverySolver, StartsFromTheRestPoseOfATurnedHead) {
  const Rig rig = forked_rig();
  const auto solver = create(rig);
  solver->reset(walking(0.4));
  const auto ends = solver->bone_ends();
  ASSERT_EQ(ends.size(), rig.bones.size());
  EXPECT_LT((ends[0] - rig.bones[0].rest_direction * rig.bones[0].length).norm(), 1e-6);
  EXPECT_LT(worst_stretch(rig, ends), 1e-12);
}

TEST_P(EverySolver, RefusesWhatIsNoStepAndStaysAsItWas) {
  const auto solver = create(forked_rig());
  solver->reset({});
  ASSERT_TRUE(run(*solver, walking, 1.0 / 120, 0.25));
  const auto before = ends_of(*solver);
  HeadPose nowhere = walking(0.26), unturned = walking(0.26);
  nowhere.position[1] = kNaN;
  unturned.rotation.w = float(kNaN);
  for (const double dt : {0.0, -1.0 / 60, kNaN, kInfinity}) EXPECT_FALSE(solver->step(walking(0.26), dt)) << dt;
  EXPECT_FALSE(solver->step(nowhere, 1.0 / 60));
  EXPECT_FALSE(solver->step(unturned, 1.0 / 60));
  EXPECT_EQ(ends_of(*solver), before);

  const auto undisturbed = create(forked_rig());
  undisturbed->reset({});
  ASSERT_TRUE(run(*undisturbed, walking, 1.0 / 120, 0.25));
  ASSERT_TRUE(solver->step(walking(0.26), 1.0 / 120));
  ASSERT_TRUE(undisturbed->step(walking(0.26), 1.0 / 120));
  EXPECT_EQ(ends_of(*solver), ends_of(*undisturbed)) << "what bone_ends() does not show has changed";
}

TEST_P(EverySolver, RefusesToBeginWithoutReset) { EXPECT_FALSE(create(forked_rig())->step({}, 1.0 / 60)); }

TEST_P(EverySolver, GivesTheSameTwiceAndAfterReset) {
  const auto first = create(forked_rig()), second = create(forked_rig());
  for (ChainSolver* solver : {first.get(), second.get()}) {
    solver->reset({});
    ASSERT_TRUE(run(*solver, walking, 1.0 / 60, 0.5));
  }
  EXPECT_EQ(ends_of(*first), ends_of(*second));
  second->reset({});
  ASSERT_TRUE(run(*second, walking, 1.0 / 60, 0.5));
  EXPECT_EQ(ends_of(*first), ends_of(*second));
}

TEST_P(EverySolver, MovesAMirroredRigMirrored) {
  const auto solver = create(forked_rig()), other = create(mirrored(forked_rig()));
  solver->reset({});
  other->reset({});
  double moved = 0;
  for (int i = 1; i <= 90; ++i) {
    const HeadPose head = walking(i / 60.0);
    ASSERT_TRUE(solver->step(head, 1.0 / 60));
    ASSERT_TRUE(other->step(mirrored(head), 1.0 / 60));
    std::vector<Vector3d> mirror = ends_of(*other);
    for (Vector3d& end : mirror) end.x() = -end.x();
    ASSERT_LT(worst_distance(solver->bone_ends(), mirror), 1e-9) << "step " << i;
    moved = std::max(moved, std::abs(solver->bone_ends()[3].x()));
  }
  EXPECT_GT(moved, 0.002);
}

/// A head that moves evenly moves nothing, wherever it is: only the air could tell, and it goes along.
TEST_P(EverySolver, DoesNotSeeThatTheHeadMovesEvenly) {
  const auto resting = create(forked_rig()), riding = create(forked_rig());
  const HeadMotion ride = [](double seconds) {
    HeadPose head;
    // Up to speed without a jolt, so that what is left of it has died down when the comparison is made.
    head.position[2] = 8 * (seconds - (1 - std::exp(-4 * seconds)) / 4);
    return head;
  };
  resting->reset({});
  riding->reset({});
  ASSERT_TRUE(run(*resting, still, 1.0 / 120, 6));
  ASSERT_TRUE(run(*riding, ride, 1.0 / 120, 6));
  EXPECT_LT(worst_distance(resting->bone_ends(), riding->bone_ends()), 1e-6);
}

TEST_P(EverySolver, SurvivesWhatItCannotSolveAndCanBeReset) {
  Rig rig = forked_rig();
  rig.bones[2].stiffness = rig.bones[2].damping = rig.bones[2].resistance = 0;
  rig.bones[3].resistance = 1;
  rig.bones[4].friction = 1e6;
  rig.bones[5].rest_direction = -rig.bones[4].rest_direction;
  rig.colliders = {sphere({0, 0, 0}, 0.1), sphere({0, 0.05, 0}, 0.1)};
  for (RigBone& bone : rig.bones) bone.colliders = 0xffu;
  const auto solver = create(rig);
  solver->reset({});
  HeadPose far;
  far.position[0] = 1e7;
  for (const double dt : {10.0, 1e-9, 0.1, 1.0 / 60}) {
    for (int i = 0; i < 20; ++i) static_cast<void>(solver->step(i % 2 == 0 ? far : HeadPose{}, dt));
    EXPECT_EQ(solver->bone_ends().size(), rig.bones.size());
  }
  solver->reset({});
  EXPECT_TRUE(all_finite(solver->bone_ends()));
  ASSERT_TRUE(run(*solver, still, 1.0 / 240, 0.1));
  EXPECT_TRUE(all_finite(solver->bone_ends()));
}

}  // namespace
}  // namespace coif
