#include "cook/strands/patches.h"
#include "cook/built_models.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/recipe.h"
#include "cook/select/mesh_topology.h"
#include "cook/select/select_hair.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace coif::cook::patches_test {

/// Algorithm 2 as the thesis prints it: each triangle against each group.
std::size_t published_group_count(const HairMesh& mesh) {
  std::vector<std::set<std::uint32_t>> groups;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::set<std::uint32_t> merged(mesh.triangles.begin() + std::ptrdiff_t(t),
                                   mesh.triangles.begin() + std::ptrdiff_t(t + 3));
    std::vector<std::set<std::uint32_t>> others;
    for (const auto& group : groups) {
      const bool touches = std::ranges::any_of(mesh.triangles.begin() + std::ptrdiff_t(t),
                                               mesh.triangles.begin() + std::ptrdiff_t(t + 3),
                                               [&](std::uint32_t v) { return group.contains(v); });
      if (touches) {
        merged.insert(group.begin(), group.end());
      } else {
        others.push_back(group);
      }
    }
    others.push_back(merged);
    groups = others;
  }
  return groups.size();
}

ExtractedPatches patches_of(const HairMesh& mesh, Connectivity connectivity) {
  return extract_patches(mesh, weld_places(mesh.positions, 1.0e-5), connectivity);
}

TEST(ExtractPatches, AgreesWithThePublishedAlgorithmOnRandomMeshes) {
  std::mt19937 engine(7);
  const auto random = [&] { return std::uint32_t(engine()); };
  for (int round = 0; round < 50; ++round) {
    HairMesh mesh;
    const std::uint32_t vertices = 20 + random() % 80;
    for (std::uint32_t v = 0; v < vertices; ++v) mesh.positions.emplace_back(float(v), 0.0f, 0.0f);
    const std::uint32_t corners = 3 * (5 + random() % 40);
    for (std::uint32_t i = 0; i < corners; ++i) mesh.triangles.push_back(random() % vertices);
    const ExtractedPatches patches = patches_of(mesh, Connectivity::kIndex);
    EXPECT_EQ(patches.patches.count, published_group_count(mesh)) << "round " << round;
    EXPECT_EQ(patches.by_index, patches.patches.count);
    for (std::uint32_t patch : patches.patches.patch_of) EXPECT_LT(patch, patches.patches.count);
  }
}

TEST(ExtractPatches, TrianglesThatShareAVertexAreInOnePatch) {
  HairMesh mesh = hair_from(make_strip({}));
  const ExtractedPatches patches = patches_of(mesh, Connectivity::kIndex);
  EXPECT_EQ(patches.patches.count, 1u);
  EXPECT_EQ(patches.patches.patch_of.size(), 8u);
}

/// A bent strip of twenty triangles, every one with vertices and a normal of its own.
importer::SourceMesh flat_shaded_strip() {
  importer::SourceMesh strip = make_strip({.along = {0, -0.3f, 0.1f}, .rows = 10});
  strip.positions[5].z() += 0.05f;
  split_vertices(strip);
  return strip;
}

TEST(ExtractPatches, AutoSeesThroughFlatShading) {
  HairMesh mesh = hair_from(flat_shaded_strip());
  weld_vertices(mesh);
  const ExtractedPatches patches = patches_of(mesh, Connectivity::kAuto);
  EXPECT_GT(patches.by_index, 1u);
  EXPECT_EQ(patches.by_position, 1u);
  EXPECT_EQ(patches.by_island, 1u);
  EXPECT_EQ(patches.chosen, Connectivity::kIsland);
  EXPECT_EQ(patches.patches.count, 1u);
  EXPECT_EQ(patches_of(mesh, Connectivity::kIndex).patches.count, patches.by_index) << "the recipe decides";
}

TEST(ExtractPatches, AutoSeesThroughFlatShadingWithoutTextureCoordinates) {
  HairMesh mesh = hair_from(flat_shaded_strip());
  mesh.uvs.clear();
  EXPECT_EQ(patches_of(mesh, Connectivity::kAuto).chosen, Connectivity::kPosition);
  EXPECT_EQ(patches_of(mesh, Connectivity::kAuto).patches.count, 1u);
}

