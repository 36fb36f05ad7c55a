#include "cook/texture/texture_atlas.h"
#include "cook/built_models.h"
#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace coif::cook::texture_atlas_test {

/// One strip for each rectangle of texture coordinates, each a surface of its own.
struct Surfaces {
  explicit Surfaces(std::span<const std::pair<Eigen::Vector2f, Eigen::Vector2f>> rectangles) {
    importer::SourceMesh mesh;
    for (const auto& [low, high] : rectangles) {
      const importer::SourceMesh strip = strip_over(low, high);
      of_triangle.insert(of_triangle.end(), strip.triangles.size() / 3, surfaces++);
      append_piece(mesh, strip, 0);
    }
    hair = hair_from(mesh);
  }

  HairMesh hair;
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t surfaces = 0;
};

using Rectangles = std::vector<std::pair<Eigen::Vector2f, Eigen::Vector2f>>;

TEST(TextureAtlas, NoTileTouchesAnother) {
  Surfaces surfaces(
      Rectangles{{{0, 0}, {1, 1}}, {{0.2f, 0.2f}, {0.4f, 0.9f}}, {{0, 0}, {1, 1}}, {{-0.5f, 0}, {1.4f, 1}}});
  const auto layout = lay_out_atlas(surfaces.hair, surfaces.of_triangle,
                                    std::vector<ImageSize>{{100, 60}, {256, 256}, {0, 0}, {33, 17}});
  ASSERT_TRUE(layout) << layout.error();
  ASSERT_EQ(layout->tiles.size(), 4u);
  Image owner{layout->width, layout->height, 1, std::vector<std::uint8_t>(layout->width * layout->height, 0)};
  for (const AtlasTile& tile : layout->tiles) {
    ASSERT_LE(tile.x + tile.width, layout->width);
    ASSERT_LE(tile.y + tile.height, layout->height);
    for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y) {
      for (std::uint32_t x = tile.x; x < tile.x + tile.width; ++x) ASSERT_EQ(owner.texels[y * owner.width + x]++, 0);
    }
  }
}

TEST(TextureAtlas, IsAsLargeWhateverTheOrderOfItsImages) {
  const std::vector<ImageSize> sorted{{96, 160}, {96, 128}, {96, 96}, {96, 64}, {96, 32}, {96, 16}};
  Surfaces surfaces(Rectangles(sorted.size(), {{0, 0}, {1, 1}}));
  const auto side_lengths = [&](const std::vector<ImageSize>& images) {
    const auto layout = lay_out_atlas(surfaces.hair, surfaces.of_triangle, images);
    EXPECT_TRUE(layout);
    return layout ? std::pair(layout->width, layout->height) : std::pair(0u, 0u);
  };
  for (const auto& order : {std::vector{5, 0, 4, 1, 3, 2}, {5, 4, 3, 2, 1, 0}, {0, 3, 1, 4, 2, 5}}) {
    std::vector<ImageSize> images;
    for (const int i : order) images.push_back(sorted[std::size_t(i)]);
    EXPECT_EQ(side_lengths(images), side_lengths(sorted)) << "the highest come first";
  }
}

TEST(TextureAtlas, MayBeAsWideAsImagesMayBe) {
  Surfaces surfaces(Rectangles{{{0, 0}, {1, 1}}});
  std::uint32_t width = kMaxImageSide;
  auto layout = lay_out_atlas(surfaces.hair, surfaces.of_triangle, std::vector<ImageSize>{{width, 4}});
  while (!layout) layout = lay_out_atlas(surfaces.hair, surfaces.of_triangle, std::vector<ImageSize>{{--width, 4}});
  EXPECT_EQ(layout->width, kMaxImageSide);
}

