#include "cook/rig/skeleton.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/colliders.h"
#include "cook/select/head.h"
#include "cook/select/select_hair.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coif::cook::skeleton_test {

tl::expected<Skeleton, ToolError> skeleton_of(const importer::SourceModel& model,
                                              const Recipe& recipe = default_recipe(), Findings& findings = unheard()) {
  const auto hair = select_hair(model, recipe, unheard());
  EXPECT_TRUE(hair) << hair.error().message;
  const auto head = find_head_bone(model, *hair, recipe.head_bone);
  if (!head) return tl::unexpected(head.error());
  return build_skeleton(model, *hair, *head, recipe, findings);
}

FittedHead head_of(const importer::SourceModel& model, const Recipe& recipe = default_recipe()) {
  const auto hair = select_hair(model, recipe, unheard());
  EXPECT_TRUE(hair) << hair.error().message;
  const auto head = find_head_bone(model, *hair, recipe.head_bone);
  EXPECT_TRUE(head) << head.error().message;
  return fit_head(model, *hair, *head, recipe, unheard());
}

TEST(BuildSkeleton, SplitsHeadScalpAndSimulatedBonesAsTheThesisDoes) {
  const auto skeleton = skeleton_of(make_wig());
  ASSERT_TRUE(skeleton);
  ASSERT_EQ(skeleton->bones.size(), 4u);
  EXPECT_EQ(skeleton->bones[0].name, "Head");
  EXPECT_EQ(skeleton->bones[0].kind, BoneKind::kHead);
  EXPECT_EQ(skeleton->bones[1].name, "scalp");
  EXPECT_EQ(skeleton->bones[1].kind, BoneKind::kScalp);
  EXPECT_EQ(skeleton->bones[2].kind, BoneKind::kSimulated);
  ASSERT_EQ(skeleton->chains.size(), 1u);
  EXPECT_EQ(skeleton->chains[0].first_bone, 2u);
  EXPECT_EQ(skeleton->chains[0].bone_count, 2u);
  EXPECT_EQ(skeleton->chains[0].root, 1u);
}

TEST(BuildSkeleton, BonesEndAtTheNextJointAndTheLastAtItsEndMarker) {
  const auto skeleton = skeleton_of(make_wig());
  ASSERT_TRUE(skeleton);
  EXPECT_NEAR((skeleton->bones[2].tail - Eigen::Vector3d(0, 1.5, -0.1)).norm(), 0, 1.0e-9);
  EXPECT_NEAR((skeleton->bones[3].tail - Eigen::Vector3d(0, 1.4, -0.1)).norm(), 0, 1.0e-9);
  EXPECT_NEAR(skeleton->bones[2].place, 0.5, 1.0e-9);
  EXPECT_NEAR(skeleton->bones[3].place, 1.0, 1.0e-9);
}

TEST(BuildSkeleton, WithoutAnEndMarkerTheLastBoneEndsWithItsVertices) {
  importer::SourceModel model = make_wig();
  model.nodes.pop_back();
  const auto skeleton = skeleton_of(model);
  ASSERT_TRUE(skeleton);
  EXPECT_NEAR(skeleton->bones[3].tail.y(), 1.4, 0.005) << "the strip ends at 1.4 m";
}

TEST(BuildSkeleton, AMarkerFarBeforeTheEndOfTheHairMarksNoEnd) {
  for (const double share : {0.15, 0.3, 0.5, 0.8}) {
    importer::SourceModel model = make_wig();
    model.nodes.back().model_from_node.translation() = Eigen::Vector3d(0, 1.5 - 0.1 * share, -0.1);
    const auto skeleton = skeleton_of(model);
    ASSERT_TRUE(skeleton);
    EXPECT_NEAR(skeleton->bones[3].tail.y(), share < 0.4 ? 1.4 : 1.5 - 0.1 * share, 0.005) << share;
  }
}

TEST(BuildSkeleton, WhatABoneCarriesByHalfIsItsOwn) {
  importer::SourceModel model = make_wig();
  model.nodes.pop_back();
  importer::SourceMesh& mesh = model.meshes[0];
  const auto tail = [&](float weight) {
    // The lowest vertices, with this much of their weight on the last bone.
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      if (mesh.positions[v].y() > 1.41f) continue;
      for (std::uint32_t k = mesh.influence_begin[v]; k < mesh.influence_begin[v + 1]; ++k)
        mesh.influences[k].weight = 0;
      mesh.influences[mesh.influence_begin[v]] = {4, weight};
    }
    return skeleton_of(model)->bones[3].tail.y();
  };
  EXPECT_NEAR(tail(0.52f), tail(1.0f), 1.0e-6);
  EXPECT_GT(tail(0.48f), tail(1.0f) + 0.01);
}

