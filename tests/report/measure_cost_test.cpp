#include "report/cost/measure_cost.h"

#include "report/stability/measure_stability.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace coif::report::measure_cost_test {

/// The simulated part of `asset`, with bones that touch nothing.
AssetContents free_hair(const Asset& asset) {
  AssetContents contents;
  contents.skeleton = asset.skeleton();
  contents.bones.assign(asset.bones().begin(), asset.bones().end());
  for (BoneRecord& bone : contents.bones) bone.colliders = 0;
  contents.chains.assign(asset.chains().begin(), asset.chains().end());
  contents.dynamics.assign(asset.dynamics().begin(), asset.dynamics().end());
  return contents;
}

class CostTest : public testing::Test {
 protected:
  static CostSettings quick() {
    CostSettings settings;
    settings.heads = {1, 10, 100};
    settings.seconds = 0.05;
    return settings;
  }
  static tl::expected<CostReport, ToolError> measure(const Asset& asset, const CostSettings& settings) {
    return measure_cost(asset, settings, nullptr);
  }
  static const FeatureCostRow* feature(const CostReport& report, const std::string& name) {
    const auto found = std::ranges::find(report.features, name, &FeatureCostRow::feature);
    return found == report.features.end() ? nullptr : &*found;
  }

  StressAsset hair_{StressRig{.bones_per_chain = 4}};
};

TEST_F(CostTest, HasOneRowForEverySolverCrowdAndNumberOfSubsteps) {
  const auto report = measure(hair_.asset(), quick());
  ASSERT_TRUE(report) << report.error().message;
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> rows;
  for (const SimulationCostRow& row : report->simulation) {
    EXPECT_TRUE(rows.emplace(row.solver, row.heads, row.substeps).second) << row.solver << " " << row.heads;
    EXPECT_GT(row.us_per_frame, 0);
    EXPECT_GE(row.spread_pct, 0);
    EXPECT_NEAR(row.ns_per_bone_frame, 1e3 * row.us_per_frame / row.heads / 8, 1e-6 * row.ns_per_bone_frame);
  }
  for (const auto solver : crowd_solvers()) {
    for (const std::uint32_t heads : quick().heads) EXPECT_TRUE(rows.contains({std::string(solver), heads, 1}));
    const std::uint32_t compared = report->features.front().heads;
    for (const std::uint32_t substeps : {1u, 2u, 4u, 8u}) {
      EXPECT_TRUE(rows.contains({std::string(solver), compared, substeps})) << solver << " " << substeps;
    }
  }
  EXPECT_TRUE(report->left_out.empty());
  EXPECT_EQ(report->instruction_set, name_of(best_instruction_set()));
}

TEST_F(CostTest, MoreHeadsCostMoreInTotal) {
  const auto report = measure(hair_.asset(), quick());
  ASSERT_TRUE(report);
  for (const SimulationCostRow& few : report->simulation) {
    for (const SimulationCostRow& many : report->simulation) {
      if (few.solver != many.solver || few.substeps != many.substeps || few.heads * 10 > many.heads) continue;
      EXPECT_GT(many.us_per_frame, few.us_per_frame) << many.solver << " " << many.heads;
    }
  }
}

TEST_F(CostTest, BytesAreWhatTheRuntimeAsksTheGameFor) {
  const auto report = measure(hair_.asset(), quick());
  ASSERT_TRUE(report);
  const auto need = [this](std::uint32_t heads) {
    return double(Hair::memory_need(hair_.asset(), {.instances = heads}).bytes);
  };
  for (const SimulationCostRow& row : report->simulation) {
    EXPECT_DOUBLE_EQ(row.bytes_per_head * row.heads, double(row.bytes));
    if (row.solver != "coif") continue;
    EXPECT_EQ(double(row.bytes), need(row.heads));
  }
  // A straight line, but for what is rounded up to whole cache lines.
  const CrowdMemory& memory = report->memory;
  for (const std::uint32_t heads : {256u, 4096u, 65536u}) {
    EXPECT_NEAR(memory.bytes_shared + memory.bytes_per_head * heads, need(heads), 2048) << heads;
  }
}