TEST(TextureAtlas, FourMipsKeepSurfacesApart) {
  Surfaces surfaces(Rectangles{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}, {{0.3f, 0.1f}, {0.7f, 0.6f}}});
  const Rgba colors[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}};
  const Image images[] = {flat(50, 70, colors[0]), flat(30, 20, colors[1]), flat(64, 64, colors[2])};
  const auto layout =
      lay_out_atlas(surfaces.hair, surfaces.of_triangle, std::vector<ImageSize>{{50, 70}, {30, 20}, {64, 64}});
  ASSERT_TRUE(layout);
  const Image* pointers[] = {&images[0], &images[1], &images[2]};
  const auto mips = make_mips(draw_atlas(*layout, pointers), 4096, TexelMeaning::kSrgbColorAlpha);
  move_uvs_to_atlas(*layout, surfaces.of_triangle, surfaces.hair);
  for (std::size_t level = 0; level <= 4; ++level) {
    for (std::size_t i = 0; i < surfaces.hair.triangles.size(); ++i) {
      const Eigen::Vector2f uv = surfaces.hair.uvs[surfaces.hair.triangles[i]];
      EXPECT_LE(difference(texel_at(mips[level], uv), colors[surfaces.of_triangle[i / 3]]), 1) << "level " << level;
    }
  }
}

TEST(TextureAtlas, ImagesMirroredOrRepeatedOnceStayInTheirTile) {
  // Coordinates beyond 1 on both sides: two repeats in all.
  Surfaces surfaces(Rectangles{{{-0.9f, 1.2f}, {1.0f, 2.1f}}, {{0, 0}, {1, 1}}});
  const Image stripes = painted(16, 16, [](std::uint32_t x, std::uint32_t y) {
    return Rgba{std::uint8_t(x * 16), std::uint8_t(y * 16), 0, 255};
  });
  const HairMesh before = surfaces.hair;
  const auto layout = lay_out_atlas(surfaces.hair, surfaces.of_triangle, std::vector<ImageSize>{{16, 16}, {16, 16}});
  ASSERT_TRUE(layout) << layout.error();
  const Image* pointers[] = {&stripes, &stripes};
  const Image atlas = draw_atlas(*layout, pointers);
  move_uvs_to_atlas(*layout, surfaces.of_triangle, surfaces.hair);
  for (std::size_t t = 0; t < surfaces.hair.triangles.size(); t += 3) {
    Eigen::Vector2f own = Eigen::Vector2f::Zero(), moved = own;
    for (std::size_t k = 0; k < 3; ++k) {
      own += before.uvs[before.triangles[t + k]] / 3;
      moved += surfaces.hair.uvs[surfaces.hair.triangles[t + k]] / 3;
    }
    EXPECT_LE(difference(texel_at(atlas, moved), texel_at(stripes, own)), 16) << "more than a texel off";
  }
}

TEST(TextureAtlas, AVertexOfTwoSurfacesBecomesTwo) {
  HairMesh hair = hair_from(make_strip({.rows = 2}));
  const std::size_t vertices = hair.positions.size();
  const std::vector<std::uint32_t> surface_of_triangle{0, 0, 1, 1};
  const auto layout = lay_out_atlas(hair, surface_of_triangle, std::vector<ImageSize>{{8, 8}, {8, 8}});
  ASSERT_TRUE(layout);
  const std::vector<Eigen::Vector3f> before = hair.positions;
  const std::vector<std::uint32_t> triangles = hair.triangles;
  move_uvs_to_atlas(*layout, surface_of_triangle, hair);
  EXPECT_EQ(hair.positions.size(), vertices + 2) << "the two of the row between them";
  EXPECT_EQ(hair.uvs.size(), hair.positions.size());
  EXPECT_EQ(hair.influence_begin.size(), hair.positions.size() + 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    EXPECT_EQ(hair.positions[hair.triangles[i]], before[triangles[i]]);
  }
}

TEST(TextureAtlas, RefusesWhatItCannotHold) {
  Surfaces often(Rectangles{{{0, 0}, {2.5f, 1}}});
  const std::vector<ImageSize> small{{16, 16}};
  EXPECT_FALSE(lay_out_atlas(often.hair, often.of_triangle, small));
  Surfaces far_off(Rectangles{{{50000, 0}, {50001, 1}}});
  EXPECT_FALSE(lay_out_atlas(far_off.hair, far_off.of_triangle, small)) << "no exact texels there";
  Surfaces bad(Rectangles{{{0, 0}, {1, 1}}});
  for (Eigen::Vector2f& uv : bad.hair.uvs) uv.x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(lay_out_atlas(bad.hair, bad.of_triangle, small));
  Surfaces two(Rectangles{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}});
  const auto huge = lay_out_atlas(two.hair, two.of_triangle, std::vector<ImageSize>{{8192, 8192}, {8192, 8192}});
  ASSERT_FALSE(huge);
  EXPECT_NE(huge.error().find("an atlas of"), std::string::npos);
}

