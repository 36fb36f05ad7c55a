// What open() demands of the body's bones and colliders, and of limits. small_asset() has two bones of the body, a
// sphere on the first, a capsule and a plane on the second; bone 2 may touch the first and the last, bone 3 the
// capsule; bone 3 has a cone as its limit, bone 4 a spherical one.

#include "models/small_asset.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace coif::open_body_test {

constexpr float kNan = NAN;

TEST(OpenBody, GivesBackWhatWasWritten) {
  AlignedBytes file(write_asset(small_asset()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  const AssetContents contents = small_asset();
  ASSERT_EQ(asset.body_bones().size(), 2u);
  EXPECT_STREQ(asset.body_bone_name(0), "LeftShoulder");
  EXPECT_STREQ(asset.body_bone_name(1), "Chest");
  EXPECT_STREQ(asset.body_bone_name(2), "") << "no such bone";
  EXPECT_STREQ(asset.bone_name(4), "fringe") << "names of the hair's bones are where they were";
  EXPECT_EQ(asset.body_bones()[0].joint[0], 0.1f);
  ASSERT_EQ(asset.body_colliders().size_bytes(), 3 * sizeof(ColliderRecord));
  EXPECT_EQ(std::memcmp(asset.body_colliders().data(), contents.body_colliders.data(), 3 * sizeof(ColliderRecord)), 0);
  ASSERT_EQ(asset.body_sets().size(), asset.bones().size());
  EXPECT_EQ(std::memcmp(asset.body_sets().data(), contents.body_sets.data(), asset.body_sets().size_bytes()), 0);
}

TEST(OpenBody, IsThereAsAWholeOrNotAtAll) {
  EXPECT_EQ(refusal([](auto& a) { clear_group("body", a); }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.body_bones.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.body_sets.clear(); }), LoadCode::kChunkMissing);
  const auto nameless = [](AssetContents& a) { a.bone_names.clear(), a.body_bone_names.clear(); };
  EXPECT_EQ(refusal(nameless), LoadCode::kChunkMissing);
}

TEST(OpenBody, EveryBodyBoneHasANameAPlaceAndAnOrientation) {
  EXPECT_EQ(refusal([](auto& a) { a.body_bone_names[1].clear(); }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.body_bones[0].joint[2] = kNan; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.body_bones[1].joint[0] = 2.0e5f; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.body_bones[1].rotation[3] = 0.9f; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.body_bones[1].rotation[0] = kNan; }), LoadCode::kNotFinite);
}

TEST(OpenBody, NeitherTheHairsBonesNorOthersCarryItsColliders) {
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[0].bone = 1; }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[0].bone = 2; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[2].bone = kNone; }), LoadCode::kReference);
}

TEST(OpenBody, ItsCollidersAreCheckedAsThoseOfTheHead) {
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[0].shape = ColliderShape(5); }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[0].flags = kColliderKeepsInside; }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[2].flags = kColliderKeepsInside; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[1].reserved_axis = 1; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[0].radii[1] = 0.05f; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[1].axis[1] = 0; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[1].center[1] = kNan; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.body_colliders[2].axis[2] = 0.9f; }), LoadCode::kNotFinite);
}

TEST(OpenBody, SetsNameOnlyItsCollidersAndBelongToBonesThatMove) {
  EXPECT_EQ(refusal([](auto& a) { a.body_sets[4] = 0b111; }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.body_sets[4] = 0b1000; }), LoadCode::kColliderSet);
  EXPECT_EQ(refusal([](auto& a) { a.body_sets[1] = 0b001; }), LoadCode::kColliderSet);
  EXPECT_EQ(refusal([](auto& a) { a.body_sets.pop_back(); }), LoadCode::kChunkSize);
  AssetContents contents = small_asset();
  contents.body_sets[3] = 0b1000;
  const LoadStatus status = open_written(contents);
  EXPECT_EQ(status.chunk, chunk::kBodySets);
  EXPECT_EQ(status.item, 3u);
  EXPECT_EQ(status.expected, 0b111u);
}

TEST(OpenBody, ThirtyTwoCollidersAndBonesAreTheMost) {
  const auto with = [](std::size_t colliders, std::size_t bones) {
    return refusal([=](AssetContents& a) {
      a.body_colliders.resize(colliders, a.body_colliders[0]);
      a.body_bones.resize(bones, a.body_bones[0]);
      a.body_bone_names.resize(bones, "Hand");
      a.body_sets[3] = ~0u >> (32 - std::min<std::size_t>(colliders, 32));
    });
  };
  EXPECT_EQ(with(kMaxBodyColliders, kMaxBodyColliders), LoadCode::kOk);
  EXPECT_EQ(with(kMaxBodyColliders + 1, 2), LoadCode::kChunkSize);
  EXPECT_EQ(with(3, kMaxBodyColliders + 1), LoadCode::kChunkSize);
}

TEST(OpenLimits, EveryBoneHasARecordOrNone) {
  EXPECT_EQ(refusal([](auto& a) { a.limits.clear(); }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.limits.pop_back(); }), LoadCode::kChunkSize);
}

TEST(OpenLimits, KindsAreThoseKnownAndRigidBonesHaveNone) {
  EXPECT_EQ(refusal([](auto& a) { a.limits[3].kind = LimitKind(4); }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.limits[1].kind = LimitKind::kCone; }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.limits[2].reserved = 1; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.limits[2].reserved = kNan; }), LoadCode::kReserved);
}

TEST(OpenLimits, EachKindHasItsAnglesAndNoOther) {
  const auto with = [](LimitKind kind, float first, float second) {
    return refusal([=](AssetContents& a) {
      a.limits[3].kind = kind;
      a.limits[3].angles[0] = first;
      a.limits[3].angles[1] = second;
    });
  };
  EXPECT_EQ(with(LimitKind::kUnlimited, 0, 0), LoadCode::kOk);
  EXPECT_EQ(with(LimitKind::kUnlimited, 0.1f, 0), LoadCode::kNotFinite);
  for (const LimitKind kind : {LimitKind::kCone, LimitKind::kHinge}) {
    EXPECT_EQ(with(kind, 0, 0), LoadCode::kOk);
    EXPECT_EQ(with(kind, kNoAngleLimit, 0), LoadCode::kOk);
    EXPECT_EQ(with(kind, 3.15f, 0), LoadCode::kNotFinite);
    EXPECT_EQ(with(kind, -0.1f, 0), LoadCode::kNotFinite);
    EXPECT_EQ(with(kind, kNan, 0), LoadCode::kNotFinite);
    EXPECT_EQ(with(kind, 1, 0.1f), LoadCode::kNotFinite);
  }
  EXPECT_EQ(with(LimitKind::kSpherical, kNoAngleLimit, kMostYaw), LoadCode::kOk);
  EXPECT_EQ(with(LimitKind::kSpherical, 3.15f, 1), LoadCode::kNotFinite);
  EXPECT_EQ(with(LimitKind::kSpherical, 1, std::nextafter(kMostYaw, 2.0f)), LoadCode::kNotFinite);
  EXPECT_EQ(with(LimitKind::kSpherical, 1, kNan), LoadCode::kNotFinite);
}

TEST(OpenLimits, RotationsAreUnitOfBonesWithoutOneToo) {
  for (const std::size_t bone : {0u, 3u}) {
    EXPECT_EQ(refusal([&](auto& a) { a.limits[bone].rotation[2] = 0.5f; }), LoadCode::kNotFinite);
    EXPECT_EQ(refusal([&](auto& a) { a.limits[bone].rotation[0] = kNan; }), LoadCode::kNotFinite);
  }
}

}  // namespace coif::open_body_test
