// What links do to single bones: on a character, at rest, and against something that is in their way.

#include "sim/linked_sheet.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif::links_alone_test {
namespace {

using links_test::at_rate;
using links_test::kModels;
using links_test::worst_excess;

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

StepSettings weightless() {
  StepSettings settings = at_rate(60);
  settings.environment.gravity = {};
  return settings;
}

/// Two strands that hang side by side, each bone linked to its neighbour.
TestRig pair(ChainModel model, float gap, int bones, float stretch, float shrink) {
  TestRig rig;
  rig.model = model;
  for (const float side : {0.0f, gap}) {
    rig.add_strand(bones,
                   {.joint = {side, 0, 0}, .length = 0.125f, .stiffness = 60, .damping = 8, .torsion = kShortestArc});
  }
  const auto count = std::uint32_t(bones);
  for (std::uint32_t depth = 0; depth < count; ++depth) rig.link(1 + count + depth, 1 + depth, stretch, shrink);
  return rig;
}

/// Neither the longest nor the shortest length is beyond them.
TEST(LinksAlone, OfTheVeryLengthThatTheyHaveDoNothing) {
  for (const ChainModel model : kModels) {
    for (const float longest : {0.0f, 0.1f}) {
      for (const float shortest : {0.0f, 0.5f}) {
        const TestRig rig = pair(model, 0.25f, 2, longest, shortest);
        TestHair linked(rig, {.links = &kLinks}), free(rig);
        for (int frame = 0; frame < 20; ++frame) {
          ASSERT_EQ(linked.hair.step(weightless()), Status::kOk);
          ASSERT_EQ(free.hair.step(weightless()), Status::kOk);
        }
        EXPECT_TRUE(same_bits(linked.ends(), free.ends())) << longest << ' ' << shortest;
        EXPECT_TRUE(same_bits(linked.ends(), rig.rest_ends())) << "nothing moves it";
      }
    }
  }
}

TEST(LinksAlone, LeaveBonesWhereAnAnimationHoldsThem) {
  for (const ChainModel model : kModels) {
    const TestRig rig = pair(model, 0.05f, 2, 0.1f, 0.5f);
    const HairDesc desc{.solver = &kCharacterSolver, .follows_poses = true};
    HairDesc linked = desc;
    linked.links = &kCharacterLinks;
    TestHair test(rig, linked), animated(rig, desc);
    const float weights[] = {0.0f, 1.0f};
    for (int frame = 0; frame < 60; ++frame) {
      std::vector<Quat> pose(rig.bones.size());
      for (std::size_t bone = 1; bone <= 2; ++bone) {
        pose[bone] = turned_about({0.6f, 0, 0.8f}, -0.4 * std::sin(frame * 0.1));
      }
      for (TestHair* const each : {&test, &animated}) {
        ASSERT_EQ(each->hair.set_pose(0, pose, weights), Status::kOk);
        ASSERT_EQ(each->hair.step(at_rate(60)), Status::kOk);
      }
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(distance(test.ends()[i], animated.ends()[i]), 1e-6f) << "of bone " << i << " in frame " << frame;
      }
      EXPECT_LT(worst_excess(rig, test.ends()), 1e-4) << "the other strand comes to it";
    }
    EXPECT_GT(distance(test.ends()[3], animated.ends()[3]), 1e-3f) << "or links had nothing to do";
  }
}

/// Two bones that are both held further apart than their link is long: the link is longer, and neither moves.
TEST(LinksAlone, MoveNoneOfTwoBonesThatAreHeld) {
  for (const ChainModel model : kModels) {
    const TestRig rig = pair(model, 0.05f, 2, 0.1f, 0.5f);
    TestHair test(rig, {.solver = &kCharacterSolver, .links = &kCharacterLinks, .follows_poses = true});
    const float held[] = {0.0f, 0.0f};
    std::vector<Quat> pose(rig.bones.size());
    pose[1] = turned_about({0, 0, 1}, -0.3);
    pose[3] = turned_about({0, 0, 1}, 0.3);
    const Vec3 expected[] = {rotated(pose[1], {0, -0.125f, 0}), rotated(pose[1], {0, -0.25f, 0})};
    for (int frame = 0; frame < 5; ++frame) {
      ASSERT_EQ(test.hair.set_pose(0, pose, held), Status::kOk);
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      const auto ends = test.ends();
      EXPECT_GT(worst_excess(rig, ends), 0.1);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(distance(ends[i], expected[i]), 1e-6f) << frame;
        EXPECT_LT(distance(ends[i + 2], {0.05f - expected[i].x, expected[i].y, 0}), 1e-6f) << frame;
      }
    }
  }
}