TEST_F(CostTest, ChunksAndFramingAddUpToTheFile) {
  const auto report = measure(hair_.asset(), quick());
  ASSERT_TRUE(report);
  std::uint64_t sum = report->asset.framing;
  for (const ChunkBytes& chunk : report->asset.chunks) {
    sum += chunk.bytes;
    EXPECT_EQ(chunk.id.size(), 4u);
    EXPECT_FALSE(chunk.what.empty()) << chunk.id;
  }
  EXPECT_EQ(sum, report->asset.total);
  EXPECT_EQ(sum, hair_.asset().total_bytes());
  EXPECT_EQ(report->asset.chunks.size(), hair_.asset().chunks().size());
}

TEST_F(CostTest, FeaturesAreThoseOfTheAsset) {
  const auto report = measure(hair_.asset(), quick());
  ASSERT_TRUE(report);
  ASSERT_NE(feature(*report, "no-colliders"), nullptr);
  EXPECT_EQ(report->features.front().feature, "as-cooked");
  EXPECT_EQ(report->features.front().change_pct, 0);
  EXPECT_EQ(feature(*report, "level-1"), nullptr) << "the asset has one level only";
  for (const FeatureCostRow& row : report->features) {
    EXPECT_GT(row.us_per_frame, 0) << row.feature;
    EXPECT_GT(row.change_pct, -100.001) << row.feature;
    EXPECT_FALSE(row.description.empty()) << row.feature;
  }
  // Both do nothing but hand over poses; anything else steps 100 times as much.
  EXPECT_LT(feature(*report, "asleep")->us_per_frame, feature(*report, "still-awake")->us_per_frame);
  EXPECT_LT(feature(*report, "poses-only")->us_per_frame, feature(*report, "as-cooked")->us_per_frame);
}

TEST_F(CostTest, WhatACharacterBringsAlongHasARowEach) {
  const auto report = measure(hair_.asset(), quick());
  ASSERT_TRUE(report);
  for (const char* name : {"scale", "character", "collider-far", "4-colliders-far", "collider-near", "4-colliders-near",
                           "pose", "half-pose"}) {
    ASSERT_NE(feature(*report, name), nullptr) << name;
    EXPECT_GT(feature(*report, name)->ns_per_bone_frame, 0) << name;
  }
  EXPECT_GT(feature(*report, "4-colliders-near")->us_per_frame, feature(*report, "character")->us_per_frame);
}

TEST_F(CostTest, AlgorithmOneHasNoCharacter) {
  CostSettings settings = quick();
  settings.solvers = {"thesis"};
  const auto report = measure(hair_.asset(), settings);
  ASSERT_TRUE(report);
  EXPECT_EQ(feature(*report, "character"), nullptr);
}

TEST_F(CostTest, HairThatReachesNoColliderHasNoneToLeaveOut) {
  const lab::OpenedAsset free(free_hair(hair_.asset()));
  ASSERT_TRUE(free.asset().is_open());
  const auto report = measure(free.asset(), quick());
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(feature(*report, "no-colliders"), nullptr);
}

TEST_F(CostTest, LeavesOutCrowdsThatTakeTooMuchAndSaysWhy) {
  CostSettings settings = quick();
  settings.heads = {1, 1'000'000};
  settings.solvers = {"coif"};
  const auto report = measure(hair_.asset(), settings);
  ASSERT_TRUE(report) << report.error().message;
  ASSERT_EQ(report->left_out.size(), 1u);
  EXPECT_EQ(report->left_out[0].heads, 1'000'000u);
  EXPECT_EQ(report->left_out[0].what, "coif");
  EXPECT_FALSE(report->left_out[0].why.empty());
  EXPECT_EQ(report->simulation.front().heads, 1u);
  for (const SimulationCostRow& row : report->simulation) EXPECT_EQ(row.solver, "coif");
}

