// Strips over the head: unwrapped half by half onto the same part of a texture, or in one piece from ear to ear.

#include "cook/strands/patches.h"
#include "cook/strands/strand_direction.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace coif::cook::split_folds_test {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr std::uint32_t kRows = 16;

/// A strip that lies over a head from ear to ear; `uv_at` from places across it and along it, 0..1.
HairMesh band(const std::function<Vector2f(float across, float along)>& uv_at, std::uint32_t columns = 2) {
  importer::SourceMesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t c = 0; c <= columns; ++c) {
      const float along = float(row) / kRows, across = float(c) / float(columns), turn = 3.14159f * along;
      mesh.positions.emplace_back(-0.1f * std::cos(turn), 1.6f + 0.1f * std::sin(turn), 0.03f * across);
      mesh.uvs.push_back(uv_at(across, along));
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t v = row * (columns + 1) + c, below = v + columns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {v, below, v + 1, v + 1, below, below + 1});
    }
  }
  return hair_from(mesh);
}

Vector2f from_the_middle(float across, float along) { return {0.1f * across, std::abs(2 * along - 1)}; }

struct Split {
  HairStrips hair;
  std::uint32_t more = 0;
  Findings findings;
};

Split split(const HairMesh& mesh) {
  Split result{strips_from(mesh), 0, {}};
  result.more = split_folds(result.hair, result.findings);
  return result;
}

TEST(SplitFolds, AStripOverThePartingIsTwo) {
  const Split found = split(band(from_the_middle));
  EXPECT_EQ(found.more, 1u);
  ASSERT_EQ(found.hair.patches.count, 2u);
  EXPECT_EQ(found.hair.patches.number_of(1), 0u) << "known by the number of the whole";
  for (std::uint32_t t = 0; t < found.hair.mesh.triangle_count(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float x = found.hair.mesh.corner(t, k).x();
      EXPECT_GE(found.hair.patches.patch_of[t] == found.hair.patches.patch_of[0] ? -x : x, -1e-5f) << t;
    }
  }
  ASSERT_EQ(found.findings.notes.size(), 1u);
  EXPECT_EQ(found.findings.notes[0], "patches: the texture turns back within 1, which are cut there into 2");
}

TEST(SplitFolds, StrandsMayRunAlongUAsWell) {
  const auto sideways = [](float across, float along) { return Vector2f(std::abs(2 * along - 1), 0.1f * across); };
  EXPECT_EQ(split(band(sideways)).more, 1u);
}

TEST(SplitFolds, ATextureThatTurnsTwiceGivesThree) {
  const auto twice = [](float across, float along) {
    const float third = 3 * along, rest = third - std::floor(third);
    return Vector2f(0.1f * across, int(third) % 2 == 0 ? rest : 1 - rest);
  };
  EXPECT_EQ(split(band(twice)).more, 2u);
}

TEST(SplitFolds, WhatIsUnwrappedInOnePieceStaysOne) {
  EXPECT_EQ(split(band([](float across, float along) { return Vector2f(0.1f * across, along); })).more, 0u);
  HairMesh untextured = band(from_the_middle);
  untextured.uvs.clear();
  EXPECT_EQ(split(untextured).more, 0u);
}

TEST(SplitFolds, ATextureUsedTwiceSideBySideStaysOne) {
  const auto mirrored = [](float across, float along) { return Vector2f(0.1f * std::abs(2 * across - 1), along); };
  EXPECT_EQ(split(band(mirrored, 2)).more, 0u);
  EXPECT_EQ(split(band(mirrored, 6)).more, 0u);
}

TEST(SplitFolds, AnEndThatIsTuckedUnderIsNoStrip) {
  const auto hem = [](float across, float along) {
    return Vector2f(0.1f * across, along <= 15.5f / kRows ? along : 14.0f / kRows);
  };
  HairMesh mesh = band(hem);
  const std::size_t last = mesh.positions.size() - 3, before = last - 3;
  for (std::size_t c = 0; c < 3; ++c)
    mesh.positions[last + c] = mesh.positions[before + c] + Vector3f(0.001f, -0.001f, 0);
  EXPECT_EQ(split(mesh).more, 0u);
}

TEST(SplitFolds, WithoutALongAxisNothingIsCut) {
  const auto square = [](float across, float along) { return Vector2f(across, 0.5f * std::abs(2 * along - 1)); };
  HairMesh wide = band(square, 12);
  for (Vector3f& p : wide.positions) p.z() *= 10;
  EXPECT_EQ(split(wide).more, 0u);
}

FittedHead head_below() {
  FittedHead head;
  head.center = {0, 1.6, 0.015};
  head.radii = {0.09, 0.1, 0.09};
  return head;
}

