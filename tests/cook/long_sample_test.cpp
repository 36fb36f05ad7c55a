#include "cook/cook.h"
#include "cook/sample_meshes.h"
#include "formats/aligned_bytes.h"
#include "import/import.h"
#include "sample/head_shape.h"
#include "sample/long.h"
#include "sample/long_skeleton.h"
#include "sample/long_style.h"

#include <coif/asset.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace coif::sample {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kRigidJoints = 6, kJointsPerLock = kBonesPerLock + 1;

const std::string kFolder = COIF_SAMPLE_ASSETS "/long/";

/// Ends of each bone of the chains.
std::vector<std::pair<Vector3d, Vector3d>> bones_of(const std::vector<Joint>& joints) {
  std::vector<std::pair<Vector3d, Vector3d>> bones;
  for (std::size_t i = kRigidJoints; i < joints.size(); ++i) {
    const auto parent = std::size_t(joints[i].parent);
    if (parent >= kRigidJoints) bones.emplace_back(joints[parent].position, joints[i].position);
  }
  return bones;
}

TEST(LongSample, IsTheCommittedFile) {
  const std::vector<std::uint8_t> committed = read_bytes(kFolder + "long.glb");
  ASSERT_FALSE(committed.empty()) << kFolder << "long.glb is absent";
  EXPECT_TRUE(committed == make_long()) << "renew it: coif_make_sample long sample_assets/long/long.glb";
}

TEST(LongSample, CooksWithoutWarningsIntoAHundredChainsOfSixteenBones) {
  const auto source = import_model(kFolder + "long.glb");
  ASSERT_TRUE(source) << source.error().message;
  const auto recipe = read_recipe(kFolder + "long.recipe.json");
  ASSERT_TRUE(recipe) << recipe.error().message;
  const auto cooked = cook(*source, *recipe, {.threads = 2, .recipe_directory = {}});
  ASSERT_TRUE(cooked) << cooked.error().message;
  EXPECT_EQ(cooked->report.warnings, std::vector<std::string>());
  AlignedBytes file(cooked->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.bones().size(), 1u + 3u + 1600u) << "head, scalp, chains";
  ASSERT_EQ(asset.chains().size(), 100u);
  for (const ChainRecord& chain : asset.chains()) EXPECT_EQ(chain.bone_count, 16u);
}

TEST(LongSample, NamesItsBonesByLockAndPlace) {
  const std::vector<Joint> joints = make_long_skeleton(make_locks());
  ASSERT_EQ(joints.size(), kRigidJoints + 100u * kJointsPerLock);
  std::set<std::string> names;
  for (const Joint& joint : joints) names.insert(joint.name);
  EXPECT_EQ(names.size(), joints.size());
  for (const char* name : {"Head", "scalp_left", "Lock_001_01", "Lock_042_07", "Lock_100_16", "Lock_100_end"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(LongSample, BonesAreAboutFourCentimetresLong) {
  for (const auto& [start, end] : bones_of(make_long_skeleton(make_locks()))) {
    EXPECT_NEAR((end - start).norm(), 0.045, 0.015) << start.transpose();
  }
}

TEST(LongSample, ChainsLieOutsideTheDeclaredHead) {
  const DeclaredHead head(kFolder + "long.recipe.json");
  for (const auto& [start, end] : bones_of(make_long_skeleton(make_locks()))) {
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vector3d p = start + share * (end - start);
      EXPECT_GT(head.level(p), 1.0) << p.transpose();
      EXPECT_GT(bare_head_distance(p), 0.0) << p.transpose();
    }
  }
}

TEST(LongSample, HairStaysOutsideTheHead) {
  for (const Vector3d& p : points_of(make_long_hair(make_locks()))) {
    EXPECT_GT(bare_head_distance(p), 0.001) << p.transpose();
  }
}

TEST(LongSample, HairIs20000TrianglesIn200GroupsThatShareNoPosition) {
  const SurfaceMesh hair = make_long_hair(make_locks());
  EXPECT_EQ(hair.triangles.size(), 3u * 20000u);
  const std::vector<std::uint32_t> group = connected_groups(hair);
  EXPECT_EQ(std::set<std::uint32_t>(group.begin(), group.end()).size(), 200u);
  EXPECT_EQ(groups_that_touch(hair), 0u);
}

TEST(LongSample, WeightsAddUpToOneAndEveryBoneButTheEndsCarriesHair) {
  const std::vector<Lock> locks = make_locks();
  std::vector<double> carried(make_long_skeleton(locks).size());
  for (const SkinInfluences& skin : make_long_hair(locks).skin) {
    EXPECT_EQ(std::accumulate(skin.weights.begin(), skin.weights.end(), 0.0), 1.0);
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_LT(skin.joints[k], carried.size());
      EXPECT_GE(skin.weights[k], 0.0);
      carried[skin.joints[k]] += skin.weights[k];
    }
  }
  for (std::size_t i = 3; i < carried.size(); ++i) {
    const bool is_end = i >= kRigidJoints && (i - kRigidJoints) % kJointsPerLock == kBonesPerLock;
    EXPECT_EQ(carried[i] > 0.0, !is_end) << i;
  }
}

TEST(LongSample, WeightsChangeGraduallyAlongAChain) {
  const std::vector<Lock> locks = make_locks();
  std::vector<double> before;
  for (double along = -0.1; along <= 1.0; along += 0.002) {
    std::vector<double> now(make_long_skeleton(locks).size());
    const SkinInfluences skin = lock_influences(locks, 3, 4, 0.4, along);
    for (std::size_t k = 0; k < 4; ++k) now[skin.joints[k]] += skin.weights[k];
    if (before.empty()) before = now;
    for (std::size_t i = 0; i < now.size(); ++i)
      ASSERT_NEAR(now[i], before[i], 0.05) << "joint " << i << " at " << along;
    before = now;
  }
}

TEST(LongSample, RootsAreSpreadOverEachSideOfTheScalp) {
  std::vector<Vector3d> roots[2];  // both sides meet at the parting
  for (const Lock& lock : make_locks()) {
    roots[lock.course.azimuth < 180 ? 0 : 1].push_back(point_on_lock(lock.course, 0));
  }
  for (const auto& side : roots) {
    EXPECT_EQ(side.size(), 50u);
    for (const Vector3d& root : side) {
      double nearest = 1;
      for (const Vector3d& other : side) {
        if (&other != &root) nearest = std::min(nearest, (root - other).norm());
      }
      EXPECT_GT(nearest, 0.004) << root.transpose();
      EXPECT_LT(nearest, 0.030) << root.transpose();
    }
  }
}

}  // namespace
}  // namespace coif::sample
