#include "render/contact_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace coif {
namespace {

constexpr std::uint32_t kWidth = 120, kHeight = 70;  // of a tile

using Color = std::array<std::uint8_t, 4>;

Picture plain_picture(const Color& color) {
  Picture picture{kWidth, kHeight, {}, {}, 0};
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i)
    picture.rgba.insert(picture.rgba.end(), color.begin(), color.end());
  return picture;
}

Color tile_color(std::size_t section, std::size_t tile) {
  return {std::uint8_t(200 + section), std::uint8_t(tile), 9, 255};
}

Color pixel(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  Color color;
  std::copy_n(&picture.rgba[4 * (std::size_t{y} * picture.width + x)], 4, color.begin());
  return color;
}

/// The smallest box around all pixels of a colour, and how many there are.
struct Box {
  std::uint32_t left = ~0u, top = ~0u, right = 0, bottom = 0;  ///< right and bottom: one behind the last.
  std::uint32_t pixels = 0;
  [[nodiscard]] bool is_a_whole_tile() const {
    return pixels == kWidth * kHeight && right - left == kWidth && bottom - top == kHeight;
  }
};

template <typename Wanted>
Box box_of(const Picture& picture, const Wanted& wanted) {
  Box box;
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      if (!wanted(pixel(picture, x, y))) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1),
             box.pixels + 1};
    }
  }
  return box;
}

Box box_of_tile(const Picture& sheet, std::size_t section, std::size_t tile) {
  return box_of(sheet, [&](const Color& color) { return color == tile_color(section, tile); });
}

/// Grey that is not paper.
Box box_of_letters(const Picture& sheet) {
  return box_of(sheet, [](const Color& c) { return c[0] == c[1] && c[1] == c[2] && c[0] > 100; });
}

std::vector<SheetSection> sections_of(const std::vector<std::size_t>& tiles, const std::string& caption = "") {
  std::vector<SheetSection> sections;
  for (std::size_t s = 0; s < tiles.size(); ++s) {
    SheetSection& section = sections.emplace_back();
    for (std::size_t t = 0; t < tiles[s]; ++t) section.tiles.push_back({caption, plain_picture(tile_color(s, t))});
  }
  return sections;
}

TEST(ContactSheet, HoldsEveryTileWhole) {
  const std::vector<std::size_t> tiles{5, 1, 3};
  const Picture sheet = contact_sheet(sections_of(tiles), 3);
  ASSERT_EQ(sheet.rgba.size(), std::size_t{4} * sheet.width * sheet.height);
  for (std::size_t s = 0; s < tiles.size(); ++s) {
    for (std::size_t t = 0; t < tiles[s]; ++t) EXPECT_TRUE(box_of_tile(sheet, s, t).is_a_whole_tile()) << s << ' ' << t;
  }
}

TEST(ContactSheet, FillsRowsFromTheLeftAndSectionsFromTheTop) {
  const Picture sheet = contact_sheet(sections_of({5, 1}), 3);
  EXPECT_LT(box_of_tile(sheet, 0, 0).right, box_of_tile(sheet, 0, 1).left);
  EXPECT_EQ(box_of_tile(sheet, 0, 0).top, box_of_tile(sheet, 0, 2).top);
  EXPECT_LT(box_of_tile(sheet, 0, 0).bottom, box_of_tile(sheet, 0, 3).top);
  EXPECT_EQ(box_of_tile(sheet, 0, 0).left, box_of_tile(sheet, 0, 3).left);
  EXPECT_LT(box_of_tile(sheet, 0, 4).bottom, box_of_tile(sheet, 1, 0).top);
}

TEST(ContactSheet, LettersLieBelowTheirTileAndNoWiderThanIt) {
  const Picture sheet = contact_sheet(sections_of({1}, "some words that are wider than one tile of it"), 3);
  const Box tile = box_of_tile(sheet, 0, 0), letters = box_of_letters(sheet);
  EXPECT_TRUE(tile.is_a_whole_tile());
  EXPECT_GT(letters.pixels, 100u);
  EXPECT_GE(letters.top, tile.bottom);
  EXPECT_GE(letters.left, tile.left);
  EXPECT_LE(letters.right, tile.right);
  EXPECT_LE(letters.bottom, sheet.height);
}

TEST(ContactSheet, LongCaptionsMakeRoomForTheirLines) {
  const Picture brief = contact_sheet(sections_of({1}, "brief"), 1);
  const Picture wordy = contact_sheet(sections_of({1}, "some words that are wider than one tile of it"), 1);
  EXPECT_EQ(brief.width, wordy.width);
  EXPECT_GT(wordy.height, brief.height);
  EXPECT_GT(box_of_letters(wordy).bottom, box_of_letters(brief).bottom);
}

TEST(ContactSheet, TitlesStandAboveTheirTiles) {
  std::vector<SheetSection> sections = sections_of({1, 1});
  sections[1].title = "a title";
  const Picture sheet = contact_sheet(sections, 2);
  EXPECT_GE(box_of_letters(sheet).top, box_of_tile(sheet, 0, 0).bottom);
  EXPECT_LE(box_of_letters(sheet).bottom, box_of_tile(sheet, 1, 0).top);
}

TEST(ContactSheet, OfNothingIsOfNothing) {
  const Picture sheet = contact_sheet({}, 6);
  EXPECT_EQ(sheet.rgba.size(), std::size_t{4} * sheet.width * sheet.height);
  EXPECT_EQ(box_of_letters(sheet).pixels, 0u);
}

}  // namespace
}  // namespace coif