constexpr std::uint32_t kWidth = 48, kHeight = 20;

Image used_where(auto&& is_used) {
  Image used{kWidth, kHeight, 1, std::vector<std::uint8_t>(std::size_t(kWidth) * kHeight, 0)};
  for (std::uint32_t i = 0; i < used.texels.size(); ++i) used.texels[i] = is_used(i % kWidth, i / kWidth) ? 255 : 0;
  return used;
}

Image everywhere() {
  return used_where([](auto, auto) { return true; });
}

Rgba texel(const Image& image, std::uint32_t x, std::uint32_t y) {
  Rgba result;
  std::copy_n(&image.texels[4 * (std::size_t(y) * image.width + x)], 4, result.begin());
  return result;
}

/// Two strands, red and green, with clear black between.
Image two_strands() {
  return painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t) {
    if (x / 4 == 2) return Rgba{220, 10, 10, 255};
    if (x / 4 == 9) return Rgba{10, 220, 10, 255};
    return Rgba{0, 0, 0, 0};
  });
}

TEST(FillGaps, ClearTexelsTakeTheColorOfTheNearestStrand) {
  Image image = two_strands();
  fill_gaps(image, everywhere());
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (const std::uint32_t x : {0u, 4u, 7u, 12u, 14u}) EXPECT_GT(texel(image, x, y)[0], 180) << x;
    for (const std::uint32_t x : {35u, 40u, 44u}) EXPECT_GT(texel(image, x, y)[1], 180) << x;
    for (std::uint32_t x = 0; x < kWidth; ++x) EXPECT_EQ(texel(image, x, y)[3], texel(two_strands(), x, y)[3]) << x;
  }
}

TEST(FillGaps, PaintedColorsStay) {
  Image image = painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t y) {
    return Rgba{std::uint8_t(5 * x), std::uint8_t(12 * y), 77, std::uint8_t(16 + 4 * x)};
  });
  const Image before = image;
  fill_gaps(image, everywhere());
  EXPECT_EQ(image.texels, before.texels);
}

TEST(FillGaps, TexelsAsGoodAsClearTakeTheColorAroundThem) {
  Image image = painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t) {
    return x % 4 == 1 ? Rgba{240, 230, 220, 255} : Rgba{0, 255, 0, 4};
  });
  fill_gaps(image, everywhere());
  for (std::uint32_t i = 0; i < image.texel_count(); ++i) {
    EXPECT_NEAR(image.texels[4 * i], 240, 1);
    EXPECT_NEAR(image.texels[4 * i + 2], 220, 1);
  }
}

TEST(FillGaps, WhatNoHairUsesContinuesTheHairBesideIt) {
  // Hair on the left; on the right something else of the same image, in a colour and with an alpha of its own.
  const auto is_hair = [](std::uint32_t x, std::uint32_t) { return x < 16; };
  Image image = painted(kWidth, kHeight, [&](std::uint32_t x, std::uint32_t y) {
    return is_hair(x, y) ? Rgba{120, 80, 40, 128} : Rgba{0, 0, 255, 255};
  });
  const Image before = image;
  fill_gaps(image, used_where(is_hair));
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      // One texel beside the hair, on both sides since images repeat, is within reach of filters.
      const bool within_reach = x <= 16 || x == kWidth - 1;
      EXPECT_LE(difference(texel(image, x, y), within_reach ? texel(before, x, y) : Rgba{120, 80, 40, 128}), 1) << x;
    }
  }
}

TEST(FillGaps, NothingUsedChangesNothing) {
  Image image = two_strands();
  fill_gaps(image, used_where([](auto, auto) { return false; }));
  EXPECT_EQ(image.texels, two_strands().texels);
}

TEST(FillGaps, AnImageWithoutAlphaKeepsItsColors) {
  Image image = painted(kWidth, kHeight, [](std::uint32_t x, std::uint32_t) { return Rgba{std::uint8_t(x), 9, 9, 0}; });
  const Image before = image;
  fill_gaps(image, everywhere());
  EXPECT_EQ(image.texels, before.texels);
}

