#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/select/mesh_topology.h"
#include "cook/strands/patches.h"
#include "cook/strands/strand_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace coif::cook::strands_test {

FittedHead head_of_hair() {
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii = Eigen::Vector3d::Constant(0.09);
  return head;
}

/// Ready for strands, cut into patches by `connectivity`.
HairStrips patched(const HairMesh& mesh, Connectivity connectivity) {
  HairStrips hair = strips_from(mesh);
  hair.complete_normals();
  hair.patches = extract_patches(hair.mesh, hair.welded, connectivity).patches;
  return hair;
}

StrandField strands_of(const HairMesh& mesh, StrandSettings settings = {}) {
  if (settings.depth_of_node.empty()) settings.depth_of_node.assign(10, 0.0f);
  return find_strand_direction(patched(mesh, Connectivity::kIndex), head_of_hair(), settings, unheard());
}

class StrandConventions : public testing::TestWithParam<std::tuple<bool, bool, bool>> {};

// However the artist laid the texture, tangents run from root to tip.
TEST_P(StrandConventions, TangentsRunFromRootToTip) {
  const auto [v_upwards, uv_sideways, without_uv] = GetParam();
  HairMesh mesh = hair_from(make_strip({.v_upwards = v_upwards, .uv_sideways = uv_sideways}));
  if (without_uv) mesh.uvs.clear();
  const StrandField field = strands_of(mesh);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LT(field.tangent[v].y(), -0.99f) << "vertex " << v;
    EXPECT_NEAR(field.place[v], (1.6f - mesh.positions[v].y()) / 0.3f, without_uv ? 0.02 : 1.0e-5);
  }
  EXPECT_EQ(field.along_u, uv_sideways && !without_uv);
}
INSTANTIATE_TEST_SUITE_P(AllLayouts, StrandConventions,
                         testing::Combine(testing::Bool(), testing::Bool(), testing::Bool()));

TEST(StrandDirection, WithoutTextureRowsAreLevelHoweverManyThereAre) {
  for (const std::uint32_t rows : {4u, 20u, 100u, 400u}) {
    const float length = 0.075f * float(rows);
    HairMesh mesh = hair_from(make_strip({.along = {0, -length, 0}, .rows = rows}));
    mesh.uvs.clear();
    const StrandField field = strands_of(mesh);
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_NEAR(field.place[v], (1.6f - mesh.positions[v].y()) / length, 0.02) << rows << " rows, vertex " << v;
    }
  }
}

TEST(StrandDirection, LinesInTheImageTellTheAxisOfWhatIsWiderThanLong) {
  // A fringe, three times as wide as long, whose strands hang.
  const HairMesh mesh =
      hair_from(make_strip({.root = {0, 1.6f, 0.1f}, .along = {0, -0.08f, 0}, .across = {0.24f, 0, 0}}));
  StrandSettings settings;
  settings.seen = {{.lines = 0.8f}};
  for (const Eigen::Vector3f& tangent : strands_of(mesh, settings).tangent) EXPECT_LT(tangent.y(), -0.99f);
  settings.seen = {{.lines = -0.8f}};
  for (const Eigen::Vector3f& tangent : strands_of(mesh, settings).tangent) EXPECT_GT(std::abs(tangent.x()), 0.99f);
}

TEST(StrandDirection, TheRootIsTheEndAtTheHeadEvenWhenItIsBelow) {
  // A spike that stands up from the crown.
  const HairMesh mesh = hair_from(make_strip({.root = {0, 1.69f, 0}, .along = {0, 0.3f, 0}}));
  for (const Eigen::Vector3f& tangent : strands_of(mesh).tangent) EXPECT_GT(tangent.y(), 0.99f);
}

TEST(StrandDirection, OnlyTheEndsSayWhichIsTheRoot) {
  // A lock that stands off the side of the head and comes back: its middle is farther away than its tip.
  importer::SourceMesh lock = make_strip({.across = {0, 0, 0.03f}, .rows = 24, .v_upwards = true});
  for (std::size_t v = 0; v < lock.positions.size(); ++v) {
    const float along = float(v / 2) / 24;
    lock.positions[v].x() = 0.09f + 0.07f * along + 0.3f * std::sin(3.1415927f * along);
    lock.positions[v].y() = 1.6f - 0.02f * along;
  }
  const StrandField field = strands_of(hair_from(lock));
  EXPECT_GT(field.tangent.front().x(), 0.9f) << "the root is where the lock leaves the head";
  EXPECT_LT(field.place.front(), field.place.back());
}

