// Colliders on bones that the head does not carry: the file's and the recipe's.

#include "cook/rig/body_colliders.h"
#include "cook/cook.h"

#include "cook/built_models.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::cook::body_colliders_test {

using Shape = importer::SourceCollider::Shape;
constexpr std::uint32_t kHips = 0, kShoulder = 1, kHead = 2;

/// Hips > (LeftShoulder, Head > (hair_a > hair_a_end, hair_b > hair_b_end)); a spring on each hair, 0.2 m straight
/// down.
class BodyCollidersTest : public testing::Test {
 protected:
  BodyCollidersTest() : recipe_(default_recipe()) {
    add_node(model_, "Hips", importer::kNoIndex, {0, 1, 0});
    add_node(model_, "LeftShoulder", kHips, {0.2, 1.4, 0});
    add_node(model_, "Head", kHips, {0, 1.6, 0});
    skeleton_.bones.resize(1);
    skeleton_.bones[0].kind = BoneKind::kHead;
    skeleton_.bones[0].start = skeleton_.bones[0].tail = {0, 1.6, 0};
    skeleton_.bone_of_node = {0, 0, 0};
    add_hair("hair_a", -0.1);
    add_hair("hair_b", 0.1);
    of_head_.hit_radius = {0, 0.01, 0.02};
  }

  void add_hair(const std::string& name, double x) {
    const auto bone = std::uint32_t(skeleton_.bones.size());
    const std::uint32_t node = add_node(model_, name, kHead, {x, 1.6, 0});
    const std::uint32_t end = add_node(model_, name + "_end", node, {x, 1.4, 0});
    SkeletonBone hair;
    hair.name = name;
    hair.kind = BoneKind::kSimulated;
    hair.parent = 0;
    hair.start = {x, 1.6, 0};
    hair.tail = {x, 1.4, 0};
    skeleton_.bones.push_back(hair);
    skeleton_.bone_of_node.insert(skeleton_.bone_of_node.end(), {bone, bone});
    importer::SourceSpring spring;
    spring.name = name;
    spring.joints.resize(2);
    spring.joints[0].node = node;
    spring.joints[0].length = 0.2;
    spring.joints[0].hit_radius = 0.01 * bone;
    spring.joints[1].node = end;
    model_.springs.push_back(spring);
  }

  std::uint32_t add_collider(std::uint32_t node, const Eigen::Vector3d& center, double radius = 0.05) {
    importer::SourceCollider collider;
    collider.node = node;
    collider.center = center;
    collider.radius = radius;
    model_.colliders.push_back(collider);
    return std::uint32_t(model_.colliders.size() - 1);
  }

  void say(const std::string& body) {
    const auto recipe = parse_recipe(R"({"body": {)" + body + "}}", "r.json");
    ASSERT_TRUE(recipe) << recipe.error().message;
    recipe_ = *recipe;
  }

  [[nodiscard]] Told<tl::expected<BodyColliders, ToolError>> try_run() const {
    const HeadBone head{.node = kHead};
    return told(
        [&](Findings& findings) { return find_body_colliders(model_, head, skeleton_, of_head_, recipe_, findings); });
  }

  [[nodiscard]] BodyColliders run() const { return try_run().made.value(); }

  [[nodiscard]] std::string error() const {
    const auto found = try_run();
    return found.made ? "" : found.made.error().message;
  }

  importer::SourceModel model_;
  Skeleton skeleton_;
  Colliders of_head_;
  Recipe recipe_;
};

TEST_F(BodyCollidersTest, EachBoneMayTouchWhatItsSpringNamesOnBonesAsTheFileCallsThem) {
  const auto shoulder = add_collider(kShoulder, {0.25, 1.4, 0}), head = add_collider(kHead, {0, 1.7, 0});
  const auto hips = add_collider(kHips, {0, 1, 0}), second = add_collider(kShoulder, {0.3, 1.4, 0});
  model_.springs[0].colliders = {shoulder, head};
  model_.springs[1].colliders = {head, hips, second};
  const BodyColliders body = run();
  ASSERT_EQ(body.shapes.size(), 3u) << "the head's is not the body's";
  ASSERT_EQ(body.bones.size(), 2u) << "two on one bone share it";
  EXPECT_EQ(body.bones[body.shapes[0].bone].name, "LeftShoulder");
  EXPECT_EQ(body.bones[body.shapes[1].bone].name, "Hips");
  EXPECT_EQ(body.shapes[2].bone, body.shapes[0].bone);
  EXPECT_EQ(body.of_bone, (std::vector<std::uint32_t>{0, 0b001, 0b110}));
  EXPECT_EQ(body.bones[0].joint, Eigen::Vector3d(0.2, 1.4, 0));
  EXPECT_EQ(body.shapes[0].center, Eigen::Vector3d(0.25, 1.4, 0));
}

