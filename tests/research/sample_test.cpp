#include "cook/cook.h"
#include "import/import.h"
#include "mannequin/head_shape.h"
#include "mannequin/portrait_head.h"
#include "models/cook_fingerprint.h"
#include "models/small_asset.h"
#include "research/sample/bob.h"
#include "research/sample/long.h"
#include "research/sample/strips.h"
#include "research/sample_meshes.h"

#include <coif/asset.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace coif::research::sample_test {

using Eigen::Vector3d;

TEST(Sample, IsTheCommittedFile) {
  const std::vector<std::uint8_t> committed = read_bytes(COIF_SAMPLE_ASSETS "/bob/bob.glb");
  ASSERT_FALSE(committed.empty()) << COIF_SAMPLE_ASSETS "/bob/bob.glb is absent";
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(committed)), make_bob()))
      << "renew it: coif_make_sample sample_assets/bob/bob.glb";
}

TEST(Sample, StaysBelow1100Kilobytes) { EXPECT_LT(make_bob().size(), 1100000u); }

TEST(Sample, HairHas2870TrianglesIn25ConnectedGroups) {
  const mannequin::SurfaceMesh hair = make_bob_hair();
  EXPECT_EQ(hair.triangles.size(), 3u * 2870u);
  const std::vector<std::uint32_t> group = connected_groups(hair);
  EXPECT_EQ(std::set<std::uint32_t>(group.begin(), group.end()).size(), 25u);
}

TEST(Sample, NoTwoGroupsShareAPosition) { EXPECT_EQ(groups_that_touch(make_bob_hair()), 0u); }

TEST(Sample, HairStaysOutsideTheHead) {
  for (const Vector3d& p : points_of(make_bob_hair())) EXPECT_GT(mannequin::head_distance(p), 0.001) << p.transpose();
}

TEST(Sample, HairStaysOutsideThePortrait) {
  for (const Vector3d& p : points_of(make_bob_hair())) {
    const Vector3d own = kBobHead.unplaced(p);
    EXPECT_GT(kBobHead.scale * mannequin::portrait_distance(own), 0.001) << p.transpose();
    EXPECT_GT(kBobHead.scale * mannequin::garment_distance(own), 0.001) << p.transpose();
  }
}

TEST(Sample, HeadFitUndoesItself) {
  const Vector3d point(0.03, 1.606, 0.08);
  EXPECT_LT((kBobHead.unplaced(kBobHead.placed(point)) - point).norm(), 1e-12);
  EXPECT_LT((HeadFit{}.placed(point) - point).norm(), 1e-12);
}

TEST(Sample, ShowsThePortraitWithItsEyesOnHeadNeckAndRoot) {
  const auto model = importer::import_model(COIF_SAMPLE_ASSETS "/bob/bob.glb");
  ASSERT_TRUE(model) << model.error().message;
  std::vector<std::string> names;
  for (const importer::SourceMesh& mesh : model->meshes) {
    names.push_back(mesh.name);
    if (mesh.name == "hair") continue;
    for (const importer::SourceInfluence& influence : mesh.influences) {
      const std::string& node = model->nodes[influence.node].name;
      EXPECT_TRUE(node == "Head" || node == "neck" || node == "root") << mesh.name << " on " << node;
    }
  }
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"eyes", "hair", "lashes", "scalp", "shirt", "skin"}));
}

TEST(Thinned, KeepsTheFormAndWhatHasNoCell) {
  const mannequin::SurfaceMesh bust = mannequin::make_bust();
  const auto same = mannequin::thinned(bust, [](const Vector3d&) { return 0.0; });
  EXPECT_EQ(same.positions, bust.positions);
  const auto coarse = mannequin::thinned(bust, [](const Vector3d&) { return 0.012; });
  EXPECT_LT(coarse.positions.size(), bust.positions.size() / 2);
  for (const Vector3d& p : coarse.positions) EXPECT_LT(std::abs(mannequin::head_distance(p)), 0.003) << p.transpose();
  for (std::size_t t = 0; t < coarse.triangles.size() / 3; ++t) {
    const Vector3d turn =
        (corner(coarse, t, 1) - corner(coarse, t, 0)).cross(corner(coarse, t, 2) - corner(coarse, t, 0));
    Vector3d normal = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) normal += coarse.normals[coarse.triangles[3 * t + k]];
    EXPECT_GT(turn.dot(normal), 0.0) << "triangle " << t;
  }
}