TEST(StrandDirection, BonesSayMoreThanWhereTheEndsAre) {
  // A strip whose lower end is carried by the first bone: combed upwards.
  HairMesh mesh = hair_from(make_strip({.root = {0, 1.66f, -0.1f}, .along = {0, -0.1f, 0}}));
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    mesh.influences[v].node = mesh.positions[v].y() > 1.61f ? 2 : 1;
  StrandSettings settings;
  settings.depth_of_node = {0, 1, 2};
  for (const Eigen::Vector3f& tangent : strands_of(mesh, settings).tangent) EXPECT_GT(tangent.y(), 0.9f);
}

TEST(StrandDirection, APatchThatCannotTellFollowsTheTextureOfTheOthers) {
  // Three strips hang with V down; one lies level on the skull, far from them, with V to the left.
  importer::SourceMesh strips = make_strip({.root = {0.1f, 1.6f, 0}});
  append_piece(strips, make_strip({.root = {0.2f, 1.6f, 0}}), 0);
  append_piece(strips, make_strip({.root = {0.3f, 1.6f, 0}}), 0);
  const auto first = std::uint32_t(strips.positions.size());
  append_piece(strips, make_strip({.root = {0.06f, 1.69f, 0}, .along = {-0.12f, 0, 0}, .across = {0, 0, 0.03f}}), 0);
  const HairMesh mesh = hair_from(strips);
  const StrandField field = strands_of(mesh);
  for (std::uint32_t v = first; v < mesh.positions.size(); ++v) EXPECT_LT(field.tangent[v].x(), -0.9f);
}

TEST(StrandDirection, StrandsThatAreCombedOverTheHeadToATailEndThere) {
  // Over the skull from the forehead to the back, both ends on it and level, where another strip hangs free.
  importer::SourceMesh combed = make_strip({.across = {0.03f, 0, 0}, .rows = 12});
  for (std::size_t v = 0; v < combed.positions.size(); ++v) {
    const float turn = 0.3f + 2.5f * float(v / 2) / 12;
    combed.positions[v].y() = 1.6f + 0.091f * std::sin(turn);
    combed.positions[v].z() = -0.091f * std::cos(turn) * -1;
  }
  importer::SourceMesh tail = make_strip({.root = {0, 1.62f, -0.1f}, .along = {0, -0.4f, -0.1f}, .rows = 12});
  for (importer::SourceMesh* strip : {&combed, &tail}) strip->uvs.clear();
  const std::size_t of_comb = combed.positions.size();
  append_piece(combed, tail, 0);
  const StrandField field = strands_of(hair_from(combed));
  EXPECT_LT(field.tangent[of_comb / 2].z(), -0.9f) << "towards the tail";
  EXPECT_LT(field.tangent[of_comb + 12].y(), -0.9f);
}

TEST(StrandDirection, ALockThatHangsAloneHasItsRootWhereItMeetsOtherHair) {
  // From thick hair above the forehead down in front of the face, everywhere equally far from the head.
  importer::SourceMesh hair =
      make_strip({.root = {0.02f, 1.7f, 0.15f}, .along = {0, -0.2f, 0}, .across = {0.03f, 0, 0}, .rows = 12});
  const std::size_t of_lock = hair.positions.size();
  append_piece(hair, make_strip({.root = {0, 1.72f, -0.1f}, .along = {0, 0, 0.25f}, .rows = 12}), 0);
  hair.uvs.clear();
  const StrandField field = strands_of(hair_from(hair));
  for (std::size_t v = 0; v < of_lock; ++v) EXPECT_LT(field.tangent[v].y(), -0.9f);
}

