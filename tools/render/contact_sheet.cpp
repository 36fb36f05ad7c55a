#include "render/gallery.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace coif {
namespace {

/// A grey of the sheet's, sRGB.
using SheetGrey = std::uint8_t;

/// Lines of a small bitmap font, whose dots are squares of `dot` pixels.
class SheetText {
 public:
  /// Breaks `text` at spaces into lines no wider than `width` pixels; a longer word stays whole. ASCII only.
  SheetText(std::string_view text, std::uint32_t width, std::uint32_t dot);

  [[nodiscard]] std::uint32_t height() const;  ///< Pixels, with the space below each line.

  /// Its upper left corner at (x, y). What lies outside of `picture` is left out.
  void draw(Picture& picture, std::uint32_t x, std::uint32_t y, SheetGrey grey) const;

 private:
  std::string lines_;
  std::uint32_t line_count_ = 1;
  std::uint32_t dot_;
};

constexpr std::uint32_t kLineDots = 12;  // from line to line, as the font has it

struct FontVertex {
  float x, y, z;
  std::uint8_t color[4];
};

// The font's functions take text that they could change, and do not.
std::uint32_t width_in_dots(std::string text) { return std::uint32_t(stb_easy_font_width(text.data())); }

/// Rectangles of the letters' dots, four corners each.
std::vector<FontVertex> letter_boxes(std::string lines) {
  constexpr std::size_t kMostBytesOfALetter = 1024;
  std::vector<FontVertex> corners((lines.size() + 1) * kMostBytesOfALetter / sizeof(FontVertex));
  const int boxes = stb_easy_font_print(0, 0, lines.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(FontVertex)));
  corners.resize(std::size_t(boxes) * 4);
  return corners;
}

void fill(Picture& picture, std::uint32_t left, std::uint32_t top, std::uint32_t right, std::uint32_t bottom,
          SheetGrey grey) {
  for (std::uint32_t y = top; y < std::min(bottom, picture.height); ++y) {
    for (std::uint32_t x = left; x < std::min(right, picture.width); ++x) {
      std::fill_n(&picture.rgba[4 * (std::size_t{y} * picture.width + x)], 3, grey);
    }
  }
}

SheetText::SheetText(std::string_view text, std::uint32_t width, std::uint32_t dot) : dot_(dot) {
  std::string line;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const std::string longer = line.empty() ? std::string(word) : line + ' ' + std::string(word);
    if (line.empty() || width_in_dots(longer) * dot <= width) {
      line = longer;
      continue;
    }
    lines_ += line + '\n';
    ++line_count_;
    line = word;
  }
  lines_ += line;
}

std::uint32_t SheetText::height() const { return line_count_ * kLineDots * dot_; }

void SheetText::draw(Picture& picture, std::uint32_t x, std::uint32_t y, SheetGrey grey) const {
  const auto pixels = [this](float dots) { return std::uint32_t(std::lround(dots)) * dot_; };
  const std::vector<FontVertex> corners = letter_boxes(lines_);
  for (std::size_t box = 0; box < corners.size(); box += 4) {
    const FontVertex &first = corners[box], &opposite = corners[box + 2];
    fill(picture, x + pixels(first.x), y + pixels(first.y), x + pixels(opposite.x), y + pixels(opposite.y), grey);
  }
}

constexpr SheetGrey kPaper = 24, kTitle = 245, kCaption = 200;
constexpr std::uint32_t kGap = 8;         // pixels between tiles
constexpr std::uint32_t kDotTiles = 160;  // pixels of a tile's width for each pixel of a letter's dot

/// Where everything goes: sizes of a tile and of letters.
struct Layout {
  std::uint32_t tile_width = 0, tile_height = 0;
  std::uint32_t columns = 1;
  std::uint32_t dot = 1;

  [[nodiscard]] std::uint32_t sheet_width() const { return columns * (tile_width + kGap) + kGap; }
  [[nodiscard]] SheetText title(const SheetSection& section) const {
    return {section.title, sheet_width() - 2 * kGap, dot + 1};
  }
  [[nodiscard]] SheetText caption(const SheetTile& tile) const { return {tile.caption, tile_width, dot}; }

  /// Of the row's highest caption.
  [[nodiscard]] std::uint32_t caption_height(std::span<const SheetTile> row) const {
    std::uint32_t height = 0;
    for (const SheetTile& tile : row) height = std::max(height, caption(tile).height());
    return height;
  }
};

/// Calls `place(tiles, y)` for each row of a section, and returns where the next section begins.
template <typename Place>
std::uint32_t for_each_row(const Layout& layout, const SheetSection& section, std::uint32_t y, const Place& place) {
  y += layout.title(section).height() + kGap;
  const std::span<const SheetTile> tiles = section.tiles;
  for (std::size_t first = 0; first < tiles.size(); first += layout.columns) {
    const auto row = tiles.subspan(first, std::min<std::size_t>(layout.columns, tiles.size() - first));
    place(row, y);
    y += layout.tile_height + kGap + layout.caption_height(row) + kGap;
  }
  return y + kGap;
}

void copy_into(Picture& sheet, const Picture& tile, std::uint32_t x, std::uint32_t y) {
  for (std::uint32_t row = 0; row < tile.height; ++row) {
    std::copy_n(&tile.rgba[std::size_t{4} * row * tile.width], std::size_t{4} * tile.width,
                &sheet.rgba[4 * (std::size_t{y + row} * sheet.width + x)]);
  }
}

Picture empty_sheet(const Layout& layout, std::span<const SheetSection> sections) {
  Picture sheet;
  sheet.width = layout.sheet_width();
  sheet.height = kGap;
  for (const SheetSection& section : sections) {
    sheet.height = for_each_row(layout, section, sheet.height, [](std::span<const SheetTile>, std::uint32_t) {});
  }
  sheet.rgba.assign(std::size_t{4} * sheet.width * sheet.height, kPaper);
  for (std::size_t alpha = 3; alpha < sheet.rgba.size(); alpha += 4) sheet.rgba[alpha] = 255;
  return sheet;
}

Layout layout_of(std::span<const SheetSection> sections, std::uint32_t columns) {
  Layout layout;
  layout.columns = columns;
  for (const SheetSection& section : sections) {
    if (section.tiles.empty()) continue;
    layout.tile_width = section.tiles.front().picture.width;
    layout.tile_height = section.tiles.front().picture.height;
    layout.dot = std::max(1u, layout.tile_width / kDotTiles);
    break;
  }
  return layout;
}

}  // namespace

Picture contact_sheet(std::span<const SheetSection> sections, std::uint32_t columns) {
  const Layout layout = layout_of(sections, columns);
  Picture sheet = empty_sheet(layout, sections);
  std::uint32_t y = kGap;
  for (const SheetSection& section : sections) {
    layout.title(section).draw(sheet, kGap, y, kTitle);
    y = for_each_row(layout, section, y, [&](std::span<const SheetTile> row, std::uint32_t top) {
      std::uint32_t x = kGap;
      for (const SheetTile& tile : row) {
        copy_into(sheet, tile.picture, x, top);
        layout.caption(tile).draw(sheet, x, top + layout.tile_height + kGap, kCaption);
        x += layout.tile_width + kGap;
      }
    });
  }
  return sheet;
}

}  // namespace coif