/// The other end is held out of reach: further away than a bone and its link are long, or so near that the bone is too
/// short for it.
TEST(LinksAlone, PointStraightWhereTheyCannotReach) {
  for (const ChainModel model : kModels) {
    for (const float away : {0.153f, 0.16f, 0.3f, 0.02f, 0.05f}) {
      TestRig rig;
      rig.model = model;
      const TestBone bone{.length = 0.1f, .stiffness = 20, .damping = 8, .torsion = kShortestArc};
      rig.add(bone);
      TestBone other = bone;
      other.joint = {0.8f * away, -0.1f, 0.6f * away};
      rig.add(other);
      const bool is_far = away > 0.1f;
      rig.links.push_back({2, 1, is_far ? 0.0f : 0.1f + 1.06f * away, is_far ? 0.05f : 1.0f});
      TestHair test(rig, {.solver = &kCharacterSolver, .links = &kCharacterLinks, .follows_poses = true});
      const float weights[] = {0.0f, 1.0f};
      ASSERT_EQ(test.hair.set_pose(0, std::vector<Quat>(3), weights), Status::kOk);
      for (int frame = 0; frame < 5; ++frame) ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
      const float along = is_far ? away - 0.1f : away + 0.1f;
      EXPECT_LT(distance(test.ends()[1], {0.8f * along, -0.1f, 0.6f * along}), 1e-4f) << away;
    }
  }
}

/// A bar between two strands that is thicker than their links are long; each head has its own.
MovingCollider bar_between(double x, double y) {
  MovingCollider bar{.shape = ColliderShape::kCapsule, .center = {x, y, -0.5}, .axis = {0, 0, 1}};
  bar.radius = 0.06f;
  return bar;
}

TEST(LinksAlone, PullNothingIntoWhatMoves) {
  for (const ChainModel model : kModels) {
    const TestRig rig = pair(model, 0.09f, 2, 0.05f, 0.5f);
    const HairDesc desc{.instances = 3, .solver = &kCharacterSolver, .links = &kCharacterLinks, .moving_colliders = 1};
    TestHair test(rig, desc);
    double torn = 0;
    for (int frame = 0; frame < 90; ++frame) {
      MovingCollider bars[3];
      for (std::uint32_t i = 0; i < 3; ++i) {
        bars[i] = bar_between(0.045 + 0.01 * std::sin(frame * 0.3 + 2 * i), -0.18 - 0.001 * frame - 0.02 * i);
        ASSERT_EQ(test.hair.set_colliders(i, {&bars[i], 1}), Status::kOk);
      }
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      for (std::uint32_t i = 0; i < 3; ++i) {
        for (const Vec3& end : test.ends(i)) {
          const double away = std::hypot(double(end.x) - bars[i].center[0], double(end.y) - bars[i].center[1]);
          EXPECT_GT(away, 0.06 * (1 - 2e-4)) << "head " << i << " in frame " << frame;
        }
        torn = std::max(torn, worst_excess(rig, test.ends(i)));
      }
    }
    EXPECT_GT(torn, 0.02) << "or nothing stood in the way";
  }
}

/// A ball on the straight way between the two; one of the bones is held, whichever the link names first.
TEST(LinksAlone, GoRoundWhatStandsBetweenABoneAndOneThatIsHeld) {
  for (const ChainModel model : kModels) {
    for (const bool first_is_held : {false, true}) {
      TestRig rig;
      rig.model = model;
      const TestBone held{.length = 0.1f, .stiffness = 20, .damping = 8, .torsion = kShortestArc};
      TestBone free = held;
      free.joint = {0.09f, 0, 0};
      rig.add(held);
      rig.add(free);
      rig.links.push_back(first_is_held ? LinkRecord{1, 2, 0, 0.07f} : LinkRecord{2, 1, 0, 0.07f});
      TestHair test(
          rig, {.solver = &kCharacterSolver, .links = &kCharacterLinks, .moving_colliders = 1, .follows_poses = true});
      const float weights[] = {0.0f, 1.0f};
      MovingCollider ball{.center = {0.045, -0.1, 0}};
      ball.radius = 0.03f;
      for (int frame = 0; frame < 30; ++frame) {
        ASSERT_EQ(test.hair.set_pose(0, std::vector<Quat>(3), weights), Status::kOk);
        ASSERT_EQ(test.hair.set_colliders(0, {&ball, 1}), Status::kOk);
        ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
        const auto ends = test.ends();
        EXPECT_LT(distance(ends[0], {0, -0.1f, 0}), 1e-6f) << "held";
        EXPECT_LT(worst_excess(rig, ends), 1e-4) << first_is_held << " in frame " << frame;
        EXPECT_GT(std::hypot(ends[1].x - 0.045f, ends[1].y + 0.1f, ends[1].z), 0.03f * (1 - 1e-4f));
      }
    }
  }
}

