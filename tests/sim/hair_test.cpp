// What Hair promises about memory, instances and bad input.

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>

namespace coif::hair_test {

const HeadPose kSomewhere{{0.3, 1.7, -0.2}, turned_about({0, 1, 0}, 0.5)};

/// The asset of a rig, opened.
struct OpenRig {
  explicit OpenRig(const AssetContents& contents) : file(write_asset(contents)) {
    EXPECT_TRUE(asset.open(file.bytes()));
  }
  AlignedBytes file;
  Asset asset;
};

TEST(HairMemory, NeedIsExact) {
  const OpenRig rig(nine_bone_rig().contents());
  for (const std::uint32_t instances : {1u, 2u, 7u}) {
    const HairDesc desc{.instances = instances};
    const MemoryNeed need = Hair::memory_need(rig.asset, desc);
    ASSERT_GT(need.bytes, 0u);
    AlignedBytes enough{std::vector<std::byte>(need.bytes)};
    Hair hair;
    EXPECT_EQ(hair.create(rig.asset, desc, enough.bytes().first(need.bytes - 1)), Status::kMemoryTooSmall);
    EXPECT_EQ(hair.instance_count(), 0u);
    EXPECT_EQ(hair.create(rig.asset, desc, enough.bytes()), Status::kOk);
    EXPECT_EQ(hair.instance_count(), instances);
  }
}

TEST(HairMemory, MisalignedMemoryIsRefused) {
  const OpenRig rig(nine_bone_rig().contents());
  AlignedBytes memory{std::vector<std::byte>(Hair::memory_need(rig.asset, {}).bytes + 64)};
  Hair hair;
  EXPECT_EQ(hair.create(rig.asset, {}, memory.bytes().subspan(16)), Status::kMemoryTooSmall);
}

TEST(HairMemory, RefusedArgumentsNeedNothing) {
  const OpenRig rig(nine_bone_rig().contents());
  EXPECT_EQ(Hair::memory_need(rig.asset, {.instances = 0}).bytes, 0u);
  EXPECT_EQ(Hair::memory_need(rig.asset, {.instances = kMaxInstances + 1}).bytes, 0u);
  EXPECT_EQ(Hair::memory_need(Asset{}, {}).bytes, 0u);
  Hair hair;
  EXPECT_EQ(hair.create(rig.asset, {.instances = 0}, {}), Status::kBadArgument);
  EXPECT_EQ(hair.create(rig.asset, {.solver = nullptr}, {}), Status::kBadArgument);
  for (const std::uint32_t interval : {0u, 3u, 5u, 8u, kNone}) {
    EXPECT_EQ(hair.create(rig.asset, {.longest_interval = interval}, {}), Status::kBadArgument) << interval;
    EXPECT_EQ(Hair::memory_need(rig.asset, {.longest_interval = interval}).bytes, 0u) << interval;
  }
  EXPECT_EQ(hair.create(Asset{}, {}, {}), Status::kAssetLacksData);
}

TEST(HairMemory, FailedCreateLeavesAWorkingHairAlone) {
  TestHair test(nine_bone_rig());
  const auto before = test.ends();
  EXPECT_EQ(test.hair.create(Asset{}, {}, {}), Status::kAssetLacksData);
  EXPECT_EQ(test.hair.step({}), Status::kOk);
  EXPECT_EQ(test.ends().size(), before.size());
}

TEST(Hair, StartsInTheRestPose) {
  const TestRig rig = nine_bone_rig();
  const TestHair test(rig, 3);
  for (std::uint32_t instance = 0; instance < 3; ++instance) {
    EXPECT_LT(largest_distance(test.ends(instance), rig.rest_ends()), 1e-6f);
    ASSERT_EQ(test.hair.palette(instance).size(), 10u);
    EXPECT_LT(distance(transformed(test.hair.palette(instance)[9], {1, 2, 3}), {1, 2, 3}), 1e-5f);
  }
}

TEST(Hair, AssetWithoutSimulatedBonesKeepsIdentityMatrices) {
  TestHair test(TestRig{}, 2);
  ASSERT_EQ(test.hair.bone_count(), 1u);
  ASSERT_EQ(test.hair.set_head(1, kSomewhere), Status::kOk);
  ASSERT_EQ(test.hair.step({}), Status::kOk);
  EXPECT_LT(distance(transformed(test.hair.palette(1)[0], {1, 2, 3}), {1, 2, 3}), 1e-6f);
  Vec3 end{1, 1, 1};
  ASSERT_EQ(test.hair.bone_ends(1, {&end, 1}), Status::kOk);
  EXPECT_EQ(distance(end, {0, 0, 0}), 0.0f);
}

TEST(Hair, ScalpBonesFollowTheHead) {
  AssetContents contents;
  contents.skeleton.head_rotation[3] = 1;
  contents.bones.resize(2);
  for (BoneRecord& bone : contents.bones) bone.parent = bone.chain = bone.name = kNone;
  contents.bones[1].parent = 0;
  contents.bones[1].kind = BoneKind::kScalp;
  contents.bones[1].joint[1] = 0.25f;
  const OpenRig rig(contents);
  AlignedBytes memory{std::vector<std::byte>(Hair::memory_need(rig.asset, {}).bytes)};
  Hair hair;
  ASSERT_EQ(hair.create(rig.asset, {}, memory.bytes()), Status::kOk);
  ASSERT_EQ(hair.set_head(0, kSomewhere), Status::kOk);
  ASSERT_EQ(hair.step({}), Status::kOk);
  Vec3 ends[2];
  ASSERT_EQ(hair.bone_ends(0, ends), Status::kOk);
  EXPECT_EQ(distance(ends[1], {0, 0.25f, 0}), 0.0f);
  EXPECT_EQ(distance(transformed(hair.palette(0)[1], {1, 2, 3}), {1, 2, 3}), 0.0f);
}

TEST(Hair, ResetPutsTheHairToRestAnywhere) {
  const TestRig rig = nine_bone_rig();
  TestHair test(rig);
  StepSettings sideways;
  sideways.environment.gravity = {9.81f, 0, 0};
  for (int i = 0; i < 30; ++i) ASSERT_EQ(test.hair.step(sideways), Status::kOk);
  ASSERT_GT(largest_distance(test.ends(), rig.rest_ends()), 1e-3f);
  ASSERT_EQ(test.hair.reset(0, kSomewhere), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 1e-6f);
  // And it is there without having moved: the first step after it feels no jump.
  StepSettings calm;
  calm.environment.gravity = {};
  ASSERT_EQ(test.hair.step(calm), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 1e-5f);
}

TEST(Hair, InstancesDoNotInfluenceEachOther) {
  constexpr std::uint32_t kCount = 5;
  const auto pose_of = [](std::uint32_t instance, int frame) {
    return HeadPose{{0.02 * frame * instance, 0.01 * frame, 0}, turned_about({1, 0, 0}, instance * std::sin(frame))};
  };
  TestHair crowd(nine_bone_rig(), kCount);
  for (int frame = 1; frame <= 40; ++frame) {
    for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(crowd.hair.set_head(i, pose_of(i, frame)), Status::kOk);
    ASSERT_EQ(crowd.hair.step({}), Status::kOk);
  }
  for (std::uint32_t i = 0; i < kCount; ++i) {
    TestHair alone(nine_bone_rig());
    for (int frame = 1; frame <= 40; ++frame) {
      ASSERT_EQ(alone.hair.set_head(0, pose_of(i, frame)), Status::kOk);
      ASSERT_EQ(alone.hair.step({}), Status::kOk);
    }
    EXPECT_EQ(largest_distance(crowd.ends(i), alone.ends()), 0.0f) << "instance " << i;
  }
}

TEST(Hair, SlightlyLongQuaternionsAreNormalised) {
  TestHair exact(nine_bone_rig()), rough(nine_bone_rig());
  const Quat q = turned_about({0, 1, 0}, 0.3);
  const float s = 1.0009f;
  ASSERT_EQ(exact.hair.reset(0, {{}, q}), Status::kOk);
  ASSERT_EQ(rough.hair.reset(0, {{}, {q.x * s, q.y * s, q.z * s, q.w * s}}), Status::kOk);
  ASSERT_EQ(exact.hair.step({}), Status::kOk);
  ASSERT_EQ(rough.hair.step({}), Status::kOk);
  EXPECT_LT(largest_distance(exact.ends(), rough.ends()), 1e-6f);
}

TEST(Hair, OverflowPutsOneInstanceToRestAndLeavesTheOthers) {
  const TestRig rig = nine_bone_rig();
  TestHair exploding(rig, 2), calm(rig);
  ASSERT_EQ(exploding.hair.step({}), Status::kOk);
  ASSERT_EQ(calm.hair.step({}), Status::kOk);
  ASSERT_EQ(exploding.hair.set_head(0, {{1e200, 0, 0}, {}}), Status::kOk);
  ASSERT_EQ(exploding.hair.step({}), Status::kOk);
  ASSERT_EQ(calm.hair.step({}), Status::kOk);
  EXPECT_LT(largest_distance(exploding.ends(0), rig.rest_ends()), 1e-6f);
  EXPECT_EQ(largest_distance(exploding.ends(1), calm.ends()), 0.0f);
}

TEST(Hair, RecoversFromForcesThatOverflow) {
  const TestRig rig = nine_bone_rig();
  for (const Solver* const solver : {&kThesisSolver, &kPassiveSolver, &kCoifSolver}) {
    TestHair test(rig, {.solver = solver});
    StepSettings violent;
    for (const Environment& violence :
         {Environment{.gravity = {1e38f, 0, 0}}, Environment{.gravity = {}, .wind = {0, -3e38f, 0}}}) {
      violent.environment = violence;
      ASSERT_EQ(test.hair.step(violent), Status::kOk);
      EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 1e-6f);
    }
    ASSERT_EQ(test.hair.step({}), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 0.05f);
  }
}

