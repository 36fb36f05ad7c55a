// The reference of linked chains, and how far the runtime's are from it.

#include "lab/reference_solver.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "motion/head_path.h"
#include "sim/linked_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::lab::reference_links_test {
namespace {

using links_test::kModels;
using links_test::Sheet;
using links_test::sheet_rig;

constexpr double kSeconds = 2, kRate = 60;

struct Known {
  explicit Known(const TestRig& rig, motion::Motion motion) : opened(rig.contents()), rig(rig_of(opened.asset())) {
    ReferenceSettings settings;
    for (int i = 1; i <= int(kSeconds * kRate); ++i) settings.sample_times.push_back(i / kRate);
    path = motion::path_of(motion);
    run = solve_reference(this->rig, {}, *path, settings);
  }
  OpenedAsset opened;
  Rig rig;
  std::unique_ptr<motion::HeadPath> path;
  ReferenceRun run;
};

/// RMS of the runtime's tips over the chains' lengths, %.
double error_pct(const Known& known, int substeps) {
  RuntimeSolver solver(known.opened.asset(), {}, kCoifSolver, substeps);
  solver.reset(known.path->pose(0));
  double sum = 0;
  for (std::size_t t = 0; t < known.run.times.size(); ++t) {
    EXPECT_TRUE(solver.step(known.path->pose(known.run.times[t]), 1 / kRate));
    for (std::size_t tip = 0; tip < known.rig.tips.size(); ++tip) {
      const auto& end = solver.bone_ends()[known.rig.tips[tip]];
      sum += (end - known.run.path_of_tip(tip)[t]).squaredNorm() / std::pow(known.rig.tip_length[tip], 2);
    }
  }
  return 100 * std::sqrt(sum / double(known.rig.tips.size() * known.run.times.size()));
}

TEST(ReferenceLinks, AreKeptInTheReferenceToRounding) {
  for (const ChainModel model : kModels) {
    const TestRig sheet = sheet_rig({.model = model, .strands = 4});
    const Rig rig = rig_of(OpenedAsset(sheet.contents()).asset());
    const auto trees = trees_of(rig);
    ASSERT_EQ(trees.size(), 1u) << "all hang together";
    ReferenceTree tree(rig, trees[0], {});
    const auto path = motion::path_of(motion::Motion::kTumble);
    tree.reset(path->at(0));
    std::vector<Eigen::Vector3d> ends(rig.bones.size());
    for (int step = 0; step < 2000; ++step) {
      const double at = step / 1440.0, dt = 1 / 1440.0;
      tree.step({dt, path->at(at), path->at(at + dt / 2), path->at(at + dt)});
      tree.bone_ends(path->at(at + dt).rotation, ends);
      std::vector<Eigen::Vector3d> by_bone(ends.size());
      for (std::size_t i = 0; i < ends.size(); ++i) by_bone[tree.members()[i]] = ends[i];
      for (const RigLink& link : rig.links) {
        const double gap = (by_bone[link.bone] - by_bone[link.to]).norm();
        ASSERT_LT(gap, link.longest * (1 + 1e-6)) << step;
        ASSERT_GT(gap, link.shortest * (1 - 1e-6)) << step;
      }
    }
  }
}

TEST(ReferenceLinks, TheRuntimesConvergeToIt) {
  for (const ChainModel model : kModels) {
    for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kCharge}) {
      Sheet sheet{.model = model, .strands = 3, .stiffness = 400, .damping = 40};
      const Known linked(sheet_rig(sheet), motion);
      ASSERT_LT(linked.run.self_difference_pct(), 0.05) << "the reference agrees with itself";
      const double coarse = error_pct(linked, 1), fine = error_pct(linked, 8);
      EXPECT_LT(coarse, 2.0);
      EXPECT_LT(fine, 0.25);
      EXPECT_LT(fine, 0.5 * coarse);
      TestRig alone = sheet_rig(sheet);
      alone.links.clear();
      EXPECT_LT(coarse, 1.5 * error_pct(Known(alone, motion), 1) + 0.1) << "links cost little of the accuracy";
    }
  }
}

TEST(ReferenceLinks, SoftHairInThePassiveModelConvergesToo) {
  const Known soft(sheet_rig({.model = ChainModel::kPassive}), motion::Motion::kCharge);
  ASSERT_LT(soft.run.self_difference_pct(), 0.05);
  EXPECT_LT(error_pct(soft, 8), 0.3);
}

TEST(ReferenceLinks, ASampleTakesWholeSheets) {
  TestRig rig = sheet_rig({.strands = 3});
  rig.add_strand(4, {.joint = {0, 0.1f, 0}});
  const Rig whole = rig_of(OpenedAsset(rig.contents()).asset());
  EXPECT_EQ(trees_of(whole).size(), 2u);
  const RigSample sample = sample_of(whole, 12);
  EXPECT_EQ(sample.rig.bones.size(), 12u);
  EXPECT_EQ(sample.rig.links.size(), whole.links.size());
}

}  // namespace
}  // namespace coif::lab::reference_links_test