TEST_F(CostTest, RigidHairHasOnlyItsBytes) {
  AssetContents contents;
  contents.skeleton = hair_.asset().skeleton();
  contents.skeleton.simulated_count = 0;
  contents.bones.assign(1, hair_.asset().bones()[0]);
  const lab::OpenedAsset rigid(contents);
  ASSERT_TRUE(rigid.asset().is_open());
  const auto report = measure(rigid.asset(), quick());
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_TRUE(report->simulation.empty());
  EXPECT_TRUE(report->features.empty());
  EXPECT_GT(report->asset.total, 0u);
}

TEST_F(CostTest, RefusesWhatItCannotMeasure) {
  CostSettings unknown = quick(), nobody = quick(), too_many = quick(), no_time = quick();
  unknown.solvers = {"coif", "xpbd"};
  nobody.heads = {0};
  too_many.heads = {kMaxInstances + 1};
  no_time.seconds = 0;
  for (const CostSettings& settings : {unknown, nobody, too_many, no_time}) {
    const auto report = measure(hair_.asset(), settings);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ToolError::Kind::kUsage);
  }
  EXPECT_NE(measure(hair_.asset(), unknown).error().message.find("'xpbd'"), std::string::npos);
}

bool same_bits(std::span<const Mat34> a, std::span<const Mat34> b) {
  return std::ranges::equal(std::as_bytes(a), std::as_bytes(b));
}

TEST_F(CostTest, CrowdsMoveEachHeadInItsOwnWay) {
  auto crowd = HairCrowd::create(hair_.asset(), {.heads = 3});
  ASSERT_TRUE(crowd) << crowd.error().message;
  const std::vector<Mat34> before(crowd->palette(0).begin(), crowd->palette(0).end());
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(crowd->step());
  EXPECT_FALSE(same_bits(crowd->palette(0), before));
  EXPECT_FALSE(same_bits(crowd->palette(0), crowd->palette(1)));
}

TEST_F(CostTest, CrowdsOfStillHeadsSleepUnlessTheyMayNot) {
  for (const bool sleeps : {true, false}) {
    auto crowd = HairCrowd::create(hair_.asset(), {.heads = 2, .heads_move = false, .sleeps = sleeps});
    ASSERT_TRUE(crowd) << crowd.error().message;
    const std::vector<Mat34> before(crowd->palette(0).begin(), crowd->palette(0).end());
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(crowd->step());
    EXPECT_EQ(same_bits(crowd->palette(0), before), sleeps);
  }
}

TEST_F(CostTest, CrowdsTakeTheSubstepsThatTheRuntimeWouldTake) {
  for (const float rate : {0.0f, 60.0f, 61.0f, 240.0f}) {
    AssetContents contents = free_hair(hair_.asset());
    TuningRecord tuning{};
    tuning.substep_rate = rate;
    tuning.slowest_rate = 30;
    tuning.fastest_rate = 120;
    contents.tuning.push_back(tuning);
    const lab::OpenedAsset tuned(contents);
    ASSERT_TRUE(tuned.asset().is_open());
    auto asked = HairCrowd::create(tuned.asset(), {.substeps = 0});  // the runtime's own choice
    auto told = HairCrowd::create(tuned.asset(), {.substeps = tuned_substeps(tuned.asset(), float(1 / kCrowdRate))});
    auto more =
        HairCrowd::create(tuned.asset(), {.substeps = tuned_substeps(tuned.asset(), float(1 / kCrowdRate)) + 1});
    ASSERT_TRUE(asked && told && more);
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(asked->step() && told->step() && more->step());
    EXPECT_TRUE(same_bits(asked->palette(0), told->palette(0))) << rate;
    EXPECT_FALSE(same_bits(asked->palette(0), more->palette(0))) << rate;
  }
}

}  // namespace coif::report::measure_cost_test
