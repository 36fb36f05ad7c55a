#include "cook/select/head.h"
#include "cook/recipe/recipe.h"

#include "cook/built_models.h"
#include "cook/rig/colliders.h"
#include "cook/rig/skeleton.h"
#include "cook/select/select_hair.h"
#include "platform/stop.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coif::cook::head_test {

using Eigen::Vector3d;
using Eigen::Vector3f;

FittedHead head_of(const importer::SourceModel& model, const Recipe& recipe = default_recipe(),
                   Findings& findings = unheard()) {
  const auto hair = select_hair(model, recipe, unheard());
  EXPECT_TRUE(hair) << hair.error().message;
  const auto head = find_head_bone(model, *hair, recipe.head_bone);
  EXPECT_TRUE(head) << head.error().message;
  return fit_head(model, *hair, *head, recipe, findings);
}

tl::expected<Skeleton, ToolError> skeleton_of(const importer::SourceModel& model) {
  const auto hair = select_hair(model, default_recipe(), unheard());
  return build_skeleton(model, *hair, *find_head_bone(model, *hair, ""), default_recipe(), unheard());
}

// A head as heads are, and hair all over it but for the face.

const HeadEllipsoid kHead{{0.01, 1.65, 0.02}, {0.075, 0.11, 0.095}};

struct Combed {
  double lift = 1.04;       ///< Where the hair lies, as a multiple of the head's size.
  double root_lift = 1.04;  ///< Where its first row lies, likewise.
  double lowest = -0.5;     ///< Height at which it ends, share of the radius.
  double face = 1.0;        ///< Radians to each side of the front that are left free below the crown.
};

importer::SourceMesh combed_hair(const Combed& combed) {
  importer::SourceMesh mesh;
  mesh.name = "hair";
  constexpr int kStrips = 40, kRows = 10;
  for (int s = 0; s < kStrips; ++s) {
    const double turn = 2 * std::numbers::pi * s / kStrips - std::numbers::pi;  // 0: the front
    const double lowest = std::abs(turn) < combed.face ? 0.6 : combed.lowest;
    for (int row = 0; row < kRows; ++row) {
      const double down = 0.1 + (std::acos(lowest) - 0.1) * row / (kRows - 1);
      for (const double side : {-0.09, 0.09}) {
        const Vector3d way(std::sin(down) * std::sin(turn + side), std::cos(down),
                           std::sin(down) * std::cos(turn + side));
        const double lift = row == 0 ? combed.root_lift : combed.lift;
        mesh.positions.push_back((kHead.center + lift * kHead.radii.cwiseProduct(way)).cast<float>());
      }
    }
  }
  for (int s = 0; s < kStrips; ++s) {
    for (int row = 0; row + 1 < kRows; ++row) {
      const auto v = std::uint32_t(2 * (s * kRows + row));
      mesh.triangles.insert(mesh.triangles.end(), {v, v + 2, v + 1, v + 1, v + 2, v + 3});
    }
  }
  return mesh;
}

HairMesh mesh_of(const Combed& combed) { return hair_from(combed_hair(combed)); }

importer::SourceModel model_of(const Combed& combed) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  model.meshes.push_back(combed_hair(combed));
  return model;
}

void expect_close(const HeadEllipsoid& head, double share) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(head.radii[k] / kHead.radii[k], 1, share) << "radius " << k;
    EXPECT_NEAR(head.center[k], kHead.center[k], share * kHead.radii[k]) << "centre " << k;
  }
}

TEST(HeadRoom, KnowsWhatIsInsideAndWhereTheHeadComesOut) {
  const HairMesh hair = mesh_of({});
  EXPECT_EQ(hair_inside(hair, kHead).area, 0);
  const HairInside all = hair_inside(hair, {kHead.center, 1.2 * kHead.radii});
  EXPECT_EQ(all.area, 1);
  EXPECT_EQ(all.vertices, 1);
  EXPECT_EQ(all.pokes, 1);
  const HairInside roots = hair_inside(mesh_of({.root_lift = 0.9}), kHead);
  EXPECT_NEAR(roots.vertices, 0.1, 1.0e-9) << "one row of ten";
  EXPECT_GT(roots.area, 0);
  EXPECT_LT(roots.area, 0.1);
}