TEST(Sample, DeclaredHeadLiesInsideTheHair) {
  const DeclaredHead head(COIF_SAMPLE_ASSETS "/bob/bob.recipe.json");
  for (const Vector3d& p : points_of(make_bob_hair())) EXPECT_GT(head.level(p), 1.0) << p.transpose();
}

TEST(Sample, TrianglesTurnTheSameWayAsTheirNormals) {
  for (const mannequin::SurfaceMesh& mesh :
       {make_bob_hair(), mannequin::make_bust(), mannequin::make_bare_head(), mannequin::make_scalp_cap()}) {
    for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
      const Vector3d turn = (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
      Vector3d normal = Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) normal += mesh.normals[mesh.triangles[3 * t + k]];
      EXPECT_GT(turn.dot(normal), 0.0) << "triangle " << t;
    }
  }
}

TEST(Sample, HairFacesAwayFromTheHead) {
  const mannequin::SurfaceMesh hair = make_bob_hair();
  for (std::size_t i = 0; i < hair.positions.size(); ++i) {
    const Vector3d& p = hair.positions[i];
    const Vector3d inside{mannequin::kCraniumCenter.x(), std::min(p.y(), mannequin::kCraniumCenter.y()),
                          mannequin::kCraniumCenter.z()};
    EXPECT_NEAR(hair.normals[i].norm(), 1.0, 1e-9);
    EXPECT_GT(hair.normals[i].dot(p - inside), 0.0) << "vertex " << i;
  }
}

TEST(Sample, HeadsAreClosed) {
  for (const mannequin::SurfaceMesh& head : {mannequin::make_bust(), mannequin::make_bare_head()}) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::size_t i = 0; i < head.triangles.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) ++uses[{head.triangles[i + k], head.triangles[i + (k + 1) % 3]}];
    ASSERT_FALSE(uses.empty());
    for (const auto& [edge, count] : uses) {
      const auto opposite = uses.find({edge.second, edge.first});
      EXPECT_TRUE(opposite != uses.end() && opposite->second == count) << edge.first << " to " << edge.second;
    }
  }
}

TEST(Sample, SkeletonHasThreeChainsOfThreeBonesUnderScalpBones) {
  const std::vector<Joint> joints = make_bob_skeleton();
  const auto parent_name = [&joints](const std::string& name) {
    const auto at = std::find_if(joints.begin(), joints.end(), [&](const Joint& j) { return j.name == name; });
    if (at == joints.end() || at->parent < 0) return std::string();
    return joints[static_cast<std::size_t>(at->parent)].name;
  };
  EXPECT_EQ(joints.size(), 3u + 3u * 5u);
  for (const std::string side : {"left", "back", "right"}) {
    EXPECT_EQ(parent_name("hair_" + side + "_3_end"), "hair_" + side + "_3");
    EXPECT_EQ(parent_name("hair_" + side + "_3"), "hair_" + side + "_2");
    EXPECT_EQ(parent_name("hair_" + side + "_2"), "hair_" + side + "_1");
    EXPECT_EQ(parent_name("hair_" + side + "_1"), "scalp_" + side);
    EXPECT_EQ(parent_name("scalp_" + side), "Head");
  }
}

TEST(Sample, WeightsAddUpToOneAndEveryBoneButTheEndsCarriesHair) {
  const std::vector<Joint> joints = make_bob_skeleton();
  std::vector<double> carried(joints.size());
  for (const Vector3d& p : make_bob_hair().positions) {
    const mannequin::SkinInfluences skin = hair_influences(p);
    EXPECT_EQ(std::accumulate(skin.weights.begin(), skin.weights.end(), 0.0), 1.0);
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_LT(skin.joints[k], joints.size());
      EXPECT_GE(skin.weights[k], 0.0);
      carried[skin.joints[k]] += skin.weights[k];
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string& name = joints[i].name;
    const bool is_end = name.ends_with("_end");
    const bool is_hair = name.starts_with("hair_") || name.starts_with("scalp_");
    EXPECT_EQ(carried[i] > 0.0, is_hair && !is_end) << name;
  }
}