/// The wig, whose end marker (node 5) has this much of the vertices at the end of the last bone (node 4).
tl::expected<Skeleton, ToolError> skeleton_with_end_weight(float weight) {
  importer::SourceModel model = make_wig();
  importer::SourceMesh& mesh = model.meshes[0];
  std::vector<importer::SourceInfluence> influences;
  std::vector<std::uint32_t> begin{0};
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].y() > 1.45f) {
      influences.insert(influences.end(), mesh.influences.begin() + mesh.influence_begin[v],
                        mesh.influences.begin() + mesh.influence_begin[v + 1]);
    } else {
      influences.push_back({4, 1 - weight});
      influences.push_back({5, weight});
    }
    begin.push_back(std::uint32_t(influences.size()));
  }
  mesh.influences = influences;
  mesh.influence_begin = begin;
  return skeleton_of(model);
}

TEST(BuildSkeleton, AnEndMarkerThatSmoothingGaveSomeSkinIsNoBone) {
  const auto skeleton = skeleton_with_end_weight(0.3f);
  ASSERT_TRUE(skeleton);
  EXPECT_EQ(skeleton->bones.size(), 4u) << "or the last bone points back up, as stiff as it is short";
  EXPECT_EQ(skeleton->bone_of_node[5], 3u) << "its share moves with the bone above";
  EXPECT_NEAR((skeleton->bones[3].tail - Eigen::Vector3d(0, 1.4, -0.1)).norm(), 0, 1.0e-9);
  const auto heavy = skeleton_with_end_weight(0.7f);
  ASSERT_TRUE(heavy);
  EXPECT_EQ(heavy->bones.size(), 5u) << "what is mostly its own it moves";
}

/// Where the bone of node 0 ends that starts at the origin below one that comes from the side, 0.2 m. It has so much of
/// one vertex 0.1 m below and of another 0.2 m below.
Eigen::Vector3d tail_by_weights(float upper, float lower) {
  importer::SourceModel model;
  add_node(model, "hair", importer::kNoIndex, {0, 0, 0});
  HairMesh hair;
  hair.positions = {{0, -0.1f, 0}, {0, -0.2f, 0}};
  hair.influences = {{0, upper}, {0, lower}};
  hair.influence_begin = {0, 1, 2};
  SkeletonBone parent;
  parent.start = {-0.2, 0, 0};
  return find_bone_tail(model, hair, 0, {}, Eigen::Vector3d::Zero(), parent);
}

TEST(FindBoneTail, ABoneHasWhatItCarriesByHalfElseHalfAsMuchAsOfItsHeaviest) {
  EXPECT_NEAR(tail_by_weights(1.0f, 0.3f).y(), -0.1, 1.0e-6);
  EXPECT_NEAR(tail_by_weights(0.52f, 0.3f).y(), -0.1, 1.0e-6);
  EXPECT_NEAR(tail_by_weights(0.48f, 0.3f).y(), -0.2, 1.0e-6);
  EXPECT_NEAR(tail_by_weights(0.48f, 0.2f).y(), -0.1, 1.0e-6);
}

TEST(FindBoneTail, WithoutVerticesItIsAsFarAgainAsTheParent) {
  EXPECT_NEAR((tail_by_weights(0, 0) - Eigen::Vector3d(0.2, 0, 0)).norm(), 0, 1.0e-9);
}

TEST(BuildSkeleton, ABoneAloneBelowTheHeadIsSimulated) {
  importer::SourceModel model = make_wig();
  for (importer::SourceInfluence& influence : model.meshes[0].influences) influence.node = 2;
  const auto skeleton = skeleton_of(model);
  ASSERT_TRUE(skeleton);
  ASSERT_EQ(skeleton->bones.size(), 2u);
  EXPECT_EQ(skeleton->bones[1].kind, BoneKind::kSimulated);
  EXPECT_EQ(skeleton->chains[0].root, 0u);
}

TEST(BuildSkeleton, TheRecipeMovesTheBorderBetweenScalpAndChain) {
  Recipe recipe = default_recipe();
  recipe.scalp = ScalpRule::kNoScalp;
  EXPECT_EQ(skeleton_of(make_wig(), recipe)->chains[0].bone_count, 3u);
  recipe.scalp = ScalpRule::kPattern;
  recipe.scalp_bones = {"scalp", "HAIR_1"};
  EXPECT_EQ(skeleton_of(make_wig(), recipe)->chains[0].bone_count, 1u);
}