TEST_F(BodyCollidersTest, BodyBonesKeepTheirOrientation) {
  model_.nodes[kShoulder].model_from_node.linear() =
      (2 * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix()).eval();
  model_.springs[0].colliders = {add_collider(kShoulder, {0.25, 1.4, 0})};
  const Eigen::Quaterniond expected(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  EXPECT_LT(run().bones.at(0).rotation.angularDistance(expected), 1.0e-9) << "without the node's scale";
}

TEST_F(BodyCollidersTest, MoreThanAnAssetHoldsKeepsTheNearestAndNamesTheOthers) {
  for (std::uint32_t i = 0; i < kMaxBodyColliders + 3; ++i) {
    const double away = i < 3 ? 5.0 + i : 0.1 * i;  // the first three are the farthest
    model_.springs[0].colliders.push_back(add_collider(kHips, {-0.1, 1 - away, 0}));
  }
  const auto found = try_run();
  EXPECT_EQ(found.made->shapes.size(), kMaxBodyColliders);
  EXPECT_EQ(found.made->of_bone[1], 0xFFFFFFFFu);
  ASSERT_EQ(found.left_out.size(), 3u);
  EXPECT_NE(found.left_out[0].text().find("collider 0 on 'Hips'"), std::string::npos) << found.left_out[0].text();
  EXPECT_NE(found.left_out[2].text().find("collider 2 on 'Hips'"), std::string::npos) << found.left_out[2].text();
}

TEST_F(BodyCollidersTest, ShapesWithoutSizeAndBonesWithoutNamesAreLeftOut) {
  model_.springs[0].colliders = {add_collider(kHips, {0, 1, 0}, 0), add_collider(kShoulder, {0, 1, 0})};
  model_.nodes[kShoulder].name = "";
  const auto found = try_run();
  EXPECT_TRUE(found.made->shapes.empty());
  EXPECT_EQ(found.left_out.size(), 2u);
}

TEST_F(BodyCollidersTest, TheRecipeMayDoWithoutTheFilesOwn) {
  model_.springs[0].colliders = {add_collider(kHips, {0, 1, 0})};
  say(R"("from_file": false)");
  const auto found = try_run();
  EXPECT_TRUE(found.made->shapes.empty());
  ASSERT_EQ(found.left_out.size(), 1u);
  EXPECT_NE(found.left_out[0].why.find("body.from_file"), std::string::npos);
  recipe_ = default_recipe();
  recipe_.dynamics_source = DynamicsSource::kCurves;
  EXPECT_TRUE(run().shapes.empty()) << "then nothing of the file's springs counts";
}

TEST_F(BodyCollidersTest, TheRecipesShapesFollowFromWhatIsGiven) {
  say(R"("colliders": [
    {"bone": "leftshoulder", "radius": 0.06},
    {"bone": "Hips", "center": [0, 1, 0], "tail": [0, 1.3, 0], "radius": 0.1, "hair": "hair_b"},
    {"bone": "Hips", "tail": [0, 1.3, 0], "radius": 0.1, "tail_radius": 0.05},
    {"bone": "Hips", "center": [0, 0, -0.2], "normal": [0, 0, 2]},
    {"bone": "Hips", "radius": 2, "inside": true}])");
  const BodyColliders body = run();
  ASSERT_EQ(body.shapes.size(), 5u);
  EXPECT_EQ(body.shapes[0].shape, ColliderShape::kSphere);
  EXPECT_EQ(body.shapes[0].center, Eigen::Vector3d(0.2, 1.4, 0)) << "where the bone is";
  EXPECT_EQ(body.bones[0].name, "LeftShoulder") << "as the file spells it";
  EXPECT_EQ(body.shapes[1].shape, ColliderShape::kCapsule);
  EXPECT_TRUE(body.shapes[1].axis.isApprox(Eigen::Vector3d(0, 0.3, 0)));
  EXPECT_EQ(body.shapes[2].shape, ColliderShape::kTaperedCapsule);
  EXPECT_EQ(body.shapes[2].radii, Eigen::Vector3d(0.1, 0.05, 0));
  EXPECT_EQ(body.shapes[3].shape, ColliderShape::kPlane);
  EXPECT_EQ(body.shapes[3].axis, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(body.shapes[4].keeps_inside);
  EXPECT_EQ(body.of_bone, (std::vector<std::uint32_t>{0, 0b11101, 0b11111}));
}

TEST_F(BodyCollidersTest, AnEndWithinTheOtherIsASphere) {
  say(R"("colliders": [{"bone": "Hips", "tail": [0, 1.01, 0], "radius": 0.1, "tail_radius": 0.2}])");
  const BodyColliders body = run();
  EXPECT_EQ(body.shapes.at(0).shape, ColliderShape::kSphere);
  EXPECT_EQ(body.shapes[0].radii, Eigen::Vector3d::Constant(0.2));
  EXPECT_EQ(body.shapes[0].center, Eigen::Vector3d(0, 1.01, 0));
}

TEST_F(BodyCollidersTest, BonesThatAreNotThereAreErrorsThatOfferOthers) {
  say(R"("colliders": [{"bone": "Hips", "radius": 0.1}, {"bone": "LeftSholder", "radius": 0.1}])");
  EXPECT_NE(error().find("[1]: no bone is called 'LeftSholder'; did you mean 'LeftShoulder'?"), std::string::npos)
      << error();
  say(R"("colliders": [{"bone": "Tail", "radius": 0.1}])");
  EXPECT_NE(error().find("there are Hips, LeftShoulder"), std::string::npos) << error();
  say(R"("colliders": [{"bone": "hair_a", "radius": 0.1}])");
  EXPECT_NE(error().find("moves with the head or is hair"), std::string::npos) << error();
  say(R"("colliders": [{"bone": "Hips", "radius": 0.1, "hair": ["braid*"]}])");
  EXPECT_NE(error().find("is called braid*"), std::string::npos) << error();
}

TEST_F(BodyCollidersTest, HairInsideItAtRestIsTold) {
  model_.springs[1].colliders = {add_collider(kShoulder, skeleton_.bones[2].tail)};
  const auto found = try_run();
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_NE(found.warnings[0].message.find("1 bones are inside a body collider at rest, 'hair_b'"), std::string::npos)
      << found.warnings[0].message;
}

TEST_F(BodyCollidersTest, WithoutHitRadiiItsShapesAreLargerByTheSmallestOfTheirHair) {
  const auto ball = add_collider(kShoulder, {1, 1, 0}), plane = add_collider(kHips, {0, 0, 0});
  const auto around = add_collider(kHips, {0, 1, 0}, 3);
  model_.colliders[plane].shape = Shape::kPlane;
  model_.colliders[plane].normal = Eigen::Vector3d::UnitY();
  model_.colliders[around].keeps_inside = true;
  model_.springs[0].colliders = {ball, plane};          // 0.01
  model_.springs[1].colliders = {ball, plane, around};  // 0.02
  EXPECT_EQ(run().shapes[0].radii, Eigen::Vector3d::Constant(0.05)) << "where bones have hit radii";
  of_head_.hit_radius.clear();
  const BodyColliders body = run();
  EXPECT_TRUE(body.shapes[0].radii.isApproxToConstant(0.06));
  EXPECT_TRUE(body.shapes[1].center.isApprox(Eigen::Vector3d(0, 0.01, 0)));
  EXPECT_TRUE(body.shapes[2].radii.isApproxToConstant(2.98)) << "hair stays farther inside";
  EXPECT_TRUE(body.hit_radius.empty());
}

TEST(CookBody, AssetsHoldTheBodyOfTheFileAndOfTheRecipe) {
  importer::SourceModel model = make_wig();
  ASSERT_EQ(model.nodes[0].name, "root");
  const auto recipe = parse_recipe(
      R"({"body": {"colliders": [{"bone": "root", "center": [0, 1.2, 0], "radius": 0.1}]}, "budget": {"error": 5},
          "dynamics": {"limits": [{"bones": "hair_1", "kind": "hinge", "angle": 30, "axis": [1, 0, 0]}]}})",
      "r.json");
  ASSERT_TRUE(recipe) << recipe.error().message;
  const auto made = cook(model, *recipe, {.draft = true});
  ASSERT_TRUE(made) << made.error().message;
  AlignedBytes file(made->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  ASSERT_EQ(asset.body_colliders().size(), 1u);
  EXPECT_STREQ(asset.body_bone_name(0), "root");
  const float head_height = asset.skeleton().head_joint[1];
  EXPECT_NEAR(asset.body_colliders()[0].center[1], 1.2f - head_height, 1.0e-5f) << "head space";
  EXPECT_NEAR(asset.body_bones()[0].joint[1], -head_height, 1.0e-5f);
  std::size_t touching = 0, hinges = 0;
  for (std::size_t b = 0; b < asset.bones().size(); ++b) {
    touching += asset.body_sets()[b] == 1 ? 1 : 0;
    hinges += asset.limits()[b].kind == LimitKind::kHinge ? 1 : 0;
  }
  EXPECT_EQ(touching, asset.skeleton().simulated_count);
  EXPECT_EQ(hinges, 1u);
  const auto plain = cook(make_wig(), default_recipe(), {.draft = true});
  AlignedBytes without(plain->asset);
  ASSERT_TRUE(asset.open(without.bytes()));
  EXPECT_TRUE(asset.body_bones().empty() && asset.body_sets().empty() && asset.limits().empty());
}

}  // namespace coif::cook::body_colliders_test