TEST(HeadRoom, DirectionsCountAlikeAboveAndBelow) {
  // Hair all around, below or above a level inside the head and outside of it on the other side.
  for (const double level : {-0.6, 0.0, 0.6}) {
    for (const bool upper : {false, true}) {
      importer::SourceMesh ball;
      constexpr std::uint32_t kAround = 64, kRows = 48;
      for (std::uint32_t row = 0; row <= kRows; ++row) {
        const double down = std::numbers::pi * row / kRows;
        const double lift = (std::cos(down) > level) == upper ? 0.9 : 1.1;
        for (std::uint32_t c = 0; c <= kAround; ++c) {
          const double turn = 2 * std::numbers::pi * c / kAround;
          const Vector3d way(std::sin(down) * std::sin(turn), std::cos(down), std::sin(down) * std::cos(turn));
          ball.positions.push_back((lift * way).cast<float>());
        }
      }
      for (std::uint32_t row = 0; row < kRows; ++row) {
        for (std::uint32_t c = 0; c < kAround; ++c) {
          const std::uint32_t v = row * (kAround + 1) + c;
          ball.triangles.insert(ball.triangles.end(),
                                {v, v + kAround + 1, v + 1, v + 1, v + kAround + 1, v + kAround + 2});
        }
      }
      const double inside = 0.5 * (upper ? 1 - level : 1 + level);
      EXPECT_NEAR(hair_inside(hair_from(ball), {}).pokes, inside, 0.12) << level;
    }
  }
}

TEST(HeadRoom, TheShareThatHasRoomKeepsToIt) {
  const HairMesh hair = mesh_of({.root_lift = 0.8});
  const HeadEllipsoid large{kHead.center, 1.3 * kHead.radii};
  const double share = share_with_room(hair, large, {0.03, 0.12, 0.005});
  EXPECT_LT(share, 1);
  const HairInside inside = hair_inside(hair, {large.center, 0.999 * share * large.radii});
  EXPECT_LE(inside.area, 0.03);
  EXPECT_LE(inside.vertices, 0.12);
  EXPECT_LE(inside.pokes, 0.005);
  EXPECT_EQ(share_with_room(hair, {kHead.center, 0.5 * kHead.radii}, {0.03, 0.12, 0.005}), 1);
}

TEST(HeadRoom, HairTellsTheHeadThatAGuessMissed) {
  for (const double size : {0.7, 1.0, 1.4}) {
    const HeadGuess guess{{kHead.center + Vector3d(0, 0.02, -0.02), Vector3d(0.9, 1.1, 1.0) * (0.09 * size)},
                          {0.15, 0.4, 0.4},
                          0.12,
                          0.5};
    const HeadEllipsoid head = fit_head_room(mesh_of({}), guess);
    expect_close(head, 0.15);
  }
}

TEST(HeadRoom, EndsWhenAskedToStop) {
  const HeadGuess guess{kHead, {0.15, 0.4, 0.4}, 0.12, 0.5};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)fit_head_room(mesh_of({}), guess, stop.get_token()), platform::Stopped);
}

TEST(FitHead, ComesOutThroughNoHair) {
  for (const double lift : {1.0, 1.05, 1.2}) {
    for (const double root : {1.0, 0.85}) {
      const Combed combed{.lift = lift, .root_lift = root * lift};
      Findings findings;
      const FittedHead head = head_of(model_of(combed), default_recipe(), findings);
      const HairInside inside = hair_inside(mesh_of(combed), head);
      EXPECT_LE(inside.area, 0.03);
      EXPECT_LE(inside.vertices, 0.03);
      EXPECT_LE(inside.pokes, 0.005);
      EXPECT_GT(head.radii.mean(), (root < 1 ? 0.8 : 0.85) * lift * kHead.radii.mean());
      ASSERT_EQ(findings.decisions.size(), 1u);
      EXPECT_EQ(findings.decisions[0].reason, "the inside of the hair");
      EXPECT_EQ(findings.decisions[0].chosen.find("centre (0.0"), 0u) << findings.decisions[0].chosen;
    }
  }
}