/// Hair that fills the texels from `low` to `high` of an image of 64 x 64, and which of them it uses.
struct FilledPart {
  Eigen::Vector2f low, high;
  Image used;

  [[nodiscard]] bool holds(std::uint32_t x, std::uint32_t y) const {
    const Eigen::Vector2f middle(float(x) + 0.5f, float(y) + 0.5f);
    return (middle.array() > low.array()).all() && (middle.array() < high.array()).all();
  }
  [[nodiscard]] Image repeated(Image image) const {
    const auto borders = borders_where_pictures_end(hair_from(strip_over(low / 64, high / 64)), image);
    repeat_edges(borders, used, image);
    return image;
  }
};

/// Texels say where they lie; around the part they are of something blue.
Image in_an_atlas(const FilledPart& part) {
  return painted(64, 64, [&](std::uint32_t x, std::uint32_t y) {
    return part.holds(x, y) ? Rgba{std::uint8_t(x), std::uint8_t(y), 0, std::uint8_t(100 + x)} : Rgba{9, 9, 250, 255};
  });
}

Image used_between(std::uint32_t low_x, std::uint32_t low_y, std::uint32_t high_x, std::uint32_t high_y) {
  Image used{64, 64, 1, std::vector<std::uint8_t>(64 * 64, 0)};
  for (std::uint32_t y = low_y; y < high_y; ++y) {
    for (std::uint32_t x = low_x; x < high_x; ++x) used.texels[64 * y + x] = 255;
  }
  return used;
}

TEST(RepeatEdges, APartOfAnAtlasGoesOnAroundIt) {
  const FilledPart part{{16, 32}, {48, 52}, used_between(16, 32, 48, 52)};
  const Image before = in_an_atlas(part), image = part.repeated(before);
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) {
      const bool is_near = x >= 8 && x < 56 && y >= 24 && y < 60;
      const Rgba wanted =
          is_near ? texel(before, std::clamp(x, 16u, 47u), std::clamp(y, 32u, 51u)) : texel(before, x, y);
      EXPECT_EQ(texel(image, x, y), wanted) << x << ", " << y;
    }
  }
}

TEST(RepeatEdges, PartsAtTheImagesBorderGoOnBeyondItWhereItRepeats) {
  const FilledPart part{{0, 0}, {64, 32}, used_between(0, 0, 64, 32)};
  const Image before = in_an_atlas(part), image = part.repeated(before);
  EXPECT_EQ(texel(image, 5, 32), texel(before, 5, 31));
  EXPECT_EQ(texel(image, 5, 63), texel(before, 5, 0));
  EXPECT_EQ(texel(image, 5, 45), texel(before, 5, 45));
}

TEST(RepeatEdges, WhatHairUsesStays) {
  FilledPart part{{16, 32}, {48, 52}, used_between(16, 32, 48, 52)};
  part.used.texels[64 * 40 + 13] = 255;
  const Image before = in_an_atlas(part), image = part.repeated(before);
  EXPECT_EQ(texel(image, 14, 40), texel(before, 16, 40));
  EXPECT_EQ(texel(image, 13, 40), texel(before, 13, 40));
  EXPECT_EQ(texel(image, 12, 40), texel(before, 12, 40)) << "another strip begins there";
}

TEST(RepeatEdges, APictureThatGoesOnStays) {
  const FilledPart part{{16, 32}, {48, 52}, used_between(16, 32, 48, 52)};
  const auto faded = painted(64, 64, [](std::uint32_t x, std::uint32_t y) {
    return Rgba{std::uint8_t(3 * x), std::uint8_t(3 * y), 0, std::uint8_t(4 * x)};
  });
  EXPECT_EQ(part.repeated(faded).texels, faded.texels);
}

TEST(RepeatEdges, EdgesWithinATexelStay) {
  const FilledPart part{{16.5f, 32.5f}, {47.5f, 51.5f}, used_between(16, 32, 48, 52)};
  const Image before = in_an_atlas(part);
  EXPECT_EQ(part.repeated(before).texels, before.texels) << "what is painted beside is filtered by less than half";
}

}  // namespace coif::cook::texture_atlas_test