TEST(ExtractPatches, StripsThatTouchAlongAnEdgeAreTwoIslands) {
  // Side by side with a common edge, both unwrapped over the whole texture, as cards of one texture are.
  importer::SourceMesh strips = make_strip({.across = {0.05f, 0, 0}, .rows = 10});
  append_piece(strips, make_strip({.root = {0.05f, 1.6f, -0.1f}, .across = {0.05f, 0, 0}, .rows = 10}), 0);
  const ExtractedPatches patches = patches_of(hair_from(strips), Connectivity::kAuto);
  EXPECT_EQ(patches.by_position, 1u);
  EXPECT_EQ(patches.patches.count, 2u);
}

TEST(ExtractPatches, StripsThatMeetInOnePointAreTwoIslands) {
  importer::SourceMesh strips = make_strip({.rows = 10});
  append_piece(strips, make_strip({.root = {0.05f, 1.9f, -0.1f}, .rows = 10}), 0);
  const ExtractedPatches patches = patches_of(hair_from(strips), Connectivity::kAuto);
  EXPECT_EQ(patches.by_position, 1u);
  EXPECT_EQ(patches.patches.count, 2u);
}

TEST(ExtractPatches, AStripUnwrappedFaceByFaceIsOnePatch) {
  importer::SourceMesh strip = flat_shaded_strip();
  for (std::size_t v = 0; v < strip.uvs.size(); ++v) strip.uvs[v] += Eigen::Vector2f(float(v / 3), 0);
  const ExtractedPatches patches = patches_of(hair_from(strip), Connectivity::kAuto);
  EXPECT_EQ(patches.by_island, 20u);
  EXPECT_EQ(patches.chosen, Connectivity::kPosition);
  EXPECT_EQ(patches.patches.count, 1u);
}

TEST(ExtractPatches, TheOrderOfTrianglesChangesNoGroup) {
  importer::SourceMesh strips = make_strip({.rows = 10});
  append_piece(strips, make_strip({.root = {0.05f, 1.6f, -0.1f}, .rows = 10}), 0);
  const std::uint32_t count = patches_of(hair_from(strips), Connectivity::kAuto).patches.count;
  std::vector<std::uint32_t> reversed;
  for (std::size_t t = strips.triangles.size(); t >= 3; t -= 3) {
    reversed.insert(reversed.end(), strips.triangles.begin() + std::ptrdiff_t(t - 3),
                    strips.triangles.begin() + std::ptrdiff_t(t));
  }
  strips.triangles = reversed;
  EXPECT_EQ(patches_of(hair_from(strips), Connectivity::kAuto).patches.count, count);
}

TEST(Weld, TheAutomaticDistanceGrowsWithTheModel) {
  std::vector<Eigen::Vector3f> positions{{0, 0, 0}, {0, 0, 5.0e-6f}, {0, 0, 1}};
  EXPECT_EQ(weld_places(positions, 0)[1], 0u);
  for (Eigen::Vector3f& p : positions) p *= 0.01f;
  EXPECT_EQ(weld_places(positions, 0)[1], 0u);
  positions[1].z() = 5.0e-6f;
  EXPECT_EQ(weld_places(positions, 0)[1], 1u);
}

TEST(Weld, JoinsEqualVerticesAndDropsUnusedOnes) {
  importer::SourceMesh strip = make_strip({});
  const std::size_t joined = strip.positions.size();
  split_vertices(strip);
  strip.normals.clear();
  strip.positions.emplace_back(9, 9, 9);
  strip.uvs.emplace_back(0, 0);
  HairMesh mesh = hair_from(strip);
  weld_vertices(mesh);
  EXPECT_EQ(mesh.positions.size(), joined);
  EXPECT_EQ(mesh.influence_begin.size(), joined + 1);
  EXPECT_EQ(mesh.triangle_count(), 8u);
}