TEST(StrandDirection, TwinsRunAlikeWhateverTheirTexturesShow) {
  // As wide as long, on both sides of the head; the images show lines down on one of them, weaker ones across on the
  // other.
  const StripDesc left{.root = {0.1f, 1.6f, 0}, .along = {0, -0.1f, 0}, .across = {0, 0, 0.1f}};
  importer::SourceMesh pair = make_strip(left);
  const std::size_t of_one = pair.positions.size();
  importer::SourceMesh image = make_strip(left);
  for (Eigen::Vector3f& p : image.positions) p.x() = -p.x();
  append_piece(pair, image, 0);
  StrandSettings settings;
  settings.seen = {{.lines = -0.6f}, {.lines = 0.9f}};
  const StrandField field = strands_of(hair_from(pair), settings);
  for (std::size_t v = 0; v < 2 * of_one; ++v) EXPECT_LT(field.tangent[v].y(), -0.9f) << "vertex " << v;
}

TEST(StrandNeighbours, APatchThatTouchesOthersWithItsRimOnlyIsLittleInfluenced) {
  importer::SourceMesh strips = make_strip({.rows = 24});
  const StripDesc below{.root = {0.06f, 1.32f, -0.1f}, .rows = 24};
  append_piece(strips, make_strip(below), 0);
  const HairStrips hair = patched(hair_from(strips), Connectivity::kIndex);
  const std::vector<Eigen::Vector3f> down(hair.mesh.positions.size(), {0, -1, 0});
  const auto beside = find_neighbours(hair.mesh, hair.views(), down, 0.015, {});
  ASSERT_EQ(beside[0].size(), 1u);
  EXPECT_GT(beside[0][0].agreement, 0.0f);
  EXPECT_LT(beside[0][0].agreement, 0.2f);
}

TEST(StrandTwins, AreExactMirrorImages) {
  const auto at = [](float x) { return make_strip({.root = {x, 1.6f, 0}, .across = {0, 0, 0.05f}}); };
  importer::SourceMesh strips = at(0.1f);
  append_piece(strips, at(-0.08f), 0);
  append_piece(strips, make_strip({}), 0);  // on the middle: its own image
  append_piece(strips, at(-0.1005f), 0);
  const HairStrips hair = patched(hair_from(strips), Connectivity::kIndex);
  EXPECT_EQ(find_twins(hair.mesh, hair.views(), 0, 0.003f), (std::vector<std::uint32_t>{3, 1, 2, 0}));
}

TEST(StrandDirection, TipsArePaintedThinner) {
  // Lies level beside the head: nothing else tells its ends apart.
  const HairMesh mesh =
      hair_from(make_strip({.root = {-0.15f, 1.69f, 0}, .along = {0.3f, 0, 0}, .across = {0, 0, 0.05f}}));
  for (const float fade : {0.6f, -0.6f}) {
    StrandSettings settings;
    settings.seen = {{.lines = 1, .fade = {0, fade}}};
    EXPECT_GT(strands_of(mesh, settings).tangent.front().x() * fade, 0.5f);
  }
}

TEST(StrandDirection, PatchesThatNothingTellsAboutAreNamedByTheirNumbers) {
  HairMesh mesh = hair_from(make_strip({.root = {-0.15f, 1.69f, 0}, .along = {0.3f, 0, 0}, .across = {0, 0, 0.05f}}));
  mesh.uvs.clear();
  StrandSettings settings;
  settings.depth_of_node.assign(1, 0.0f);
  const auto said = told([&](Findings& f) {
    return find_strand_direction(patched(mesh, Connectivity::kIndex), head_of_hair(), settings, f);
  });
  ASSERT_FALSE(said.notes.empty());
  EXPECT_EQ(said.notes[0], "roots: 1 of 1 patches unsure: 0 of 'coif cook --list patches'");
  EXPECT_EQ(said.made.unsure, std::vector<std::uint32_t>{0});
}

TEST(StrandDirection, APatchWithoutTextureFollowsItsNeighbours) {
  // Level strips side by side on the skull; all but one end in free air, so that one is carried along by them.
  importer::SourceMesh strips =
      make_strip({.root = {0.05f, 1.69f, 0}, .along = {-0.1f, 0, 0}, .across = {0, 0, 0.01f}});
  for (const float z : {-0.01f, 0.01f}) {
    importer::SourceMesh beside =
        make_strip({.root = {0.05f, 1.69f, z}, .along = {-0.3f, 0, 0}, .across = {0, 0, 0.01f}, .rows = 8});
    append_piece(strips, beside, 0);
  }
  HairMesh mesh = hair_from(strips);
  mesh.uvs.clear();
  const StrandField field = strands_of(mesh);
  for (std::uint32_t v = 0; v < 10; ++v) EXPECT_LT(field.tangent[v].x(), -0.9f);
}