TEST(BuildSkeleton, BranchesHangFromTheirParentsParticle) {
  importer::SourceModel model = make_wig();
  const std::uint32_t branch = add_node(model, "branch", 3, {0.05, 1.52, -0.1});
  add_node(model, "branch_end", branch, {0.1, 1.45, -0.1});
  model.meshes[0].influences.back().node = branch;
  const auto skeleton = skeleton_of(model);
  ASSERT_TRUE(skeleton);
  ASSERT_EQ(skeleton->bones.size(), 5u);
  EXPECT_EQ(skeleton->chains.size(), 1u) << "a tree is one chain";
  const SkeletonBone& bone = skeleton->bones[4];
  EXPECT_EQ(bone.name, "branch");
  EXPECT_EQ(bone.parent, 2u);
  EXPECT_EQ(bone.start, skeleton->bones[2].tail);
}

TEST(BuildSkeleton, FindsTheHeadAmongItsNamesakes) {
  importer::SourceModel model = make_wig();
  model.nodes[1].name = "mixamorig:Head";
  add_node(model, "mixamorig:HeadTop_End", 1, {0, 1.8, 0});
  add_node(model, "Headphones", 0, {0, 1.7, 0});
  EXPECT_EQ(skeleton_of(model)->bones[0].name, "mixamorig:Head");
}

TEST(BuildSkeleton, TheRecipeNamesTheHeadByAPattern) {
  importer::SourceModel model = make_wig();
  model.nodes[1].name = "rig:Kopf_01";
  Recipe recipe = default_recipe();
  recipe.head_bone = "*:Kopf_??";
  EXPECT_EQ(skeleton_of(model, recipe)->bones[0].name, "rig:Kopf_01");
}

TEST(BuildSkeleton, AHeadThatIsNotThereIsAnErrorWithACure) {
  Recipe recipe = default_recipe();
  recipe.head_bone = "Kopf";
  const auto skeleton = skeleton_of(make_wig(), recipe);
  ASSERT_FALSE(skeleton);
  EXPECT_EQ(skeleton.error().message,
            "wig.glb: recipe key \"skeleton.head\": no node is called 'Kopf'; 'coif cook wig.glb --list' names them");
}

TEST(BuildSkeleton, HairWithoutBonesFollowsTheHeadWithAWarning) {
  importer::SourceModel model = make_wig();
  model.meshes[0].influences.clear();
  model.meshes[0].influence_begin.clear();
  Findings findings;
  const auto skeleton = skeleton_of(model, default_recipe(), findings);
  ASSERT_TRUE(skeleton);
  EXPECT_EQ(skeleton->bones.size(), 1u);
  EXPECT_EQ(skeleton->bones[0].name, "Head");
  ASSERT_EQ(findings.warnings.size(), 1u);
  EXPECT_NE(findings.warnings[0].message.find("rigidly"), std::string::npos);
}

TEST(BuildSkeleton, JointsOnTopOfEachOtherStillGiveBones) {
  importer::SourceModel model = make_wig();
  for (std::size_t n = 3; n < model.nodes.size(); ++n) model.nodes[n].model_from_node = model.nodes[3].model_from_node;
  const auto skeleton = skeleton_of(model);
  ASSERT_TRUE(skeleton);
  for (const SkeletonBone& bone : skeleton->bones) {
    if (bone.kind == BoneKind::kSimulated) {
      EXPECT_GE(bone.length(), 0.99e-3);
    }
  }
}

TEST(BuildSkeleton, MoreBonesThanAnAssetHoldsIsUnsupported) {
  importer::SourceModel model = make_wig();
  std::uint32_t node = 4;
  for (int i = 0; i < 5000; ++i) node = add_node(model, "long", node, {0, 1.4 - 0.001 * i, -0.1});
  model.meshes[0].influences.back().node = node;
  const auto skeleton = skeleton_of(model);
  ASSERT_FALSE(skeleton);
  EXPECT_EQ(skeleton.error().kind, ToolError::Kind::kUnsupported);
}

TEST(HeadColliders, HaveTheShapeThatTheRecipeWants) {
  const importer::SourceModel wig = make_wig();
  Recipe recipe = default_recipe();
  recipe.head_center = {0, 1.6, 0};
  recipe.head_radii = {0.05, 0.08, 0.06};
  const auto shape = [&](HeadShape wanted) {
    recipe.head_shape = wanted;
    return head_colliders(head_of(wig, recipe), *skeleton_of(wig), unheard()).shapes.at(0);
  };
  EXPECT_EQ(shape(HeadShape::kAuto).shape, ColliderShape::kEllipsoid);
  EXPECT_EQ(shape(HeadShape::kSphere).shape, ColliderShape::kSphere);
  const HeadCollider capsule = shape(HeadShape::kCapsule);
  EXPECT_EQ(capsule.shape, ColliderShape::kCapsule);
  EXPECT_NEAR(capsule.center.y() - capsule.radii.x(), 1.52, 1.0e-9) << "as low as the ellipsoid";
  EXPECT_NEAR(capsule.center.y() + capsule.axis.y() + capsule.radii.x(), 1.68, 1.0e-9) << "as high";
}