/// The band in one piece, its places from ear to ear; `moved` changes where its vertices are.
HairStrips whole_band(const std::function<Vector3f(const Vector3f&, float along)>& moved) {
  HairStrips hair = strips_from(band([](float across, float along) { return Vector2f(0.1f * across, along); }));
  for (std::size_t v = 0; v < hair.mesh.positions.size(); ++v) {
    const float along = hair.mesh.uvs[v].y();
    hair.mesh.positions[v] = moved(hair.mesh.positions[v], along);
    hair.strands.place.push_back(along);
    hair.strands.tangent.push_back(Vector3f::UnitX());
  }
  return hair;
}

std::uint32_t cut(HairStrips hair, const std::string& root = "auto") {
  Findings findings;
  const std::uint32_t more = split_partings(hair, head_below(), std::vector<std::string>{root}, findings);
  EXPECT_EQ(findings.notes.size(), more > 0 ? 1u : 0u);
  for (std::uint32_t t = 0; more > 0 && t < hair.mesh.triangle_count(); ++t) {
    const float x = (hair.mesh.corner(t, 0) + hair.mesh.corner(t, 1) + hair.mesh.corner(t, 2)).x() / 3;
    EXPECT_EQ(hair.patches.patch_of[t], x > 0 ? 1u : 0u);
  }
  return more;
}

const auto kAsItIs = [](const Vector3f& p, float) { return p; };

TEST(SplitPartings, HairFromEarToEarGrowsAtTheParting) { EXPECT_EQ(cut(whole_band(kAsItIs)), 1u); }

TEST(SplitPartings, ARecipeThatSaysWhereTheRootIsHolds) {
  EXPECT_EQ(cut(whole_band(kAsItIs), "low_v"), 0u);
  EXPECT_EQ(cut(whole_band(kAsItIs), "swap"), 0u);
}

TEST(SplitPartings, HairCombedOverToOneSideStaysWhole) {
  EXPECT_EQ(cut(whole_band([](const Vector3f& p, float along) {  // the other side ends high on the head
              const float turn = 3.14159f * (0.35f + 0.65f * along);
              return Vector3f(-0.1f * std::cos(turn), 1.6f + 0.1f * std::sin(turn), p.z());
            })),
            0u);
  EXPECT_EQ(cut(whole_band([](const Vector3f& p, float along) {  // or hangs down to a tail
              return Vector3f(p.x(), p.y() - (along > 0.8f ? along - 0.8f : 0), p.z());
            })),
            0u);
}

TEST(SplitPartings, HairFromTheForeheadToATieStaysWhole) {
  EXPECT_EQ(cut(whole_band([](const Vector3f& p, float) { return Vector3f(p.z(), p.y(), p.x()); })), 0u);
}

/// Round the head from the left temple over the nape and back, `turns` of the way; `lift` metres off it, both ends
/// `rise` above the middle.
std::uint32_t cut_wreath(float turns, float lift, float rise) {
  HairStrips hair = whole_band([&](const Vector3f&, float along) {
    const float angle = 6.2832f * turns * (along - 0.5f), radius = 0.09f + lift;
    return Vector3f(radius * std::sin(angle), 1.58f + rise * std::abs(2 * along - 1),
                    0.015f - radius * std::cos(angle));
  });
  Findings findings;
  const std::uint32_t more = split_partings(hair, head_below(), std::vector<std::string>{"auto"}, findings);
  for (std::uint32_t t = 0; more > 0 && t < hair.mesh.triangle_count(); ++t) {
    float along = 0;
    for (std::uint32_t k = 0; k < 3; ++k) along += hair.mesh.uvs[hair.mesh.triangles[3 * t + k]].y() / 3;
    if (std::abs(along - 0.5f) <= 0.1f) continue;
    EXPECT_EQ(hair.patches.patch_of[t], along > 0.5f ? 1u : 0u) << along;
  }
  return more;
}

TEST(SplitPartings, HairRoundTheHeadFromAPartingToItsOtherSideMeetsWhereItIsLowest) {
  EXPECT_EQ(cut_wreath(0.95f, 0.005f, 0.09f), 1u);
  EXPECT_EQ(cut_wreath(0.8f, 0.02f, 0.07f), 1u);
}

TEST(SplitPartings, AWreathAQuarterOfTheHeadAndALoopThatHangsOffItStayWhole) {
  EXPECT_EQ(cut_wreath(0.95f, 0.005f, 0), 0u) << "as high all round: a braid laid about the head";
  EXPECT_EQ(cut_wreath(0.4f, 0.005f, 0.09f), 0u) << "from ear to ear";
  EXPECT_EQ(cut_wreath(0.95f, 0.1f, 0.09f), 0u) << "off the head";
}

}  // namespace coif::cook::split_folds_test
