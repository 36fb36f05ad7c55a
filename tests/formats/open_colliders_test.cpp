// What open() demands of colliders and of the bones' sets of them. small_asset() has an ellipsoid, a capsule that keeps
// hair inside, a plane and a tapered capsule; bone 2 may touch all, bone 3 the capsule.

#include "formats/refusal.h"

#include <cmath>

namespace coif {
namespace {

constexpr float kNan = NAN;

void make_sphere(ColliderRecord& collider) {
  collider.shape = ColliderShape::kSphere;
  for (float& radius : collider.radii) radius = 0.1f;
}

TEST(OpenColliders, AcceptsEveryShape) {
  EXPECT_EQ(refusal([](auto&) {}), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { make_sphere(a.colliders[0]); }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) {
              make_sphere(a.colliders[0]);
              a.colliders[0].flags = kColliderKeepsInside;
            }),
            LoadCode::kOk);
}

TEST(OpenColliders, RefusesUnknownShapesAndRigidlessOnes) {
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].shape = ColliderShape(5); }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].bone = 3; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].bone = kNone; }), LoadCode::kReference);
}

TEST(OpenColliders, RefusesRadiiThatDoNotFitTheShape) {
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].radii[1] = 0; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].shape = ColliderShape::kSphere; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].radii[2] = 0.06f; }), LoadCode::kNotFinite) << "a capsule is round";
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].radii[0] = kNan; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[2].radii[0] = 1; }), LoadCode::kNotFinite) << "a plane has none";
}

TEST(OpenColliders, RefusesAxesThatDoNotFitTheShape) {
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].axis[0] = 0.1f; }), LoadCode::kNotFinite) << "an ellipsoid has none";
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].axis[1] = 0; }), LoadCode::kNotFinite) << "a sphere, not a capsule";
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].axis[0] = INFINITY; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[2].axis[2] = 0.9f; }), LoadCode::kNotFinite) << "normals are unit";
  EXPECT_EQ(refusal([](auto& a) { a.colliders[2].axis[2] = kNan; }), LoadCode::kNotFinite);
}

TEST(OpenColliders, RefusesFlagsWhereTheShapeHasNone) {
  EXPECT_EQ(refusal([](auto& a) { a.colliders[0].flags = kColliderKeepsInside; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[2].flags = kColliderKeepsInside; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].flags = kColliderKeepsInside | 2u; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[3].flags = kColliderKeepsInside; }), LoadCode::kReserved);
}

TEST(OpenColliders, ATaperedCapsuleHasTwoRadii) {
  const auto with_radii = [](float from, float to, float third) {
    return refusal([=](auto& a) {
      a.colliders[3].radii[0] = from;
      a.colliders[3].radii[1] = to;
      a.colliders[3].radii[2] = third;
    });
  };
  EXPECT_EQ(with_radii(0.05f, 0.05f, 0), LoadCode::kOk) << "both ends may be alike";
  EXPECT_EQ(with_radii(1.0e-6f, 0.05f, 0), LoadCode::kOk);
  EXPECT_EQ(with_radii(0, 0.05f, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with_radii(0.05f, 0, 0), LoadCode::kNotFinite) << "a point has no direction to push along";
  EXPECT_EQ(with_radii(0.05f, -0.03f, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with_radii(kNan, 0.05f, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with_radii(0.05f, kNan, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with_radii(0.05f, 2.0e5f, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with_radii(0.05f, 0.03f, 0.03f), LoadCode::kNotFinite) << "there is no third end";
  EXPECT_EQ(with_radii(0.05f, 0.03f, kNan), LoadCode::kNotFinite);
}

TEST(OpenColliders, NeitherEndOfATaperedCapsuleIsInsideTheOther) {
  const auto with_axis = [](float x, float y) {
    return refusal([=](auto& a) {
      a.colliders[3].axis[0] = x;
      a.colliders[3].axis[1] = y;
    });
  };
  EXPECT_EQ(with_axis(0, -0.021f), LoadCode::kOk) << "the radii differ by 0.02";
  EXPECT_EQ(with_axis(0, -0.019f), LoadCode::kNotFinite);
  EXPECT_EQ(with_axis(0, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with_axis(kNan, -0.2f), LoadCode::kNotFinite);
  EXPECT_EQ(with_axis(INFINITY, -0.2f), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) {
              a.colliders[3].radii[1] = a.colliders[3].radii[0];
              a.colliders[3].axis[1] = -1.0e-7f;
            }),
            LoadCode::kNotFinite)
      << "too short to have a direction";
}

TEST(OpenColliders, RefusesReservedFieldsInUse) {
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].reserved = 1; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].reserved_center = 1; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].reserved_radii = 1; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].reserved_axis = kNan; }), LoadCode::kReserved);
}

TEST(OpenColliders, RefusesSetsThatNameNoCollider) {
  EXPECT_EQ(refusal([](auto& a) { a.bones[2].colliders = 0b10000; }), LoadCode::kColliderSet);
  EXPECT_EQ(refusal([](auto& a) { a.bones[2].colliders = 1u << 31; }), LoadCode::kColliderSet);
  EXPECT_EQ(refusal([](auto& a) { a.colliders.pop_back(); }), LoadCode::kColliderSet);
  EXPECT_EQ(refusal([](auto& a) { a.colliders.clear(); }), LoadCode::kColliderSet);
}

TEST(OpenColliders, RefusesSetsOfBonesThatDoNotMove) {
  EXPECT_EQ(refusal([](auto& a) { a.bones[0].colliders = 1; }), LoadCode::kColliderSet);
  EXPECT_EQ(refusal([](auto& a) { a.bones[1].colliders = 1; }), LoadCode::kColliderSet);
}

TEST(OpenColliders, AcceptsAsManyAsASetCanNameAndNoMore) {
  const auto with = [](std::size_t count) {
    return [count](AssetContents& a) {
      a.colliders.resize(count, a.colliders[0]);
      a.bones[2].colliders = ~0u;
    };
  };
  EXPECT_EQ(refusal(with(kMaxColliders)), LoadCode::kOk);
  EXPECT_EQ(refusal(with(kMaxColliders + 1)), LoadCode::kChunkSize);
}

}  // namespace
}  // namespace coif