TEST(FitHead, ATailBehindItDoesNotMoveIt) {
  importer::SourceModel model = model_of({});
  const FittedHead alone = head_of(model);
  append_piece(model.meshes[0], make_strip({.root = {0.01f, 1.7f, -0.12f}, .along = {0, -0.8f, -0.1f}, .rows = 30}), 0);
  model.meshes[0].uvs.clear();  // its other strips have none
  const FittedHead with_tail = head_of(model);
  EXPECT_LT((with_tail.center - alone.center).norm(), 0.01);
  EXPECT_LT((with_tail.radii - alone.radii).norm(), 0.01);
}

/// The vertices of kHead, in a mesh of its own that hangs from a node called Head at the neck.
void add_head(importer::SourceModel& model) {
  const std::uint32_t node = add_node(model, "Head", 0, kHead.center - Vector3d(0, 0.1, 0));
  importer::SourceMesh face;
  face.name = "face";
  face.node = node;
  for (int i = 0; i < 400; ++i) {
    const double y = 1 - (i + 0.5) / 200, turn = 2.4 * i, r = std::sqrt(1 - y * y);
    face.positions.push_back(
        (kHead.center + kHead.radii.cwiseProduct(Vector3d(r * std::cos(turn), y, r * std::sin(turn)))).cast<float>());
  }
  face.triangles = {0, 1, 2};
  model.meshes.push_back(face);
}

TEST(FitHead, IsTheFilesWhereHairIsATailAlone) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  model.meshes.push_back(
      make_strip({.root = {0.01f, 1.7f, -0.08f}, .along = {0, -0.5f, -0.05f}, .across = {0.03f, 0, 0}, .rows = 20}));
  model.meshes.back().name = "hair";
  add_head(model);
  model.meshes[0].node = 1;
  const FittedHead head = head_of(model);
  EXPECT_NE(head.origin.find("400 vertices"), std::string::npos) << head.origin;
  expect_close(head, 0.15);
}

TEST(HeadBone, IsNoNodeThatUndoesQuantization) {
  importer::SourceModel model;
  add_node(model, "Hair", importer::kNoIndex, {0, 1.5, 0});
  model.meshes.push_back(
      make_strip({.root = {-0.05f, 1.7f, -0.1f}, .along = {0.1f, -0.4f, 0.2f}, .across = {0.03f, 0, 0}, .rows = 20}));
  const auto bone_of = [&] {
    const auto hair = select_hair(model, default_recipe(), unheard());
    return *find_head_bone(model, *hair, "");
  };
  EXPECT_EQ(bone_of().name, "Hair") << "it stands in the hair, as the artist's pivot does";
  model.nodes[0].undoes_quantization = true;
  EXPECT_EQ(bone_of().node, importer::kNoIndex);
}

TEST(FitHead, IsWhatElseAMeshHasThatGaveHair) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  add_head(model);
  importer::SourceMesh& person = model.meshes[0];
  const auto of_face = std::uint32_t(person.positions.size());
  const importer::SourceMesh tail =
      make_strip({.root = {0.01f, 1.7f, -0.08f}, .along = {0, -0.5f, -0.05f}, .across = {0.03f, 0, 0}, .rows = 20});
  const std::uint32_t hair_bone = add_node(model, "hair_1", 1, {0.01, 1.7, -0.08});
  person.positions.insert(person.positions.end(), tail.positions.begin(), tail.positions.end());
  for (const std::uint32_t v : tail.triangles) person.triangles.push_back(of_face + v);
  person.influence_begin = {0};
  for (std::uint32_t v = 0; v < person.positions.size(); ++v) {
    person.influences.push_back({v < of_face ? 1 : hair_bone, 1.0f});
    person.influence_begin.push_back(v + 1);
  }
  person.node = 0;
  const FittedHead head = head_of(model);
  EXPECT_NE(head.origin.find("400 vertices"), std::string::npos) << head.origin;
  expect_close(head, 0.15);
}