TEST(Weld, WhatDiffersInOneAttributeStaysApart) {
  HairMesh copied = hair_from(make_strip({}));
  const auto joined = std::uint32_t(copied.positions.size());
  for (std::uint32_t& v : copied.triangles) {
    if (v == 3) v = copied.append_vertex(copied, 3);
  }
  const std::uint32_t copy = joined;
  const std::function<void(HairMesh&)> changes[] = {
      [](HairMesh&) {},
      [&](HairMesh& mesh) { mesh.positions[copy].x() += 1e-6f; },
      [&](HairMesh& mesh) { mesh.uvs[copy].y() += 1e-6f; },
      [&](HairMesh& mesh) { mesh.influences[mesh.influence_begin[copy]].node = 1; },
      [&](HairMesh& mesh) { mesh.influences[mesh.influence_begin[copy]].weight = 0.5f; },
      [&](HairMesh& mesh) {
        mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitY());
        mesh.normals[copy] = Eigen::Vector3f::UnitZ();
      },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    HairMesh mesh = copied;
    changes[i](mesh);
    weld_vertices(mesh);
    EXPECT_EQ(mesh.positions.size(), i == 0 ? joined : joined + 1) << i;
  }
}

TEST(Weld, PlacesAreFoundAcrossCellBordersAndOnlyWithinTheDistance) {
  const std::vector<Eigen::Vector3f> positions{
      {0.0009999f, 0, 0}, {0.0010001f, 0, 0}, {0.0050f, 0, 0}, {-0.0000001f, 0, 0}};
  const auto place = weld_places(positions, 1.0e-5);
  EXPECT_EQ(place[1], place[0]);
  EXPECT_EQ(place[2], 2u);
  EXPECT_EQ(place[3], 3u);
  const std::vector<Eigen::Vector3f> apart{{0, 0, 0}, {0.5f, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(weld_places(apart, 0.5), (std::vector<std::uint32_t>{0, 0, 2})) << "the distance itself is within";
}

TEST(FindPieces, OneCornerInCommonIsEnoughWhicheverItIs) {
  importer::SourceMesh mesh;
  for (int i = 0; i < 5; ++i) mesh.positions.emplace_back(float(i), float(i * i), 0);
  for (std::uint32_t first = 0; first < 3; ++first) {
    for (std::uint32_t second = 0; second < 3; ++second) {
      mesh.triangles = {0, 0, 0, 0, 0, 0};
      for (std::uint32_t k = 1; k < 3; ++k) {
        mesh.triangles[(first + k) % 3] = k;
        mesh.triangles[3 + (second + k) % 3] = 2 + k;
      }
      EXPECT_EQ(find_pieces(mesh, 0).count, 1u) << first << " and " << second;
    }
  }
}

TEST(SortPatches, InnerPatchesComeFirstAndEqualOnesKeepTheirOrder) {
  HairMesh mesh;
  PatchSet patches;
  for (const float distance : {0.3f, 0.1f, 0.2f, 0.1f}) {
    const auto base = std::uint32_t(mesh.positions.size());
    const Eigen::Vector3f middle(0, 1.6f, distance);
    mesh.positions.insert(mesh.positions.end(),
                          {middle + Eigen::Vector3f(0.01f, 0, 0), middle + Eigen::Vector3f(-0.01f, 0.01f, 0),
                           middle + Eigen::Vector3f(0, -0.01f, 0)});
    mesh.triangles.insert(mesh.triangles.end(), {base, base + 1, base + 2});
    patches.patch_of.push_back(patches.count++);
  }
  const PatchOrder order = sort_patches({mesh, {}, patches, {}}, {0, 1.6, 0});
  EXPECT_EQ(order.patch, (std::vector<std::uint32_t>{1, 3, 2, 0}));
  EXPECT_NEAR(order.distance[0], 0.1, 1.0e-6);
}

TEST(SortPatches, DistanceIsThatOfTheAreaNotOfTheVertices) {
  // A large triangle near the head and a cluster of tiny ones far away: area decides.
  HairMesh mesh;
  mesh.positions = {{-1, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  mesh.triangles = {0, 1, 2};
  PatchSet patches{{0}, 1};
  for (int i = 0; i < 20; ++i) {
    const auto base = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 9}, {0.001f, 0, 9}, {0, 0.001f, 9}});
    mesh.triangles.insert(mesh.triangles.end(), {base, base + 1, base + 2});
    patches.patch_of.push_back(0);
  }
  EXPECT_NEAR(sort_patches({mesh, {}, patches, {}}, {0, 1.0 / 3, 0}).distance[0], 1.0, 0.01);
}

/// A strip and its copy with every triangle turned round, in vertices of its own.
importer::SourceMesh doubled_strip() {
  importer::SourceMesh mesh = make_strip({});
  importer::SourceMesh back = mesh;
  for (std::size_t t = 0; t < back.triangles.size(); t += 3) std::swap(back.triangles[t + 1], back.triangles[t + 2]);
  append_piece(mesh, back, 0);
  return mesh;
}

MergedFaces merge(HairMesh& mesh) { return merge_back_faces(mesh, weld_places(mesh.positions, 0)); }

TEST(MergeBackFaces, ACopyTurnedRoundBecomesAFlag) {
  HairMesh mesh = hair_from(doubled_strip());
  const MergedFaces merged = merge(mesh);
  EXPECT_EQ(merged.back_faces, 8u);
  EXPECT_EQ(merged.copies, 0u);
  EXPECT_EQ(mesh.triangle_count(), 8u);
  EXPECT_TRUE(mesh.double_sided);
}

TEST(MergeBackFaces, ACopyThatLooksTheSameWayIsNoBack) {
  importer::SourceMesh strip = make_strip({});
  append_piece(strip, make_strip({}), 0);
  HairMesh mesh = hair_from(strip);
  const MergedFaces merged = merge(mesh);
  EXPECT_EQ(merged.copies, 8u);
  EXPECT_EQ(merged.back_faces, 0u);
  EXPECT_FALSE(mesh.double_sided);
}

TEST(MergeBackFaces, KeepsTheWindingOfTheFirst) {
  HairMesh mesh = hair_from(doubled_strip());
  const std::vector<std::uint32_t> first(mesh.triangles.begin(), mesh.triangles.begin() + 24);
  merge(mesh);
  EXPECT_EQ(mesh.triangles, first);
}

TEST(MergeBackFaces, TheReportSaysHowManyThereWere) {
  importer::SourceModel model = make_wig();
  importer::SourceMesh back = model.meshes[0];
  for (std::size_t t = 0; t < back.triangles.size(); t += 3) std::swap(back.triangles[t + 1], back.triangles[t + 2]);
  model.meshes.push_back(back);
  Findings findings;
  const auto hair = select_hair(model, default_recipe(), findings);
  ASSERT_TRUE(hair);
  EXPECT_EQ(hair->triangle_count(), 10u);
  EXPECT_EQ(findings.left_out.at(0).text(),
            "10 triangles that only were the back of others: the hair is drawn double-sided (120 bytes)");
}

TEST(ClosedSurfaces, AnOpenSheetIsOpenHoweverFewOfItsTrianglesAreAtTheBorder) {
  const HairMesh cap = hair_from(make_cap(200, 200, 3.0f));
  EXPECT_FALSE(is_closed(cap, weld_places(cap.positions, 0)));
}

TEST(ClosedSurfaces, ABoxIsClosedAndAStripIsNot) {
  HairMesh box;
  for (int i = 0; i < 8; ++i) box.positions.emplace_back(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1));
  box.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  EXPECT_TRUE(is_closed(box, weld_places(box.positions, 0)));
  const HairMesh strip = hair_from(make_strip({}));
  EXPECT_FALSE(is_closed(strip, weld_places(strip.positions, 0)));
}

}  // namespace coif::cook::patches_test