TEST(Hair, CalmsDownWithinSecondsFromWhatDoesNotOverflow) {
  const TestRig rig = nine_bone_rig();
  for (const float gravity : {1e3f, 1e6f, 1e10f, 1e20f}) {
    TestHair test(rig);
    StepSettings violent;
    violent.environment.gravity = {gravity, 0, 0};
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(test.hair.step(violent), Status::kOk);
      EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 0.61f) << "twice a chain's length";
    }
    for (int i = 0; i < 900; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 0.01f) << gravity;
  }
}

TEST(Hair, ViewsOfABadIndexAreEmpty) {
  const TestHair test(nine_bone_rig());
  EXPECT_TRUE(test.hair.palette(1).empty());
  EXPECT_TRUE(test.hair.palette(kNone).empty());
  EXPECT_TRUE(Hair{}.palette(0).empty());
}

TEST(Hair, BoneEndsAreGivenOnlyWhereThereIsRoomForExactlyAllOfThem) {
  const TestHair test(nine_bone_rig());
  std::vector<Vec3> ends(11, Vec3{7, 7, 7});
  EXPECT_EQ(test.hair.bone_ends(1, std::span(ends).first(10)), Status::kBadIndex);
  EXPECT_EQ(test.hair.bone_ends(0, ends), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.bone_ends(0, std::span(ends).first(9)), Status::kSizeMismatch);
  EXPECT_EQ(Hair{}.bone_ends(0, ends), Status::kNotCreated);
  for (const Vec3& end : ends) EXPECT_EQ(distance(end, {7, 7, 7}), 0.0f);
  EXPECT_EQ(test.hair.bone_ends(0, std::span(ends).first(10)), Status::kOk);
  EXPECT_LT(distance(ends[9], {0.06f, -0.28f, -0.12f}), 1e-6f);
  EXPECT_EQ(distance(ends[10], {7, 7, 7}), 0.0f);
}