TEST(FitHead, AMeshThatHoldsAQuarterOfTheHairIsNoHead) {
  for (const auto& [inside, is_head] : {std::pair{10u, true}, {48u, true}, {52u, false}}) {
    importer::SourceModel model;
    add_node(model, "root", importer::kNoIndex, {0, 0, 0});
    importer::SourceMesh hair =
        make_strip({.root = {0.01f, 1.7f, -0.1f}, .along = {0, -0.5f, -0.05f}, .across = {0.1f, 0, 0}, .rows = 99});
    for (std::uint32_t v = 0; v < inside; ++v) {
      hair.positions[v] = kHead.center.cast<float>() + Eigen::Vector3f(v % 2 ? 0.02f : -0.02f, 0.001f * float(v), 0);
    }
    model.meshes.push_back(hair);
    add_head(model);
    model.meshes[0].node = 1;
    EXPECT_EQ(head_of(model).origin.find("400 vertices") != std::string::npos, is_head) << inside << " of 200";
  }
}

TEST(FitHead, IsTheRecipesElseTheHeadsMeshElseTheHairsInside) {
  const importer::SourceModel wig = make_wig();
  Recipe recipe = default_recipe();
  EXPECT_EQ(head_of(wig).origin, "the inside of the hair");
  recipe.head_center = {0, 1.6, 0};
  recipe.head_radii = {0.05, 0.06, 0.07};
  const Skeleton skeleton = *skeleton_of(wig);
  EXPECT_EQ(head_of(wig, recipe).origin, "the recipe");
  const auto collide = [&] {
    return told([&](Findings& findings) { return head_colliders(head_of(wig, recipe), skeleton, findings); });
  };
  EXPECT_TRUE(collide().warnings.empty());
  recipe.head_radii = {0.25, 0.25, 0.25};
  double share = 1;
  for (const SkeletonBone& bone : skeleton.bones) {
    if (bone.kind == BoneKind::kSimulated)
      share = std::min(share, (bone.tail - Eigen::Vector3d(0, 1.6, 0)).norm() / 0.25);
  }
  ASSERT_EQ(collide().warnings.size(), 1u) << "it swallows the hair";
  EXPECT_NE(collide().warnings[0].message.find(
                fmt::format("a bone ends {:.0f} % of the radius inside it", 100 * (1 - share))),
            std::string::npos)
      << collide().warnings[0].message;
  recipe.head_shape = HeadShape::kNothing;
  EXPECT_TRUE(collide().made.shapes.empty());
}

TEST(FitHead, WhatIsFlatOrSmallIsNoHead) {
  importer::SourceModel wig = make_wig();
  importer::SourceMesh ties;
  ties.name = "ties";
  ties.node = 1;
  for (int i = 0; i < 100; ++i) ties.positions.emplace_back(i % 2 == 0 ? -0.02f : 0.02f, 1.4f, 0.0001f * float(i % 5));
  ties.triangles = {0, 1, 2};
  wig.meshes.push_back(ties);
  EXPECT_EQ(head_of(wig).origin, "the inside of the hair");
}

TEST(FitHead, ALongHeadIsOneAndAPoleIsNot) {
  for (const auto& [height, is_head] : {std::pair{0.115f, true}, std::pair{0.13f, false}}) {
    importer::SourceModel wig = make_wig();
    importer::SourceMesh skull;
    skull.name = "skull";
    skull.node = 1;
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3f corner(i & 1 ? 0.05f : -0.05f, i & 2 ? height : -height, i & 4 ? 0.05f : -0.05f);
      skull.positions.push_back(Eigen::Vector3f(0, 1.66f, 0.03f) + corner);
    }
    skull.triangles = {0, 1, 2};
    wig.meshes.push_back(skull);
    EXPECT_EQ(head_of(wig).origin.find("vertices that follow it") != std::string::npos, is_head)
        << height / 0.05f << " times as high as wide";
  }
}

