#include "cook/recipe/recipe.h"
#include "cook/rig/colliders.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

namespace coif::cook::spring_colliders_test {

using Shape = importer::SourceCollider::Shape;
constexpr std::uint32_t kHead = 1;
constexpr std::uint32_t kBody = 0;

/// root > Head > (hair_a > hair_a_end, hair_b > hair_b_end); one spring on each hair.
class SpringCollidersTest : public testing::Test {
 protected:
  SpringCollidersTest() {
    add_node(model_, "root", importer::kNoIndex, {0, 0, 0});
    add_node(model_, "Head", 0, {0, 1.6, 0});
    skeleton_.bones.resize(1);
    skeleton_.bones[0].kind = BoneKind::kHead;
    skeleton_.bone_of_node = {0, 0};
    add_hair("hair_a", -0.1);
    add_hair("hair_b", 0.1);
  }

  void add_hair(const std::string& name, double x) {
    const auto bone = std::uint32_t(skeleton_.bones.size());
    const std::uint32_t node = add_node(model_, name, kHead, {x, 1.6, 0});
    const std::uint32_t end = add_node(model_, name + "_end", node, {x, 1.4, 0});
    SkeletonBone hair;
    hair.kind = BoneKind::kSimulated;
    hair.parent = 0;
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

  std::uint32_t add_collider(Shape shape, std::uint32_t node) {
    importer::SourceCollider collider;
    collider.shape = shape;
    collider.node = node;
    collider.center = {0, 1.7, 0};
    collider.tail = {0, 1.5, 0};
    collider.radius = shape == Shape::kPlane ? 0 : 0.1;
    model_.colliders.push_back(collider);
    return std::uint32_t(model_.colliders.size() - 1);
  }

  [[nodiscard]] Told<Colliders> run(std::uint32_t head = kHead) const {
    return told([&](Findings& findings) { return spring_colliders(model_, head, skeleton_, findings); });
  }

  importer::SourceModel model_;
  Skeleton skeleton_;
};

TEST_F(SpringCollidersTest, EachBoneHasItsSpringsSetAndItsJointsRadius) {
  const std::uint32_t first = add_collider(Shape::kSphere, kHead);
  const std::uint32_t second = add_collider(Shape::kSphere, kHead);
  model_.springs[0].colliders = {first, second};
  model_.springs[1].colliders = {second};
  const Told<Colliders> found = run();
  ASSERT_EQ(found.made.shapes.size(), 2u);
  EXPECT_EQ(found.made.of_bone, (std::vector<std::uint32_t>{0, 0b11, 0b10}));
  EXPECT_EQ(found.made.hit_radius, (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_TRUE(found.left_out.empty());
}

TEST_F(SpringCollidersTest, ShapesKeepTheirSizeAndPlace) {
  model_.springs[0].colliders = {add_collider(Shape::kSphere, kHead), add_collider(Shape::kCapsule, kHead),
                                 add_collider(Shape::kPlane, kHead)};
  model_.colliders[0].keeps_inside = true;
  model_.colliders[2].normal = Eigen::Vector3d::UnitX();
  const auto shapes = run().made.shapes;
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_EQ(shapes[0].shape, ColliderShape::kSphere);
  EXPECT_TRUE(shapes[0].keeps_inside);
  EXPECT_EQ(shapes[0].center, Eigen::Vector3d(0, 1.7, 0));
  EXPECT_EQ(shapes[0].radii, Eigen::Vector3d::Constant(0.1));
  EXPECT_EQ(shapes[1].shape, ColliderShape::kCapsule);
  EXPECT_TRUE(shapes[1].axis.isApprox(Eigen::Vector3d(0, -0.2, 0)));
  EXPECT_EQ(shapes[2].shape, ColliderShape::kPlane);
  EXPECT_EQ(shapes[2].axis, Eigen::Vector3d::UnitX());
  EXPECT_EQ(shapes[2].radii, Eigen::Vector3d::Zero());
}

TEST_F(SpringCollidersTest, ACapsuleWithoutLengthIsASphere) {
  model_.springs[0].colliders = {add_collider(Shape::kCapsule, kHead)};
  model_.colliders[0].tail = model_.colliders[0].center;
  EXPECT_EQ(run().made.shapes.at(0).shape, ColliderShape::kSphere);
}

TEST_F(SpringCollidersTest, WhatIsNotOnTheHeadIsTheBodys) {
  const std::uint32_t chest = add_collider(Shape::kSphere, kBody), crown = add_collider(Shape::kSphere, kHead);
  for (importer::SourceSpring& spring : model_.springs) spring.colliders = {chest, crown};
  const Told<Colliders> found = run();
  EXPECT_EQ(found.made.shapes.size(), 1u);
  EXPECT_EQ(found.made.of_bone, (std::vector<std::uint32_t>{0, 1, 1}));
  EXPECT_TRUE(found.left_out.empty());
  EXPECT_TRUE(run(importer::kNoIndex).made.shapes.empty()) << "without a head nothing is on it";
}

TEST_F(SpringCollidersTest, AShapeOnSwingingHairMovesWithTheRigidBoneAboveIt) {
  model_.springs[1].colliders = {add_collider(Shape::kSphere, 2)};  // on hair_a
  const Told<Colliders> found = run();
  ASSERT_EQ(found.made.shapes.size(), 1u);
  EXPECT_EQ(found.made.shapes[0].bone, 0u);
}

TEST_F(SpringCollidersTest, ShapesThatNoHairTouchesAreNotThereAtAll) {
  add_collider(Shape::kSphere, kHead);
  add_collider(Shape::kSphere, kBody);
  const Told<Colliders> found = run();
  EXPECT_TRUE(found.made.shapes.empty());
  EXPECT_TRUE(found.left_out.empty());
}

TEST_F(SpringCollidersTest, ASphereWithoutSizeIsLeftOut) {
  model_.springs[0].colliders = {add_collider(Shape::kSphere, kHead)};
  model_.colliders[0].radius = 0;
  EXPECT_TRUE(run().made.shapes.empty());
  EXPECT_EQ(run().left_out.size(), 1u);
}

TEST_F(SpringCollidersTest, MoreShapesThanAnAssetHoldsAreLeftOut) {
  for (std::uint32_t i = 0; i < kMaxColliders + 3; ++i) {
    model_.springs[0].colliders.push_back(add_collider(Shape::kSphere, kHead));
  }
  const Told<Colliders> found = run();
  EXPECT_EQ(found.made.shapes.size(), kMaxColliders);
  EXPECT_EQ(found.made.of_bone[1], 0xFFFFFFFFu);
  EXPECT_EQ(found.left_out.size(), 3u);
}

TEST_F(SpringCollidersTest, WhatHoldsHairAtRestIsToldAndWhatIsOutOfReachIsLeftOut) {
  for (std::uint32_t b = 1; b < 3; ++b) {
    skeleton_.bones[b].start = {b == 1 ? -0.1 : 0.1, 1.6, 0};
    skeleton_.bones[b].tail = skeleton_.bones[b].start - Eigen::Vector3d(0, 0.2, 0);
  }
  const std::uint32_t around_a = add_collider(Shape::kSphere, kHead), far = add_collider(Shape::kSphere, kHead);
  model_.colliders[around_a].center = skeleton_.bones[1].tail;
  model_.colliders[far].center = {9, 1.6, 0};
  for (importer::SourceSpring& spring : model_.springs) spring.colliders = {around_a, far};
  const HeadBone head{.node = kHead};
  const auto found = told([&](Findings& findings) {
    return find_colliders(model_, head, FittedHead{}, skeleton_, default_recipe(), findings);
  });
  EXPECT_EQ(found.made.shapes.size(), 1u);
  ASSERT_EQ(found.left_out.size(), 1u);
  EXPECT_NE(found.left_out[0].text().find("collider 1"), std::string::npos) << found.left_out[0].text();
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_NE(found.warnings[0].message.find("1 bones are inside a collider at rest"), std::string::npos)
      << found.warnings[0].message;
}

}  // namespace coif::cook::spring_colliders_test
