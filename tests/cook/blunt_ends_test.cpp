#include "cook/texture/patch_coverage.h"

#include "cook/built_models.h"
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace coif::cook::blunt_ends_test {

const Eigen::Vector3d kHead{0, 1.6, 0};

/// Patches whose strands run along V, in front of a head's centre.
struct Wig {
  void add(const importer::SourceMesh& piece) {
    patches.patch_of.insert(patches.patch_of.end(), piece.triangles.size() / 3, patches.count++);
    append_piece(all, piece, 0);
  }

  [[nodiscard]] Told<std::vector<std::uint32_t>> ends(const AlphaTest& opaque = {}, unsigned threads = 1) const {
    HairStrips hair = strips_from(hair_from(all), patches);
    for (const Eigen::Vector2f& uv : hair.mesh.uvs) hair.strands.place.push_back(uv.y());
    hair.strands.tangent.assign(hair.mesh.positions.size(), {0, -1, 0});
    FittedHead head;
    head.center = kHead;
    head.radii.setConstant(0.1);
    // Vertices at one place count as one, whatever piece they are of.
    for (std::size_t v = 0; v < hair.welded.size(); ++v) {
      const auto first = std::ranges::find(hair.mesh.positions, hair.mesh.positions[v]);
      hair.welded[v] = std::uint32_t(first - hair.mesh.positions.begin());
    }
    return told([&](Findings& findings) { return find_blunt_ends(hair, head, opaque, threads, findings); });
  }

  importer::SourceMesh all;
  PatchSet patches;
};

std::size_t blunt_ends(const importer::SourceMesh& piece, const AlphaTest& opaque = {}) {
  Wig wig;
  wig.add(piece);
  return wig.ends(opaque).made.size();
}

const StripDesc kStrip{.root = {0, 1.6f, 0.12f}, .rows = 6};

importer::SourceMesh strip_at(float x, float z, float length = 0.3f) {
  StripDesc desc = kStrip;
  desc.root = {x, 1.6f, z};
  desc.along = {0, -length, 0};
  return make_strip(desc);
}

TEST(BluntEnds, AStripCutStraightEndsHard) {
  Wig wig;
  wig.add(make_strip(kStrip));
  EXPECT_EQ(wig.ends().made, std::vector<std::uint32_t>{0});
}

TEST(BluntEnds, AStripThatNarrowsDoesNot) {
  StripDesc desc = kStrip;
  for (const float width : {0.9f, 0.7f}) {
    desc.tip_width = width;
    EXPECT_EQ(blunt_ends(make_strip(desc)), 1u) << width;
  }
  for (const float width : {0.4f, 0.1f, 0.0f}) {
    desc.tip_width = width;
    EXPECT_EQ(blunt_ends(make_strip(desc)), 0u) << width;
  }
}

TEST(BluntEnds, AStripMayBeWidestAnywhereBeforeItsTip) {
  for (int widest = 0; widest < 9; ++widest) {
    StripDesc desc = kStrip;
    desc.rows = 100;
    importer::SourceMesh strip = make_strip(desc);
    for (std::uint32_t row = 10 * std::uint32_t(widest) + 3; row <= 10 * std::uint32_t(widest) + 7; ++row) {
      for (std::uint32_t v = 2 * row; v < 2 * row + 2; ++v) strip.positions[v].x() *= 2.5f;
    }
    EXPECT_EQ(blunt_ends(strip), 0u) << "its tip is two fifths as wide as it is at " << 0.1 * widest + 0.05;
  }
}

/// Alpha by place along the strip.
Image fading(const std::function<double(double)>& alpha) {
  return painted(8, 128, [&](auto, std::uint32_t y) { return Rgba{9, 9, 9, std::uint8_t(255 * alpha(y / 128.0))}; });
}

TEST(BluntEnds, AlphaThatFadesMakesThemSoft) {
  const Image even = fading([](double v) { return 1 - v; });
  const Image late = fading([](double v) { return v < 0.9 ? 1 : 0.5; });
  const Image never = fading([](double v) { return v < 0.5 ? 1 : 0.9; });
  const auto with = [](const Image& image, double threshold) { return AlphaTest{&image, 1, threshold}; };
  EXPECT_EQ(blunt_ends(make_strip(kStrip), with(even, 0.8)), 0u);
  EXPECT_EQ(blunt_ends(make_strip(kStrip), with(late, 0.8)), 0u);
  EXPECT_EQ(blunt_ends(make_strip(kStrip), with(never, 0.8)), 1u);
  EXPECT_EQ(blunt_ends(make_strip(kStrip), with(even, 0)), 1u) << "all of it is drawn as opaque";
  const Image faint = fading([](double) { return 0.5; });
  EXPECT_EQ(blunt_ends(make_strip(kStrip), with(faint, 0.8)), 0u) << "opaque nowhere";
}

TEST(BluntEnds, StrandsThatThinOutAreSoftAndThoseCutAtOnceAreHard) {
  // Four opaque strands across the strip; below `from` one of them is left.
  const auto strands = [](std::uint32_t from) {
    return painted(64, 64, [=](std::uint32_t x, std::uint32_t y) {
      const bool opaque = x % 16 < 8 && (y < from || x < 16);
      return Rgba{9, 9, 9, opaque ? std::uint8_t{255} : std::uint8_t{0}};
    });
  };
  const Image thinning = strands(48), cut = strands(64);
  EXPECT_EQ(blunt_ends(make_strip(kStrip), {&thinning, 1, 0.8}), 0u);
  EXPECT_EQ(blunt_ends(make_strip(kStrip), {&cut, 1, 0.8}), 1u);
}

/// A flat tube: two sheets that share their sides and both ends.
importer::SourceMesh closed_lock() {
  importer::SourceMesh lock;
  for (const float bulge : {0.01f, -0.01f}) {
    const auto base = std::uint32_t(lock.positions.size());
    for (std::uint32_t row = 0; row <= 4; ++row) {
      for (std::uint32_t column = 0; column < 3; ++column) {
        const bool inside = column == 1 && row > 0 && row < 4;
        lock.positions.emplace_back(0.02f * float(column), 1.6f - 0.05f * float(row), 0.12f + (inside ? bulge : 0));
        lock.uvs.emplace_back(0.5f * float(column), 0.25f * float(row));
      }
    }
    for (std::uint32_t row = 0; row < 4; ++row) {
      for (std::uint32_t column = 0; column < 2; ++column) {
        const std::uint32_t a = base + row * 3 + column;
        lock.triangles.insert(lock.triangles.end(), {a, a + 3, a + 1, a + 1, a + 3, a + 4});
      }
    }
  }
  return lock;
}

TEST(BluntEnds, ClosedShapesHaveNoEdgeToShow) {
  Wig wig;
  wig.add(closed_lock());
  EXPECT_TRUE(wig.ends().made.empty());
  importer::SourceMesh opened = closed_lock();
  opened.triangles.resize(opened.triangles.size() / 2);  // One of the sheets.
  EXPECT_EQ(blunt_ends(opened), 1u);
}

TEST(BluntEnds, AnEdgeThatAnotherPatchContinuesIsNotFree) {
  Wig wig;
  wig.add(strip_at(0, 0.12f, 0.25f));
  StripDesc below = kStrip;
  below.root = {0, 1.6f - 0.25f, 0.12f};
  wig.add(make_strip(below));
  EXPECT_EQ(wig.ends().made, std::vector<std::uint32_t>{1});
}

TEST(BluntEnds, HalfOfItsEdgeMustBeFree) {
  // Columns of equal width; below all but so many of them another patch goes on.
  for (const auto& [columns, free, hard] : {std::tuple{2, 2, true}, {2, 1, true}, {4, 1, false}, {4, 2, true}}) {
    Wig wig;
    importer::SourceMesh strip, below;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column <= columns; ++column) {
        importer::SourceMesh& mesh = row < 2 ? strip : below;
        mesh.positions.emplace_back(0.03125f * float(column), 1.5f - 0.25f * float(row), 0.125f);
        mesh.uvs.emplace_back(0.0f, float(row % 2));
      }
    }
    below.positions.insert(below.positions.begin(), strip.positions.begin() + columns + 1, strip.positions.end());
    below.uvs.insert(below.uvs.begin(), strip.uvs.begin(), strip.uvs.begin() + columns + 1);
    for (int column = 0; column < columns; ++column) {
      const auto a = std::uint32_t(column), b = a + std::uint32_t(columns) + 1;
      for (const std::uint32_t corner : {a, b, a + 1, a + 1, b, b + 1}) {
        strip.triangles.push_back(corner);
        if (column >= free) below.triangles.push_back(corner);
      }
    }
    wig.add(strip);
    wig.add(below);
    EXPECT_EQ(std::ranges::count(wig.ends().made, 0u), hard ? 1 : 0) << free << " of " << columns;
  }
}