TEST(StrandDirection, PalettesSayNothingAboutStrands) {
  HairMesh mesh = hair_from(make_strip({}));
  for (Eigen::Vector2f& uv : mesh.uvs) uv = {0.3f, 0.7f};
  for (const Eigen::Vector3f& tangent : strands_of(mesh).tangent) EXPECT_LT(tangent.y(), -0.9f);
}

TEST(StrandDirection, WithoutTextureTheStrandFollowsTheBendOfTheSurface) {
  importer::SourceMesh strip = make_strip({.rows = 24});
  for (std::size_t v = 0; v < strip.positions.size(); ++v) {
    // Half a ring from the crown round the back to the nape.
    const float angle = 3.1f * float(v / 2) / 24;
    strip.positions[v] = {v % 2 == 0 ? -0.01f : 0.01f, 1.6f + 0.12f * std::cos(angle), -0.12f * std::sin(angle)};
  }
  HairMesh mesh = hair_from(strip);
  mesh.uvs.clear();
  const StrandField field = strands_of(mesh);
  for (std::size_t v = 4; v + 4 < mesh.positions.size(); ++v) {
    const Eigen::Vector3f along = strip.positions[v + 2] - strip.positions[v - 2];
    EXPECT_GT(field.tangent[v].dot(along.normalized()), 0.95f) << "vertex " << v;
  }
}

TEST(StrandDirection, ARecipeSaysOnWhichSideTheRootsAre) {
  const HairMesh mesh = hair_from(make_strip({}));
  StrandSettings settings;
  settings.roots = {"high_v"};
  for (const Eigen::Vector3f& tangent : strands_of(mesh, settings).tangent) EXPECT_GT(tangent.y(), 0.9f);
  settings.roots = {"low_u"};
  for (const Eigen::Vector3f& tangent : strands_of(mesh, settings).tangent) EXPECT_GT(tangent.x(), 0.9f);
  settings.roots = {"high_u"};
  for (const Eigen::Vector3f& tangent : strands_of(mesh, settings).tangent) EXPECT_LT(tangent.x(), -0.9f);
}

TEST(StrandDirection, TangentsAreUnitAndPerpendicularToNormals) {
  importer::SourceMesh strip = make_strip({.along = {0.1f, -0.2f, -0.1f}, .rows = 8});
  for (std::size_t v = 0; v < strip.positions.size(); ++v) strip.positions[v].z() += 0.02f * float(v % 5);
  HairStrips hair = strips_from(hair_from(strip));
  hair.complete_normals();
  const HairMesh& mesh = hair.mesh;
  const StrandField field = strands_of(mesh);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(field.tangent[v].norm(), 1.0f, 1.0e-5);
    EXPECT_NEAR(field.tangent[v].dot(mesh.normals[v]), 0.0f, 1.0e-4);
  }
}

TEST(SmoothNormals, AStripsTwoSidesKeepOppositeNormals) {
  HairMesh mesh = hair_from(make_strip({}));
  const auto half = std::uint32_t(mesh.positions.size());
  const std::size_t triangles = mesh.triangles.size();
  for (std::uint32_t v = 0; v < half; ++v) {
    mesh.positions.push_back(mesh.positions[v]);
    mesh.uvs.push_back(mesh.uvs[v]);
  }
  for (std::size_t i = 0; i < triangles; i += 3) {
    for (std::size_t k : {0u, 2u, 1u}) mesh.triangles.push_back(half + mesh.triangles[i + k]);
  }
  HairStrips hair = strips_from(mesh);
  EXPECT_EQ(hair.complete_normals(), mesh.positions.size());
  for (std::uint32_t v = 0; v < half; ++v) {
    EXPECT_NEAR(hair.mesh.normals[v].norm(), 1.0f, 1.0e-5);
    EXPECT_NEAR(hair.mesh.normals[v].dot(hair.mesh.normals[half + v]), -1.0f, 1.0e-5);
  }
}

