// What hair is wrapped around, where it is a part of a head's mesh.

#include "cook/recipe/recipe.h"
#include "cook/select/under_hair.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::hair_core_test {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr std::uint32_t kHead = 1;  ///< The node.

/// A barrel from `top` down, unwrapped from `uv` on.
struct Bulge {
  Vector3f top;
  float length = 0.25f;
  float radius = 0.025f;
  Vector2f uv = Vector2f::Zero();
};

void append(importer::SourceMesh& mesh, const Bulge& bulge) {
  constexpr std::uint32_t kColumns = 12, kRows = 10;
  const auto base = std::uint32_t(mesh.positions.size());
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    const float down = float(row) / kRows, wide = bulge.radius * std::max(0.6f, std::sin(3.14159f * down));
    for (std::uint32_t c = 0; c <= kColumns; ++c) {
      const float turn = 6.28319f * float(c) / kColumns;
      mesh.positions.push_back(bulge.top +
                               Vector3f(wide * std::sin(turn), -down * bulge.length, wide * std::cos(turn)));
      mesh.uvs.push_back(bulge.uv + Vector2f(0.4f * float(c) / kColumns, 0.4f * down));
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t c = 0; c < kColumns; ++c) {
      const std::uint32_t v = base + row * (kColumns + 1) + c;
      mesh.triangles.insert(mesh.triangles.end(),
                            {v, v + kColumns + 1, v + 1, v + 1, v + kColumns + 1, v + kColumns + 2});
    }
  }
}

/// Strips around a bulge, a little away from it.
void wrap(importer::SourceMesh& hair, const Bulge& bulge) {
  for (int i = 0; i < 8; ++i) {
    const float turn = 6.28319f * float(i) / 8;
    const Vector3f out(std::sin(turn), 0, std::cos(turn));
    append_piece(hair,
                 make_strip({.root = bulge.top + (bulge.radius + 0.004f) * out,
                             .along = {0, -bulge.length, 0},
                             .across = 0.015f * Vector3f(out.z(), 0, -out.x())}),
                 0);
  }
}

constexpr std::size_t kTriangles = 240;  ///< In a bulge.

/// A head of 18 cm with one more bulge in its mesh, and hair around another place.
importer::SourceModel head_with(const Bulge& bulge, const Bulge& wrapped) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  add_node(model, "Head", 0, {0, 1.5, 0});
  importer::SourceMesh head;
  head.name = "person";
  head.node = add_node(model, "skull", kHead, {0, 1.5, 0});
  append(head, {.top = {0, 1.7f, 0}, .length = 0.22f, .radius = 0.08f});
  append(head, bulge);
  importer::SourceMesh hair;
  hair.name = "hair";
  hair.node = add_node(model, "strips", kHead, {0, 1.5, 0});
  hair.influence_begin = {};
  wrap(hair, wrapped);
  model.meshes = {std::move(hair), std::move(head)};
  return model;
}

std::size_t taken_from_head(const importer::SourceModel& model) {
  HairChoice hair;
  hair.taken = {std::vector<bool>(model.meshes[0].triangles.size() / 3, true), {}};
  const HairChoice cores = find_hair_cores(model, hair, kHead);
  EXPECT_TRUE(cores.taken[0].empty()) << "it is hair already";
  if (!cores.taken[1].empty()) {
    EXPECT_EQ(std::count(cores.taken[1].begin(), cores.taken[1].begin() + kTriangles, true), 0) << "the head itself";
  }
  return std::size_t(std::ranges::count(cores.taken[1], true));
}

const Bulge kTail{.top = {0, 1.65f, -0.16f}, .uv = {0.5f, 0.5f}};

TEST(HairCore, ThatStripsAreWrappedAroundIsHair) { EXPECT_EQ(taken_from_head(head_with(kTail, kTail)), kTriangles); }

TEST(HairCore, WithoutHairAroundItIsNot) {
  Bulge elsewhere = kTail;
  elsewhere.top.x() += 0.2f;
  EXPECT_EQ(taken_from_head(head_with(kTail, elsewhere)), 0u);
}

TEST(HairCore, WhatLiesCloseToTheHeadIsNot) {
  const Bulge ear{.top = {0.085f, 1.62f, 0}, .length = 0.06f, .radius = 0.012f, .uv = {0.5f, 0.5f}};
  EXPECT_EQ(taken_from_head(head_with(ear, ear)), 0u);
}

TEST(HairCore, WhatIsAsWideAsAHeadIsNot) {
  const Bulge second_head{.top = {0, 1.7f, -0.3f}, .length = 0.2f, .radius = 0.08f, .uv = {0.5f, 0.5f}};
  EXPECT_EQ(taken_from_head(head_with(second_head, second_head)), 0u);
}

TEST(HairCore, WhatIsJoinedToTheHeadInTheTextureTooIsNot) {
  importer::SourceModel model = head_with(kTail, kTail);
  std::vector<std::uint32_t>& triangles = model.meshes[1].triangles;
  triangles.insert(triangles.end(), {0, 1, std::uint32_t(model.meshes[1].positions.size() / 2)});
  EXPECT_EQ(taken_from_head(model), 0u) << "a whole head";
}

TEST(HairCore, WhatDoesNotFollowTheHeadIsNot) {
  importer::SourceModel model = head_with(kTail, kTail);
  const std::uint32_t spine = add_node(model, "Spine", 0, {0, 1, 0});
  importer::SourceMesh& person = model.meshes[1];
  person.influence_begin = {0};
  for (std::uint32_t v = 0; v < person.positions.size(); ++v) {
    person.influences.push_back({v < person.positions.size() / 2 ? kHead : spine, 1.0f});
    person.influence_begin.push_back(v + 1);
  }
  EXPECT_EQ(taken_from_head(model), 0u);
}

TEST(HairCore, AMeshOfItsOwnIsWornInTheHair) {
  importer::SourceModel model = head_with(kTail, kTail);
  importer::SourceMesh band = model.meshes[1];
  band.triangles.erase(band.triangles.begin(), band.triangles.begin() + 3 * kTriangles);
  model.meshes[1].triangles.resize(3 * kTriangles);
  model.meshes.push_back(band);
  HairChoice hair;
  hair.taken = {std::vector<bool>(model.meshes[0].triangles.size() / 3, true), {}, {}};
  EXPECT_TRUE(find_hair_cores(model, hair, kHead).taken[2].empty());
}

TEST(HairCore, IsTakenWithTheHairAndSaidSo) {
  importer::SourceModel model = head_with(kTail, kTail);
  Findings findings;
  const auto choice = choose_hair(model, default_recipe(), findings);
  ASSERT_TRUE(choice);
  EXPECT_EQ(std::ranges::count(choice->taken[1], true), std::ptrdiff_t(kTriangles));
  ASSERT_EQ(findings.notes.size(), 2u);
  EXPECT_NE(findings.notes[1].find("mesh 'person' (240 triangles): what hair is wrapped around"), std::string::npos)
      << findings.notes[1];
  model.meshes[1].name = "hair_accessories";
  EXPECT_TRUE(choose_hair(model, default_recipe(), unheard())->taken[1].empty()) << "called what is worn";
}

}  // namespace coif::cook::hair_core_test