TEST(BluntEnds, EndsUnderOtherHairDoNotShow) {
  Wig covered;
  covered.add(strip_at(0, 0.12f, 0.2f));
  covered.add(strip_at(0, 0.13f));
  EXPECT_EQ(covered.ends().made, std::vector<std::uint32_t>{1}) << "the longer one, which lies above";
  Wig above;
  above.add(strip_at(0, 0.13f, 0.2f));
  above.add(strip_at(0, 0.12f));
  EXPECT_EQ(above.ends().made, (std::vector<std::uint32_t>{0, 1})) << "a layer cut straight over longer hair";
}

TEST(BluntEnds, EndsThatOtherHairTakesUpDoNotShow) {
  // Strands run down to y = 1.3; there a band lies across them, or far below.
  for (const auto& [height, hard] : {std::pair{1.28f, false}, {1.1f, true}}) {
    StripDesc band;
    band.root = {-0.1f, height, 0.11f};
    band.along = {0.2f, 0, 0};
    band.across = {0, 0, 0.03f};  // Not in the way of who looks from outside.
    Wig wig;
    wig.add(strip_at(0, 0.12f));
    wig.add(make_strip(band));
    const auto ends = wig.ends();
    EXPECT_EQ(std::ranges::count(ends.made, 0u), hard ? 1 : 0) << height;
  }
}

TEST(BluntEnds, AWarningNamesTheirShareWhereItIsMoreThanAFew) {
  for (const std::uint32_t hard : {0u, 1u, 5u, 10u}) {
    Wig wig;
    for (std::uint32_t i = 0; i < 10; ++i) {
      StripDesc desc = kStrip;
      desc.root.x() = 0.1f * float(i);
      desc.tip_width = i < hard ? 1.0f : 0.1f;
      wig.add(make_strip(desc));
    }
    const auto ends = wig.ends();
    EXPECT_EQ(ends.made.size(), hard);
    ASSERT_EQ(ends.warnings.size(), hard > 1 ? 1u : 0u) << hard;
    if (hard > 1) {
      const std::string share = std::to_string(10 * hard) + " % of the patches (" + std::to_string(hard) + " of 10)";
      EXPECT_EQ(ends.warnings[0].message.rfind(share, 0), 0u) << ends.warnings[0].message;
    }
    EXPECT_EQ(wig.ends({}, 4).made, ends.made) << "threads do not matter";
  }
}

TEST(BluntEnds, NoHairHasNone) { EXPECT_TRUE(Wig().ends().made.empty()); }

}  // namespace coif::cook::blunt_ends_test