TEST(HeadColliders, AHeadThatShrinksFarEnoughSaysNothingOfBonesInside) {
  Skeleton skeleton = *skeleton_of(make_wig());
  skeleton.bones[3].tail = skeleton.bones[2].tail;
  FittedHead head;
  head.radii.setConstant(0.25);
  for (const auto& [share, inside] : {std::pair{0.75, false}, {0.5, false}, {0.4, true}}) {
    head.center = skeleton.bones[2].tail + Eigen::Vector3d(0, 0, share * 0.25);
    Findings findings;
    (void)head_colliders(head, skeleton, findings);
    ASSERT_EQ(findings.warnings.size(), 1u);
    const std::string percent = share == 0.75 ? "75 %" : "50 %";
    EXPECT_NE(findings.warnings[0].message.find("shrunk to " + percent), std::string::npos)
        << findings.warnings[0].message;
    EXPECT_EQ(findings.warnings[0].message.find("still end inside") != std::string::npos, inside)
        << findings.warnings[0].message;
  }
}

TEST(ColliderReach, BonesThatCannotGetThereAreNeverTested) {
  Skeleton skeleton = *skeleton_of(make_wig());
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii.setConstant(0.05);
  Colliders near = head_colliders(head, skeleton, unheard());
  drop_colliders_out_of_reach(skeleton, near);
  EXPECT_EQ(near.of_bone.at(2), 1u) << "0.1 m long, 0.05 m away";
  head.center.x() = 1;
  Colliders far = head_colliders(head, skeleton, unheard());
  drop_colliders_out_of_reach(skeleton, far);
  for (const std::uint32_t set : far.of_bone) EXPECT_EQ(set, 0u);
  // Halfway: the chain's end gets there, its first bone does not.
  head.center.x() = 0.22;
  Colliders between = head_colliders(head, skeleton, unheard());
  drop_colliders_out_of_reach(skeleton, between);
  EXPECT_EQ(between.of_bone.at(2), 0u);
  EXPECT_EQ(between.of_bone.at(3), 1u);
}

TEST(ColliderReach, RestPenetrationIsReportedWithItsDepth) {
  const Skeleton skeleton = *skeleton_of(make_wig());
  Colliders colliders;
  colliders.of_bone = {0, 0, 1, 1};
  colliders.hit_radius = {0, 0, 0, 0.02};
  HeadCollider ball;
  ball.center = skeleton.bones[3].tail + Eigen::Vector3d(0.05, 0, 0);
  ball.radii.setConstant(0.04);
  colliders.shapes.push_back(ball);
  Findings findings;
  report_rest_penetration(skeleton, colliders, "collider", "cure", findings);
  ASSERT_EQ(findings.warnings.size(), 1u);
  EXPECT_NE(findings.warnings[0].message.find("1 bones are inside a collider at rest, 'hair_2' by 10.0 mm"),
            std::string::npos)
      << findings.warnings[0].message;
}

TEST(SkinWeights, AddUpTo255AndKeepTheHeaviestFour) {
  std::mt19937 engine(3);
  const auto random = [&] { return std::uint32_t(engine()); };
  HairMesh mesh;
  Skeleton skeleton;
  skeleton.bones.resize(8);
  for (std::uint32_t n = 0; n < 8; ++n) skeleton.bone_of_node.push_back(n);
  mesh.influence_begin.push_back(0);
  for (int v = 0; v < 500; ++v) {
    mesh.positions.emplace_back(0, 0, 0);
    const std::uint32_t count = random() % 7;
    for (std::uint32_t k = 0; k < count; ++k)
      mesh.influences.push_back({random() % 8, float(1 + random() % 1000) / 1000});
    mesh.influence_begin.push_back(std::uint32_t(mesh.influences.size()));
  }
  for (const SkinRecord& skin : quantize_skin(weights_of_source(mesh, skeleton))) {
    EXPECT_EQ(skin.weight[0] + skin.weight[1] + skin.weight[2] + skin.weight[3], 255);
    EXPECT_GE(skin.weight[0], skin.weight[3]);
  }

  mesh.positions = {Eigen::Vector3f::Zero()};
  mesh.influences = {{5, 0.1f}, {4, 0.2f}, {1, 0.3f}, {2, 0.25f}, {7, 0.15f}};
  mesh.influence_begin = {0, 5};
  const SkinRecord skin = quantize_skin(weights_of_source(mesh, skeleton)).front();
  const std::uint32_t heaviest[4] = {1, 2, 4, 7};
  const double of_what_is_left[4] = {0.3 / 0.9, 0.25 / 0.9, 0.2 / 0.9, 0.15 / 0.9};
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(skin.bone[k], heaviest[k]);
    EXPECT_NEAR(skin.weight[k] / 255.0, of_what_is_left[k], 1.0 / 255);
  }
}

}  // namespace coif::cook::skeleton_test