TEST(Sample, WeightsChangeGraduallyAlongTheHair) {
  for (const double x : {-0.09, 0.0, 0.09}) {
    std::map<int, double> before;
    for (double y = 1.70; y > 1.43; y -= 0.001) {
      const mannequin::SkinInfluences skin = hair_influences({x, y, -0.08});
      std::map<int, double> now;
      for (std::size_t k = 0; k < 4; ++k) now[skin.joints[k]] += skin.weights[k];
      if (before.empty()) before = now;
      for (const auto& [joint, weight] : now)
        EXPECT_NEAR(weight, before[joint], 0.05) << "joint " << joint << " at y " << y;
      before = now;
    }
  }
}

/// Share of texels in rows [from, to) of the texture, as parts of its height, whose alpha is at least `alpha`.
double share_of_texels(const StrandTexture& texture, double from, double to, int alpha) {
  const auto begin = static_cast<std::size_t>(from * StrandTexture::kHeight) * StrandTexture::kWidth;
  const auto end = static_cast<std::size_t>(to * StrandTexture::kHeight) * StrandTexture::kWidth;
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) count += texture.rgba[4 * i + 3] >= alpha;
  return static_cast<double>(count) / static_cast<double>(end - begin);
}

TEST(Sample, TextureIsOpaqueAboveAndEndsInSeparateStrands) {
  const StrandTexture texture = make_strand_texture();
  EXPECT_GT(share_of_texels(texture, 0.05, 0.60, 255), 0.85);
  EXPECT_GT(share_of_texels(texture, 0.85, 0.90, 128), 0.05);
  EXPECT_LT(share_of_texels(texture, 0.85, 0.90, 128), 0.60);
  EXPECT_EQ(share_of_texels(texture, 0.999, 1.0, 1), 0.0) << "the last row must be clear, or clamping draws it on";
}

TEST(Sample, TextureKeepsItsColorUnderTransparentTexels) {
  const StrandTexture texture = make_strand_texture();
  for (std::size_t i = 0; i < texture.rgba.size(); i += 4) ASSERT_GT(texture.rgba[i], 20) << "texel " << i / 4;
}

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
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(committed)), make_long()))
      << "renew it: coif_make_sample long sample_assets/long/long.glb";
}

TEST(LongSample, CooksWithoutWarningsIntoAHundredChainsOfSixteenBones) {
  const auto source = importer::import_model(kFolder + "long.glb");
  ASSERT_TRUE(source) << source.error().message;
  auto recipe = cook::read_recipe(kFolder + "long.recipe.json");
  ASSERT_TRUE(recipe) << recipe.error().message;
  recipe->order_method = cook::OrderMethod::kHead;  // spares the search for orders, which says nothing of chains
  const auto cooked = cook::cook(*source, *recipe, {.threads = 2, .recipe_directory = {}});
  ASSERT_TRUE(cooked) << cooked.error().message;
  EXPECT_TRUE(cooked->report.warnings.empty()) << cooked->report.warnings[0].message;
  AlignedBytes file(cooked->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.bones().size(), 1u + 3u + 1600u) << "head, scalp, chains";
  ASSERT_EQ(asset.chains().size(), 100u);
  for (const ChainRecord& chain : asset.chains()) EXPECT_EQ(chain.bone_count, 16u);
  EXPECT_TRUE(is_cooked_as_before("long", asset));
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
      EXPECT_GT(mannequin::bare_head_distance(p), 0.0) << p.transpose();
    }
  }
}

TEST(LongSample, HairStaysOutsideTheHead) {
  for (const Vector3d& p : points_of(make_long_hair(make_locks()))) {
    EXPECT_GT(mannequin::bare_head_distance(p), 0.001) << p.transpose();
  }
}

TEST(LongSample, HairIs20000TrianglesIn200GroupsThatShareNoPosition) {
  const mannequin::SurfaceMesh hair = make_long_hair(make_locks());
  EXPECT_EQ(hair.triangles.size(), 3u * 20000u);
  const std::vector<std::uint32_t> group = connected_groups(hair);
  EXPECT_EQ(std::set<std::uint32_t>(group.begin(), group.end()).size(), 200u);
  EXPECT_EQ(groups_that_touch(hair), 0u);
}

TEST(LongSample, WeightsAddUpToOneAndEveryBoneButTheEndsCarriesHair) {
  const std::vector<Lock> locks = make_locks();
  std::vector<double> carried(make_long_skeleton(locks).size());
  for (const mannequin::SkinInfluences& skin : make_long_hair(locks).skin) {
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
    const mannequin::SkinInfluences skin = lock_influences(locks, 3, 4, 0.4, along);
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

}  // namespace coif::research::sample_test
