// Which directions bones may have: as the file's springs and the recipe say.

#include "cook/dynamics/bake_dynamics.h"

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <numbers>

namespace coif::cook::bake_limits_test {

using Eigen::Vector3d;

constexpr std::uint32_t kHeadNode = 0;

/// Head > (down > down_end, out > out_end): one bone leads along -Y, the other along +X; a spring on each.
class BakeLimits : public testing::Test {
 protected:
  BakeLimits() : recipe_(default_recipe()) {
    add_node(model_, "Head", importer::kNoIndex, {0, 0, 0});
    skeleton_.bones.resize(1);
    skeleton_.bones[0].kind = BoneKind::kHead;
    skeleton_.bone_of_node = {0};
    add_hair("down", {0, -0.1, 0});
    add_hair("out", {0.1, 0, 0});
  }

  void add_hair(const std::string& name, const Vector3d& tail) {
    const auto bone = std::uint32_t(skeleton_.bones.size());
    const std::uint32_t node = add_node(model_, name, kHeadNode, {0, 0, 0});
    add_node(model_, name + "_end", node, tail);
    SkeletonBone hair;
    hair.name = name;
    hair.kind = BoneKind::kSimulated;
    hair.parent = 0;
    hair.tail = tail;
    skeleton_.bones.push_back(hair);
    skeleton_.bone_of_node.insert(skeleton_.bone_of_node.end(), {bone, bone});
    importer::SourceSpring spring;
    spring.joints.resize(2);
    spring.joints[0].node = node;
    spring.joints[0].length = 0.1;
    spring.joints[1].node = node + 1;
    model_.springs.push_back(spring);
  }

  void say(const std::string& limits) {
    const auto recipe = parse_recipe(R"({"dynamics": {"limits": [)" + limits + "]}}", "r.json");
    ASSERT_TRUE(recipe) << recipe.error().message;
    recipe_ = *recipe;
  }

  [[nodiscard]] tl::expected<std::vector<LimitRecord>, ToolError> run() const {
    return bake_limits(model_, skeleton_, recipe_, unheard());
  }

  importer::SourceModel model_;
  Skeleton skeleton_;
  Recipe recipe_;
};

Vector3d turned(const LimitRecord& limit, const Vector3d& axis) {
  const float* r = limit.rotation;
  return Eigen::Quaterniond(r[3], r[0], r[1], r[2]) * axis;
}

void expect_axes(const LimitRecord& limit, const Vector3d& x, const Vector3d& y) {
  EXPECT_LT((turned(limit, Vector3d::UnitX()) - x).norm(), 1.0e-6) << turned(limit, Vector3d::UnitX()).transpose();
  EXPECT_LT((turned(limit, Vector3d::UnitY()) - y).norm(), 1.0e-6) << turned(limit, Vector3d::UnitY()).transpose();
}

TEST_F(BakeLimits, HairWithoutAnyHasNoRecords) {
  EXPECT_TRUE(run().value().empty());
  say(R"({"bones": "*", "kind": "none"})");
  EXPECT_TRUE(run().value().empty());
}

TEST_F(BakeLimits, ASpringsLimitIsTheBones) {
  importer::SourceLimit& limit = model_.springs[1].joints[0].limit;
  limit.kind = importer::SourceLimit::Kind::kSpherical;
  limit.angles[0] = std::numbers::pi;
  limit.angles[1] = std::numbers::pi / 2;
  limit.rotation = Eigen::AngleAxisd(0.3, Vector3d::UnitZ());
  const std::vector<LimitRecord> limits = run().value();
  ASSERT_EQ(limits.size(), 3u);
  EXPECT_EQ(limits[1].kind, LimitKind::kUnlimited);
  EXPECT_EQ(limits[2].kind, LimitKind::kSpherical);
  EXPECT_LE(limits[2].angles[0], kNoAngleLimit);
  EXPECT_LE(limits[2].angles[1], kMostYaw);
  expect_axes(limits[2], limit.rotation * Vector3d::UnitX(), limit.rotation * Vector3d::UnitY());
  recipe_.dynamics_source = DynamicsSource::kCurves;
  EXPECT_TRUE(run().value().empty());
}

TEST_F(BakeLimits, TheRecipesLieAboutTheModelledDirectionAndTurnAboutTheirAxis) {
  say(R"({"bones": "down", "kind": "hinge", "angle": 30, "axis": [0, 5, 5]},
         {"bones": ["out"], "kind": "spherical", "angle": 40, "yaw": 20, "axis": [0, 0, 1]})");
  const std::vector<LimitRecord> limits = run().value();
  EXPECT_EQ(limits[1].kind, LimitKind::kHinge);
  EXPECT_NEAR(limits[1].angles[0], 30 * std::numbers::pi / 180, 1.0e-6);
  EXPECT_EQ(limits[1].angles[1], 0);
  expect_axes(limits[1], Vector3d::UnitZ(), -Vector3d::UnitY());
  EXPECT_NEAR(limits[2].angles[1], 20 * std::numbers::pi / 180, 1.0e-6);
  expect_axes(limits[2], Vector3d::UnitZ(), Vector3d::UnitX());
}

TEST_F(BakeLimits, AnAxisAlongTheBoneGivesWayToAnother) {
  say(R"({"bones": "out", "kind": "hinge", "angle": 30})");  // about X, along which it leads
  expect_axes(run().value()[2], Vector3d::UnitZ(), Vector3d::UnitX());
}

TEST_F(BakeLimits, TheLaterOneHoldsAndTheRecipesBeforeTheFiles) {
  model_.springs[0].joints[0].limit.kind = importer::SourceLimit::Kind::kCone;
  model_.springs[0].joints[0].limit.angles[0] = 1;
  say(R"({"bones": "*", "kind": "cone", "angle": 10}, {"bones": "down", "kind": "none"})");
  const std::vector<LimitRecord> limits = run().value();
  EXPECT_EQ(limits[1].kind, LimitKind::kUnlimited);
  EXPECT_EQ(limits[2].kind, LimitKind::kCone);
}

TEST_F(BakeLimits, NamesOfNoBoneThatMovesAreErrorsThatSayWhichDo) {
  say(R"({"bones": ["Head", "braid*"], "kind": "cone", "angle": 10})");
  const auto limits = run();
  ASSERT_FALSE(limits);
  EXPECT_NE(limits.error().message.find("[0]: no bone that moves is called Head, braid*; there are down, out"),
            std::string::npos)
      << limits.error().message;
}

}  // namespace coif::cook::bake_limits_test