/// A hair in motion; every refused call must leave all of its memory as it was.
class HairRejects : public testing::Test {
 protected:
  HairRejects() {
    EXPECT_EQ(test_.hair.set_head(0, kSomewhere), Status::kOk);
    EXPECT_EQ(test_.hair.step({}), Status::kOk);
    before_ = test_.memory_copy();
  }
  void expect_untouched() { EXPECT_EQ(test_.memory_copy(), before_); }

  TestHair test_{nine_bone_rig(), 2};
  std::vector<std::byte> before_;
};

TEST_F(HairRejects, TimeSteps) {
  for (const float dt : {-1.0f / 60, -1e-45f, INFINITY, -INFINITY, NAN}) {
    EXPECT_EQ(test_.hair.step({.dt = dt}), Status::kBadTimeStep) << dt;
  }
  expect_untouched();
}

TEST_F(HairRejects, Poses) {
  const double huge = std::numeric_limits<double>::infinity();
  const HeadPose bad[] = {
      {{NAN, 0, 0}, {}},    {{0, huge, 0}, {}},        {{0, 0, -huge}, {}},
      {{}, {0, 0, 0, 0}},   {{}, {0, 0, 0, 1.002f}},   {{}, {0, 0, 0, 0.998f}},
      {{}, {NAN, 0, 0, 1}}, {{}, {0, INFINITY, 0, 1}}, {{}, {1, 1, 1, 1}},
  };
  for (const HeadPose& pose : bad) {
    EXPECT_EQ(test_.hair.set_head(1, pose), Status::kBadPose);
    EXPECT_EQ(test_.hair.reset(1, pose), Status::kBadPose);
  }
  expect_untouched();
}

TEST_F(HairRejects, SettingsOutOfRange) {
  StepSettings bad[9];
  bad[0].environment.gravity.y = NAN;
  bad[1].environment.gravity.x = INFINITY;
  bad[2].environment.wind.z = -INFINITY;
  bad[3].environment.air_follow = -0.01f;
  bad[4].environment.air_follow = NAN;
  bad[5].iterations = 0;
  bad[6].iterations = kMaxIterations + 1;
  bad[7].substeps = kMaxSubsteps + 1;
  bad[8].environment.true_gravity = 2;
  for (const StepSettings& settings : bad) EXPECT_EQ(test_.hair.step(settings), Status::kBadArgument);
  expect_untouched();
}

TEST_F(HairRejects, Indices) {
  for (const std::uint32_t index : {2u, 3u, kNone}) {
    EXPECT_EQ(test_.hair.set_head(index, kSomewhere), Status::kBadIndex);
    EXPECT_EQ(test_.hair.reset(index, kSomewhere), Status::kBadIndex);
  }
  expect_untouched();
}

TEST(Hair, CallsBeforeCreateAreRefused) {
  Hair hair;
  EXPECT_EQ(hair.set_head(0, {}), Status::kNotCreated);
  EXPECT_EQ(hair.reset(0, {}), Status::kNotCreated);
  EXPECT_EQ(hair.step({}), Status::kNotCreated);
}

TEST(Status, EveryStatusHasItsOwnSentence) {
  std::set<std::string> sentences;
  for (int code = 0; code <= int(Status::kDamagedState); ++code) sentences.insert(describe(Status(code)));
  EXPECT_EQ(sentences.size(), std::size_t(Status::kDamagedState) + 1);
  EXPECT_STREQ(describe(Status(250)), "unknown status");
}

}  // namespace coif::hair_test