/// Links that are shorter than the strands hang apart: two that are alike yield alike, and one that is heavy yields
/// less.
TEST(LinksAlone, TurnBothBonesByTheirMasses) {
  for (const ChainModel model : kModels) {
    for (const int more : {0, 2}) {  // bones that hang on the first strand besides
      TestRig rig;
      rig.model = model;
      const TestBone bone{
          .joint = {-0.05f, 0, 0}, .length = 0.1f, .stiffness = 5, .damping = 4, .torsion = kShortestArc};
      rig.add_strand(1 + more, bone);
      TestBone other = bone;
      other.joint.x = 0.05f;
      const std::uint32_t second = rig.add(other);
      rig.links.push_back({second, 1, 0, 0.06f});
      TestHair test(rig, {.links = &kLinks});
      ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
      const float first_way = test.ends()[0].x + 0.05f, second_way = 0.05f - test.ends()[second - 1].x;
      EXPECT_NEAR(first_way + second_way, 0.04f, 1e-3f);
      if (more == 0) {
        EXPECT_NEAR(first_way, second_way, 1e-5f);
      } else {
        EXPECT_LT(first_way, 0.6f * second_way);
        EXPECT_GT(first_way, 0.05f * second_way);
      }
    }
  }
}

/// How far the child's end is from where its parent's frame has it, after ten seconds in which wind presses the parent
/// against its link and nothing acts on the child; metres, of bones of 10 cm.
float child_beside_its_rest(ChainModel model, double fps) {
  TestRig rig;
  rig.model = model;
  const std::uint32_t parent =
      rig.add({.length = 0.1f, .friction = 20, .stiffness = 20, .damping = 4, .torsion = kShortestArc});
  const Vec3 to{0.6f, -0.48f, 0.64f};
  rig.add(
      {.parent = parent, .rest_direction = to, .length = 0.1f, .stiffness = 40, .damping = 4, .torsion = kShortestArc});
  const std::uint32_t anchor =
      rig.add({.joint = {-0.05f, 0, 0}, .length = 0.1f, .stiffness = 1e7f, .damping = 1e4f, .torsion = kShortestArc});
  rig.link(parent, anchor, 0.05f);
  TestHair test(rig, {.links = &kLinks});
  StepSettings settings = at_rate(fps);
  settings.environment.gravity = {};
  settings.environment.wind = {0.4f, 0, 0.3f};
  for (int frame = 0; frame < int(10 * fps); ++frame) EXPECT_EQ(test.hair.step(settings), Status::kOk);
  const auto ends = test.ends();
  EXPECT_LT(worst_excess(rig, ends), 1e-4);
  EXPECT_GT(ends[0].z, 0.015f) << "the wind bends it";
  const Mat34& frame = test.hair.palette(0)[parent];
  const Vec3 from = transformed(frame, {}), along = transformed(frame, to);
  return distance(ends[1], {ends[0].x + 0.1f * (along.x - from.x), ends[0].y + 0.1f * (along.y - from.y),
                            ends[0].z + 0.1f * (along.z - from.z)});
}

/// Links are of order one in time (MODEL.md, "Links").
TEST(LinksAlone, HoldABoneSoStillThatItsChildRests) {
  EXPECT_LT(child_beside_its_rest(ChainModel::kCascade, 60), 1e-3f);
  EXPECT_LT(child_beside_its_rest(ChainModel::kCascade, 240), 2.5e-4f);
  EXPECT_LT(child_beside_its_rest(ChainModel::kPassive, 60), 1.5e-2f);
  EXPECT_LT(child_beside_its_rest(ChainModel::kPassive, 240), 4e-3f);
}

}  // namespace
}  // namespace coif::links_alone_test