TEST(FitHead, AFittedHeadLeavesEveryParticleOutside) {
  const auto skeleton = skeleton_of(make_wig());
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii.setConstant(0.15);  // The first bone ends 0.141 m away.
  Findings findings;
  const Colliders colliders = head_colliders(head, *skeleton, findings);
  EXPECT_FALSE(findings.warnings.empty()) << "it had to shrink";
  const HeadCollider& collider = colliders.shapes.at(0);
  for (const SkeletonBone& bone : skeleton->bones) {
    if (bone.kind != BoneKind::kSimulated) continue;
    EXPECT_GE((bone.tail - collider.center).cwiseQuotient(collider.radii).norm(), 1.0);
  }
}

TEST(FitHead, AHatIsNoHead) {
  importer::SourceModel wig = make_wig();
  importer::SourceMesh hat;
  hat.name = "hat";
  hat.node = 1;
  for (int i = 0; i < 100; ++i) {
    const float a = float(i) * 0.7f;
    hat.positions.emplace_back(0.5f * std::sin(a), 1.7f + 0.005f * float(i), 0.5f * std::cos(a));
  }
  hat.triangles = {0, 1, 2};
  wig.meshes.push_back(hat);
  EXPECT_EQ(head_of(wig).origin, "the inside of the hair");
}

/// Hair around a head but for its face, which looks along +Z.
importer::SourceModel bob_that_faces(bool backwards) {
  importer::SourceModel model;
  model.path = "bob.glb";
  const std::uint32_t node = add_node(model, "Head", importer::kNoIndex, kHead.center);
  importer::SourceMesh strands;
  for (int i = 0; i < 24; ++i) {
    const double angle = (45 + 270.0 * i / 23 + (backwards ? 180 : 0)) * std::numbers::pi / 180;
    const Eigen::Vector3f out(float(std::sin(angle)), 0, float(std::cos(angle)));
    const Eigen::Vector3f root = kHead.center.cast<float>() + 0.11f * out + Eigen::Vector3f(0, 0.08f, 0);
    const importer::SourceMesh strip = make_strip(
        {.root = root, .along = {0, -0.25f, 0}, .across = out.cross(Eigen::Vector3f::UnitY()) * 0.03f, .rows = 8});
    if (strands.positions.empty()) {
      strands = strip;
    } else {
      append_piece(strands, strip, 0);
    }
  }
  strands.node = node;
  model.meshes.push_back(strands);
  return model;
}

bool is_backwards(const importer::SourceModel& model) {
  const auto hair = select_hair(model, default_recipe(), unheard());
  return hair && faces_backwards(model, *hair, head_of(model), default_recipe(), unheard());
}

TEST(Facing, IsWhereThereIsNoHairBeforeTheFace) {
  EXPECT_FALSE(is_backwards(bob_that_faces(false)));
  EXPECT_TRUE(is_backwards(bob_that_faces(true)));
}

TEST(Facing, IsWhatTheFileSays) {
  importer::SourceModel model = bob_that_faces(true);
  model.facing = importer::Facing::kForwards;
  EXPECT_FALSE(is_backwards(model));
  model.facing = importer::Facing::kBackwards;
  EXPECT_TRUE(is_backwards(model));
}

TEST(Facing, OfHairThatSaysNothingIsForwards) {
  importer::SourceModel model = bob_that_faces(true);
  append_piece(model.meshes[0], bob_that_faces(false).meshes[0], 0);
  EXPECT_FALSE(is_backwards(model)) << "hair all round";
}

}  // namespace coif::cook::head_test
