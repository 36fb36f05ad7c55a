// How many bones of a chain may wait for their children.

#include "models/small_asset.h"

#include <cmath>
#include <vector>

namespace coif::open_rig_test {

constexpr std::uint32_t kRoot = 0xFFFF;  ///< As a parent: the rigid bone that carries the chain.

/// small_asset() without mesh and with one chain: bone i of it hangs from bone parents[i] of it.
AssetContents with_chain(const std::vector<std::uint32_t>& parents) {
  const AssetContents whole = small_asset();
  AssetContents contents;
  contents.skeleton = whole.skeleton;
  contents.bones = {whole.bones[0], whole.bones[1]};
  for (const std::uint32_t parent : parents) {
    BoneRecord bone = whole.bones[2];
    bone.colliders = 0;
    if (parent != kRoot) {
      bone.parent = 2 + parent;
      const BoneRecord& above = contents.bones[bone.parent];
      bone.joint[1] = above.joint[1] - above.length;
    }
    contents.bones.push_back(bone);
  }
  contents.chains = {{2, std::uint32_t(parents.size()), 1, {}}};
  contents.dynamics.assign(contents.bones.size(), whole.dynamics[2]);
  return contents;
}

/// A comb: a stem of `stem` bones, each but the last with a tooth. Teeth come after the whole stem, from its tip
/// upwards or from its root downwards.
std::vector<std::uint32_t> comb(std::uint32_t stem, bool tip_first) {
  std::vector<std::uint32_t> parents = {kRoot};
  for (std::uint32_t b = 1; b < stem; ++b) parents.push_back(b - 1);
  for (std::uint32_t b = 0; b + 1 < stem; ++b) parents.push_back(tip_first ? stem - 2 - b : b);
  return parents;
}

/// The same comb depth first, teeth before the rest of the stem.
std::vector<std::uint32_t> comb_with_stem_last(std::uint32_t stem) {
  std::vector<std::uint32_t> parents = {kRoot};
  for (std::uint32_t b = 1, above = 0; b < stem; ++b) {
    parents.push_back(above);
    parents.push_back(above);
    above = std::uint32_t(parents.size()) - 1;
  }
  return parents;
}

TEST(OpenChains, EachBeginsWhereTheOneBeforeItEnds) {
  for (const std::uint32_t first : {0u, 1u, 3u, 5u, 0x40000000u, kNone}) {
    EXPECT_EQ(refusal([&](AssetContents& contents) { contents.chains[0].first_bone = first; }), LoadCode::kChainCover)
        << first;
  }
}

/// Bone 3 starts at the particle of bone 2: a joint is off by what rounding may do and no more.
TEST(OpenBones, StartAtTheirParentsParticleToATenthOfAMillimetre) {
  const auto moved = [](float metres, int axis) {
    return refusal([&](AssetContents& contents) { contents.bones[3].joint[axis] += metres; });
  };
  for (const int axis : {0, 1, 2}) {
    for (const float sign : {-1.0f, 1.0f}) {
      EXPECT_EQ(moved(sign * 0.5e-4f, axis), LoadCode::kOk) << axis;
      EXPECT_EQ(moved(sign * 3e-4f, axis), LoadCode::kBoneJoint) << axis;
    }
  }
}

/// A set has a bit for each collider: all of them may be there, and no bit beyond, however many there are.
TEST(OpenColliders, SetsNameThoseThatThereAre) {
  for (std::size_t count = 0; count <= kMaxColliders; ++count) {
    const auto with_set = [&](std::uint32_t set) {
      AssetContents contents = small_asset();
      contents.colliders.assign(count, contents.colliders[0]);
      for (BoneRecord& bone : contents.bones) bone.colliders = 0;
      contents.bones[2].colliders = set;
      return open_written(contents).code;
    };
    const std::uint32_t all = count == 32 ? ~0u : (1u << count) - 1;
    EXPECT_EQ(with_set(all), LoadCode::kOk) << count;
    for (std::size_t bit = count; bit < 32; ++bit) {
      EXPECT_EQ(with_set(1u << bit), LoadCode::kColliderSet) << count << " colliders, bit " << bit;
    }
  }
}

TEST(OpenChains, SixteenBonesMayWaitForTheirChildrenAndNoMore) {
  for (const bool tip_first : {true, false}) {
    EXPECT_EQ(open_written(with_chain(comb(kMaxOpenBones + 1, tip_first))).code, LoadCode::kOk);
    const LoadStatus status = open_written(with_chain(comb(kMaxOpenBones + 2, tip_first)));
    EXPECT_EQ(status.code, LoadCode::kOpenBones);
    EXPECT_EQ(status.chunk, chunk::kChains);
    EXPECT_EQ(status.expected, kMaxOpenBones);
  }
}

TEST(OpenChains, ABoneThatOpensWhereAnotherClosesCountsBesideIt) {
  // The stem's tip gets a child of its own: at the tip, all of the stem before it and the tip are open.
  std::vector<std::uint32_t> parents = comb(kMaxOpenBones, true);
  parents.insert(parents.begin() + kMaxOpenBones, kMaxOpenBones - 1);
  EXPECT_EQ(open_written(with_chain(parents)).code, LoadCode::kOk);
  parents = comb(kMaxOpenBones + 1, true);
  parents.insert(parents.begin() + kMaxOpenBones + 1, kMaxOpenBones);
  EXPECT_EQ(open_written(with_chain(parents)).code, LoadCode::kOpenBones);
}

TEST(OpenChains, LongAndWideChainsAreFineDepthFirst) {
  std::vector<std::uint32_t> path = {kRoot};
  for (std::uint32_t b = 1; b < 1000; ++b) path.push_back(b - 1);
  EXPECT_EQ(open_written(with_chain(path)).code, LoadCode::kOk);
  EXPECT_EQ(open_written(with_chain(comb_with_stem_last(1000))).code, LoadCode::kOk);
  std::vector<std::uint32_t> broom(1000, 0);
  broom[0] = kRoot;
  EXPECT_EQ(open_written(with_chain(broom)).code, LoadCode::kOk) << "one bone with many children is one bone";
  EXPECT_EQ(open_written(with_chain(std::vector<std::uint32_t>(1000, kRoot))).code, LoadCode::kOk);
}

// What open() demands of colliders and of the bones' sets of them. small_asset() has an ellipsoid, a capsule that keeps
// hair inside, a plane and a tapered capsule; bone 2 may touch all, bone 3 the capsule.

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

/// Within 1e-4 of the size, which is a metre, the parent's length and how far away it is.
TEST(OpenBones, StartWhereTheirParentsEnd) {
  for (const float far : {0.0f, 30.0f, -2000.0f}) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto off_by = [&](float share) {
        return refusal([&](AssetContents& a) {
          BoneRecord &parent = a.bones[2], &bone = a.bones[3];
          for (int k = 0; k < 3; ++k) {
            parent.joint[k] += far;
            bone.joint[k] = parent.joint[k] + parent.rest_direction[k] * parent.length;
          }
          bone.joint[axis] += share * (1 + parent.length + std::fabs(bone.joint[axis]));
        });
      };
      for (const float within : {0.0f, 0.97e-4f, -0.97e-4f}) EXPECT_EQ(off_by(within), LoadCode::kOk) << far;
      for (const float beyond : {1.05e-4f, -1.05e-4f, 1.0f}) EXPECT_NE(off_by(beyond), LoadCode::kOk) << far;
    }
  }
}

TEST(OpenColliders, RefusesReservedFieldsInUse) {
  EXPECT_EQ(refusal([](auto& a) { a.colliders[1].reserved = 1; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.skeleton.flags = kSkeletonFacesBackwards << 1; }), LoadCode::kReserved);
  for (const float lag : {-0.1f, 1.1f, kNan}) {
    EXPECT_EQ(refusal([lag](auto& a) { a.skeleton.air_lag = lag; }), LoadCode::kNotFinite) << lag;
  }
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

}  // namespace coif::open_rig_test
