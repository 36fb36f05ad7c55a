// Each solver comes, with ever finer steps, to the motion of its own model, at its order.

#include "report/accuracy/measure_accuracy.h"

#include "lab/measure_runtime.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace coif::report::own_model_test {

/// One chain whose motion does not depend on the last digit of anything, in a smooth motion of the head.
class OwnModel : public testing::TestWithParam<motion::Motion> {
 protected:
  OwnModel() : opened_(calm_strand(3, 0.3f).contents()), sample_(lab::sample_of(lab::rig_of(opened_.asset()), 8)) {}

  /// Shares of the length, for twice as many steps each time.
  std::vector<double> errors_of(const MeasuredSolver& solver, std::span<const int> efforts) const {
    const auto path = motion::path_of(GetParam());
    const FramePoses frames(*path, 120, 3);
    const lab::ReferenceRun reference = lab::solve_reference(sample_.rig, {}, *path, {.sample_times = frames.times});
    const auto own = own_model_run(solver, sample_.rig, {}, *path, reference);
    if (!own) return {};
    std::vector<double> errors;
    for (const int effort : efforts) {
      const SolverAtWork at_work = make_solver(solver, opened_.asset(), sample_, {}, effort);
      errors.push_back(tip_error(try_motion(*at_work.solver, sample_.rig, frames), frames, sample_.rig, *own).rms);
    }
    return errors;
  }

 private:
  lab::OpenedAsset opened_;
  lab::RigSample sample_;
};

TEST_P(OwnModel, ErrorsOfTheOthersFallAtFirstOrder) {
  for (const research::ListedSolver& listed : research::historical_solvers()) {
    if (!listed.has_model) continue;
    // Explicit springs need so many before they hold at all.
    const int first = listed.name == "mass-spring" || listed.name == "angular-springs" ? 16 : 2;
    const int efforts[] = {first, 2 * first, 4 * first, 8 * first};
    const std::vector<double> errors = errors_of(*find_measured_solver(listed.name), efforts);
    ASSERT_EQ(errors.size(), std::size(efforts));
    for (std::size_t i = 1; i < errors.size(); ++i) {
      EXPECT_LT(errors[i], 0.75 * errors[i - 1]) << listed.name << ", " << efforts[i] << " steps a frame";
    }
    EXPECT_LT(errors.back(), 0.02) << listed.name;
  }
}

TEST_P(OwnModel, ErrorsOfTheRuntimeFallAtSecondOrder) {
  constexpr int kEfforts[] = {1, 2, 4};
  for (const char* name : {"coif", "cascade", "passive"}) {
    const std::vector<double> errors = errors_of(*find_measured_solver(name), kEfforts);
    ASSERT_EQ(errors.size(), std::size(kEfforts));
    EXPECT_LT(errors[1], std::max(0.4 * errors[0], 5e-4)) << name;  // less than which are single precision's
    EXPECT_LT(errors[2], 0.01) << name;
  }
}

TEST_P(OwnModel, IsNoneWhereASettingIsAShareOfAStep) {
  for (const char* name : {"thesis", "impulse", "separate", "tridiagonal"}) {
    EXPECT_TRUE(errors_of(*find_measured_solver(name), {}).empty()) << name;
    EXPECT_FALSE(find_measured_solver(name)->has_model) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Smooth, OwnModel,
                         testing::Values(motion::Motion::kNod, motion::Motion::kTurn, motion::Motion::kRun),
                         [](const auto& motion) {
                           return std::string(motion::all_motions()[std::size_t(motion.param)].name);
                         });

TEST(SubStepsOfOthers, DoNotGoThroughWhatAJumpLeavesOut) {
  const lab::OpenedAsset opened(calm_strand(3, 0.3f).contents());
  const lab::RigSample sample = lab::sample_of(lab::rig_of(opened.asset()), 8);
  for (const research::ListedSolver& listed : research::historical_solvers()) {
    const auto solver = listed.create(sample.rig, {}, 4);
    HeadPose head;
    solver->reset(head);
    for (int i = 0; i < 30; ++i) ASSERT_TRUE(solver->step(head, 1.0 / 60));
    head.position[0] = 10;
    ASSERT_TRUE(solver->step(head, 1.0 / 60));
    double farthest = 0;
    const lab::StaticPose rest = lab::static_pose(sample.rig, {});
    for (std::size_t i = 0; i < rest.ends.size(); ++i) {
      farthest = std::max(farthest, (solver->bone_ends()[i] - rest.ends[i]).norm());
    }
    EXPECT_LT(farthest, 0.15) << listed.name;
  }
}

}  // namespace coif::report::own_model_test
