// Chains that hang together (runtime/docs/MODEL.md, "Links").

#include "sim/linked_sheet.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif::links_test {
namespace {

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

/// What a host does with a crowd in a violent play; the ends of the last head in every frame.
std::vector<Vec3> played(const TestRig& rig, const HairDesc& desc, double fps = 60, std::uint32_t substeps = 1) {
  TestHair test(rig, desc);
  Violence violence(3);
  StepSettings settings = at_rate(fps);
  settings.substeps = substeps;
  std::vector<Vec3> all;
  for (int frame = 0; frame < 60; ++frame) {
    const HeadPose pose = frame % 3 == 0 ? violence.next() : wander(frame / fps);
    for (std::uint32_t i = 0; i < desc.instances; ++i) EXPECT_EQ(test.hair.set_head(i, pose), Status::kOk);
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    const auto ends = test.ends(desc.instances - 1);
    all.insert(all.end(), ends.begin(), ends.end());
  }
  return all;
}

/// The worst link of any frame.
double worst_of(const TestRig& rig, const std::vector<Vec3>& all) {
  const std::size_t bones = rig.simulated_count();
  double worst = 0;
  for (std::size_t first = 0; first < all.size(); first += bones) {
    const std::vector<Vec3> ends(all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(first + bones));
    const double excess = worst_excess(rig, ends);
    if (!(excess <= worst)) worst = excess;
  }
  return worst;
}

TEST(Links, KeepTheirLengthsInAllMotionsAtAllRates) {
  for (const ChainModel model : kModels) {
    for (const int strands : {2, 5, 15}) {
      for (const double fps : {12.0, 30.0, 60.0, 144.0}) {
        const TestRig rig = sheet_rig({.model = model, .strands = strands, .twists = model == ChainModel::kCascade});
        for (const std::uint32_t substeps : {1u, 3u}) {
          EXPECT_LT(worst_of(rig, played(rig, {.links = &kLinks}, fps, substeps)), 1e-5) << strands << " at " << fps;
        }
        EXPECT_GT(worst_of(rig, played(rig, {}, fps)), 0.1) << "or this would show nothing";
      }
    }
  }
}

TEST(Links, ThatAreNotAskedForChangeNoBit) {
  for (const ChainModel model : kModels) {
    TestRig rig = sheet_rig({.model = model});
    const auto with = played(rig, {}), with_many = played(rig, {.instances = 20});
    const MemoryNeed need = TestHair(rig).hair.memory_need(TestHair(rig).asset, {});
    rig.links.clear();
    EXPECT_TRUE(same_bits(with, played(rig, {})));
    EXPECT_TRUE(same_bits(with_many, played(rig, {.instances = 20})));
    EXPECT_TRUE(same_bits(with, played(rig, {.links = &kLinks}))) << "nor those that are not there";
    EXPECT_EQ(need.bytes, TestHair(rig).hair.memory_need(TestHair(rig).asset, {}).bytes);
  }
}

TEST(Links, MoveHairAlikeUnderEveryInstructionSetAndInEveryCrowd) {
  for (const ChainModel model : kModels) {
    const TestRig rig = sheet_rig({.model = model, .strands = 4, .twists = model == ChainModel::kCascade});
    const auto alone = played(rig, {.instruction_set = plainest_set(), .links = &kLinks});
    for (const InstructionSet set : runnable_sets()) {
      for (const std::uint32_t instances : {1u, 3u, 16u, 35u}) {
        EXPECT_TRUE(same_bits(alone, played(rig, {.instances = instances, .instruction_set = set, .links = &kLinks})));
      }
    }
  }
}

TEST(Links, OnACharacterThatNothingHappensToAreTheSame) {
  for (const ChainModel model : kModels) {
    const TestRig rig = sheet_rig({.model = model});
    const auto plain = played(rig, {.links = &kLinks});
    EXPECT_TRUE(
        same_bits(plain, played(rig, {.solver = &kCharacterSolver, .links = &kCharacterLinks, .moving_colliders = 2})));
  }
}

TEST(Links, StretchNoBone) {
  for (const ChainModel model : kModels) {
    const TestRig rig = sheet_rig({.model = model});
    const auto all = played(rig, {.links = &kLinks}, 30);
    const std::size_t bones = rig.simulated_count();
    for (std::size_t first = 0; first < all.size(); first += bones) {
      for (std::size_t i = 0; i < bones; ++i) {
        const BoneRecord& bone = rig.bones[i + 1];
        const Vec3 joint{bone.joint[0], bone.joint[1], bone.joint[2]};
        const Vec3 start = bone.parent == 0 ? joint : all[first + bone.parent - 1];
        EXPECT_NEAR(distance(all[first + i], start), bone.length, 1e-6f);
      }
    }
  }
}

TEST(Links, OfHairAtRestLetItRestAndSleep) {
  for (const ChainModel model : kModels) {
    TestRig rig = sheet_rig({.model = model, .stiffness = 200, .damping = 12});
    for (const bool is_pulled : {false, true}) {
      // Shorter than the hair hangs: then links hold it for ever.
      if (is_pulled) {
        for (LinkRecord& link : rig.links) link.longest *= 0.9f;
      }
      TestHair test(rig, {.links = &kLinks});
      int frame = 0;
      for (; frame < 1800 && !test.hair.is_asleep(0); ++frame) ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      EXPECT_TRUE(test.hair.is_asleep(0)) << is_pulled;
      EXPECT_LT(worst_excess(rig, test.ends()), 1e-5);
    }
  }
}

TEST(Links, TakeNeighboursAlong) {
  // One strand is blown aside; the other feels no air.
  for (const ChainModel model : kModels) {
    TestRig rig;
    rig.model = model;
    for (const float side : {0.0f, 0.03f}) {
      TestBone bone{.joint = {side, 0, 0}, .length = 0.05f, .stiffness = 30, .damping = 5, .torsion = kShortestArc};
      bone.friction = side > 0 ? 20.0f : 0.0f;
      rig.add_strand(3, bone);
    }
    for (std::uint32_t depth = 0; depth < 3; ++depth) rig.link(4 + depth, 1 + depth);
    const auto blown = [&](const LinkCode* links) {
      TestHair test(rig, {.links = links});
      StepSettings settings = at_rate(60);
      settings.environment.wind = {3, 0, 0};
      for (int frame = 0; frame < 120; ++frame) EXPECT_EQ(test.hair.step(settings), Status::kOk);
      return test.ends();
    };
    const auto apart = blown(nullptr), together = blown(&kLinks);
    EXPECT_NEAR(apart[2].x, 0, 1e-3f);
    EXPECT_GT(together[2].x, 0.01f);
    EXPECT_LT(together[5].x, apart[5].x) << "and are held back by them";
  }
}

TEST(Links, OfBonesThatTouchLeaveThemOutOfTheHead) {
  for (const ChainModel model : kModels) {
    TestRig rig = sheet_rig({.model = model});
    rig.add_sphere({0, 0, 0}, 0.11f);
    rig.add_capsule({-0.2f, -0.15f, -0.1f}, {0.2f, -0.15f, -0.1f}, 0.05f);
    const auto all = played(rig, {.links = &kLinks});
    for (const Vec3& end : all) {
      EXPECT_GT(std::hypot(end.x, end.y, end.z), 0.11f * (1 - 1e-4f));
      const float x = std::clamp(end.x, -0.2f, 0.2f);
      EXPECT_GT(std::hypot(end.x - x, end.y + 0.15f, end.z + 0.1f), 0.05f * (1 - 1e-4f));
    }
    EXPECT_LT(worst_of(rig, all), 0.15) << "where a collider stands between, the collider comes first";
  }
}

TEST(Links, StayOutOfAHand) {
  for (const ChainModel model : kModels) {
    const TestRig rig = sheet_rig({.model = model});
    TestHair test(rig, {.solver = &kCharacterSolver, .links = &kCharacterLinks, .moving_colliders = 1});
    for (int frame = 0; frame < 240; ++frame) {
      MovingCollider hand{.shape = ColliderShape::kSphere, .center = {0.25 * std::sin(frame * 0.11), -0.05, -0.19}};
      hand.radius = 0.04f;
      ASSERT_EQ(test.hair.set_colliders(0, std::span(&hand, 1)), Status::kOk);
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      for (const Vec3& end : test.ends()) {
        const float away = float(
            std::hypot(double(end.x) - hand.center[0], double(end.y) - hand.center[1], double(end.z) - hand.center[2]));
        EXPECT_GT(away, 0.04f * (1 - 1e-4f)) << frame;
      }
    }
  }
}

TEST(Links, OfBonesThatLevelsOfDetailHoldComeToThem) {
  for (const ChainModel model : kModels) {
    TestRig rig = sheet_rig({.model = model, .strands = 3});
    rig.levels.assign(rig.bones.size(), 1);
    rig.levels[0] = 0;
    for (std::size_t bone = 1; bone <= 4; ++bone) rig.levels[bone] = 2;  // the first strand's alone move in both
    TestHair test(rig, {.links = &kLinks});
    Violence violence(5);
    for (int frame = 0; frame < 60; ++frame) {
      ASSERT_EQ(test.hair.set_detail(0, {.level = 1}), Status::kOk);
      ASSERT_EQ(test.hair.set_head(0, frame % 3 == 0 ? violence.next() : wander(frame / 60.0)), Status::kOk);
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      const auto ends = test.ends(), rest = rig.rest_ends();
      for (std::size_t i = 4; i < ends.size(); ++i) EXPECT_LT(distance(ends[i], rest[i]), 1e-5f) << "rigid";
      EXPECT_LT(worst_excess(rig, ends), 1e-4);
    }
  }
}

TEST(Links, HoldTheLongestChainsThatTheFormatHas) {
  TestRig rig;
  constexpr int kLong = 2047;  // two of them and the head are all the bones of an asset
  for (const float side : {0.0f, 0.03f}) {
    rig.add_strand(kLong,
                   {.joint = {side, 0, 0}, .length = 0.001f, .stiffness = 400, .damping = 60, .torsion = kShortestArc});
  }
  for (std::uint32_t depth = 0; depth < kLong; ++depth) rig.link(1 + kLong + depth, 1 + depth);
  TestHair test(rig, {.links = &kLinks});
  for (int frame = 0; frame < 3; ++frame) {
    ASSERT_EQ(test.hair.set_head(0, wander(frame / 60.0)), Status::kOk);
    ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
    EXPECT_LT(worst_excess(rig, test.ends()), 1e-4);
  }
}

TEST(Links, GoOnFromASavedStateToTheBit) {
  for (const ChainModel model : kModels) {
    const TestRig rig = sheet_rig({.model = model});
    TestHair test(rig, {.instances = 2, .links = &kLinks});
    const auto go_on = [&](int from) {
      for (int frame = from; frame < from + 30; ++frame) {
        for (const std::uint32_t i : {0u, 1u}) EXPECT_EQ(test.hair.set_head(i, wander(frame / 60.0)), Status::kOk);
        EXPECT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      }
      return test.ends(1);
    };
    (void)go_on(0);
    std::vector<std::byte> state(test.hair.saved_bytes());
    ASSERT_EQ(test.hair.save(state), Status::kOk);
    const auto once = go_on(30);
    (void)go_on(90);
    ASSERT_EQ(test.hair.restore(state), Status::kOk);
    EXPECT_TRUE(same_bits(once, go_on(30)));
  }
}

TEST(Links, AreRefusedWhereTheSolverCannotKeepThem) {
  const TestRig rig = sheet_rig();
  TestHair test(rig);
  const auto refuses = [&](const Solver& solver, const LinkCode& links) {
    Hair hair;
    const HairDesc desc{.solver = &solver, .links = &links};
    return Hair::memory_need(test.asset, desc).bytes == 0 && hair.create(test.asset, desc, {}) == Status::kBadArgument;
  };
  EXPECT_TRUE(refuses(kThesisSolver, kLinks));
  EXPECT_TRUE(refuses(kCharacterSolver, kLinks)) << "its colliders and poses would be left out";
  EXPECT_TRUE(refuses(kCoifSolver, kCharacterLinks));
  EXPECT_FALSE(refuses(kCoifSolver, kLinks));
  EXPECT_FALSE(refuses(kCascadeSolver, kLinks));
  EXPECT_FALSE(refuses(kPassiveSolver, kLinks));
  EXPECT_FALSE(refuses(kCharacterCascadeSolver, kCharacterLinks));
}

}  // namespace
}  // namespace coif::links_test