TEST(SmoothNormals, GivenNormalsAreKept) {
  HairMesh mesh = hair_from(make_strip({}));
  mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitX());
  mesh.normals[3] = Eigen::Vector3f::Zero();
  HairStrips hair = strips_from(mesh);
  EXPECT_EQ(hair.complete_normals(), 1u);
  EXPECT_EQ(hair.mesh.normals[2], Eigen::Vector3f::UnitX());
  EXPECT_NEAR(std::abs(hair.mesh.normals[3].z()), 1.0f, 1.0e-5);
}

/// Cuts what is wider than `widest` metres.
struct Shell : HairStrips {
  Shell(const importer::SourceMesh& source, double widest)
      : HairStrips(patched(hair_from(source), Connectivity::kAuto)) {
    StrandSettings settings;
    settings.depth_of_node = {0};
    strands = find_strand_direction(*this, head_of_hair(), settings, unheard());
    split = split_shells(*this, widest, findings);
  }

  ShellSplit split;
  Findings findings;
};

TEST(SplitShells, ACapIsCutAlongItsStrands) {
  const Shell shell(make_cap(24, 8, 6.2f), 0.07);
  EXPECT_EQ(shell.split.shells, 1u);
  EXPECT_EQ(shell.split.parts, shell.patches.count);
  EXPECT_GE(shell.patches.count, 6u) << "0.6 m around";
  EXPECT_EQ(shell.split.left, 0u);
  // The sixteen triangles of a column of quads, crown to edge, stay together.
  for (std::size_t column = 0; column < 24; ++column) {
    std::set<std::uint32_t> patches;
    for (std::size_t row = 0; row < 8; ++row) {
      patches.insert(shell.patches.patch_of[2 * (24 * row + column)]);
      patches.insert(shell.patches.patch_of[2 * (24 * row + column) + 1]);
    }
    EXPECT_EQ(patches.size(), 1u) << "column " << column;
  }
}

TEST(SplitShells, AStripIsLeftWhole) {
  const Shell shell(make_strip({.rows = 12}), 0.07);
  EXPECT_EQ(shell.split.shells, 0u);
  EXPECT_EQ(shell.patches.count, 1u);
}

TEST(SplitShells, PartsAreNumberedWithoutGaps) {
  const Shell shell(make_cap(24, 8, 3.1f), 0.05);
  std::set<std::uint32_t> seen(shell.patches.patch_of.begin(), shell.patches.patch_of.end());
  EXPECT_EQ(seen.size(), shell.patches.count);
  EXPECT_EQ(*seen.rbegin(), shell.patches.count - 1);
}

TEST(SplitShells, SeparatedPatchesShareNoVertexAndKeepTheirStrands) {
  const Shell shell(make_cap(24, 8, 6.2f), 0.07);
  ASSERT_EQ(shell.strands.place.size(), shell.mesh.positions.size());
  ASSERT_EQ(shell.welded.size(), shell.mesh.positions.size());
  std::vector<std::uint32_t> owner(shell.mesh.positions.size(), importer::kNoIndex);
  for (std::size_t i = 0; i < shell.mesh.triangles.size(); ++i) {
    std::uint32_t& patch = owner[shell.mesh.triangles[i]];
    if (patch == importer::kNoIndex) patch = shell.patches.patch_of[i / 3];
    EXPECT_EQ(patch, shell.patches.patch_of[i / 3]);
  }
  const std::size_t before = make_cap(24, 8, 6.2f).positions.size();
  ASSERT_GT(shell.mesh.positions.size(), before);
  for (std::size_t copy = before; copy < shell.mesh.positions.size(); ++copy) {
    const auto& positions = shell.mesh.positions;
    bool found = false;
    for (std::size_t v = 0; v < before; ++v) {
      found =
          found || (positions[v] == positions[copy] && shell.strands.place[v] == shell.strands.place[copy] &&
                    shell.strands.tangent[v] == shell.strands.tangent[copy] && shell.welded[v] == shell.welded[copy]);
    }
    EXPECT_TRUE(found) << copy;
  }
}

}  // namespace coif::cook::strands_test
