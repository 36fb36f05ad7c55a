// Springs at the hinges between segments (thesis 3.1, Figure 5): what they do to one bone, and that bones feel what
// hangs from them.

#include "lab/reference_solver.h"
#include "motion/head_path.h"
#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace coif::research::angular_springs_test {

using Eigen::Vector3d;

const lab::SolverScene kWeightless{.gravity = Vector3d::Zero()};

/// Undamped, and pushed once: seconds from one passage through rest to the next but one.
TEST(AngularSprings, OneBoneSwingsAtTheRootOfItsStiffness) {
  lab::Rig rig = pendulum_rig();
  rig.bones[0].damping = 0;
  const auto solver = solver_named("angular-springs").create(rig, kWeightless, 1);
  solver->reset({});
  std::vector<double> passages;
  double before = 0, time = 0;
  const auto nudged = [](double seconds) {
    HeadPose head;
    head.position[0] = seconds < 0.01 ? 0 : 1e-3f;
    return head;
  };
  ASSERT_TRUE(run(*solver, nudged, 1.0 / 10000, 1, [&] {
    time += 1.0 / 10000;
    const double x = solver->bone_ends()[0].x();
    if (x > 0 && before <= 0 && time > 0.02) passages.push_back(time);
    before = x;
  }));
  ASSERT_GE(passages.size(), 2u);
  const double period = (passages.back() - passages.front()) / double(passages.size() - 1);
  EXPECT_NEAR(period, 2 * 3.14159265 / std::sqrt(rig.bones[0].stiffness), 1e-3);
}

/// RMS over tips and frames of two seconds of `motion`, share of the chain's length.
double distance_to(const lab::ReferenceRun& reference, std::string_view name, const lab::Rig& rig,
                   const motion::HeadPath& path) {
  const auto solver = solver_named(name).create(rig, {}, 64);
  solver->reset(path.pose(0));
  double sum = 0, count = 0, now = 0;
  for (std::size_t i = 0; i < reference.times.size(); ++i) {
    EXPECT_TRUE(solver->step(path.pose(reference.times[i]), reference.times[i] - now));
    now = reference.times[i];
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
      const Vector3d off = solver->bone_ends()[rig.tips[tip]] - reference.path_of_tip(tip)[i];
      sum += off.squaredNorm() / (rig.tip_length[tip] * rig.tip_length[tip]);
      count += 1;
    }
  }
  return std::sqrt(sum / count);
}

/// The passive model has the same idea, with lengths that hold and another law of bending.
TEST(AngularSprings, BonesFeelWhatHangsFromThemAsInThePassiveModel) {
  lab::Rig rig = lab::in_model(strand_rig(4), ChainModel::kPassive);
  rig.tips = {3};
  rig.tip_chain = {0};
  rig.tip_length = {0};
  for (const lab::RigBone& bone : rig.bones) rig.tip_length[0] += bone.length;
  lab::ReferenceSettings settings;
  for (int i = 1; i <= 120; ++i) settings.sample_times.push_back(i / 60.0);
  for (const motion::Motion motion : {motion::Motion::kNod, motion::Motion::kTurn}) {
    const auto path = motion::path_of(motion);
    const lab::ReferenceRun reference = lab::solve_reference(rig, {}, *path, settings);
    ASSERT_LT(reference.self_difference_pct(), 0.1);
    const double hinged = distance_to(reference, "angular-springs", rig, *path);
    const double pulled = distance_to(reference, "mass-spring", rig, *path);
    EXPECT_LT(hinged, 0.08);
    EXPECT_LT(hinged, 0.5 * pulled) << "springs that pull on particles alone are further off";
    RecordProperty("hinged", std::to_string(hinged));
    RecordProperty("pulled", std::to_string(pulled));
  }
}

}  // namespace coif::research::angular_springs_test
