#include "render/gallery.h"
#include "render/picture_text.h"

#include <algorithm>
#include <vector>

namespace coif::render {
namespace {

constexpr std::uint8_t kPaper = 24;
constexpr PictureColor kTitle{245, 245, 245}, kCaption{200, 200, 200};
constexpr std::uint32_t kGap = 8;         // pixels between tiles
constexpr std::uint32_t kDotTiles = 160;  // pixels of a tile's width for each pixel of a letter's dot

/// Sizes and places of tiles and letters.
struct Layout {
  std::uint32_t tile_width = 0, tile_height = 0;
  std::uint32_t columns = 1;
  std::uint32_t dot = 1;

  [[nodiscard]] std::uint32_t sheet_width() const { return columns * (tile_width + kGap) + kGap; }
  [[nodiscard]] PictureText title(const SheetSection& section) const {
    return {section.title, sheet_width() - 2 * kGap, dot + 1};
  }
  [[nodiscard]] PictureText caption(const SheetTile& tile) const { return {tile.caption, tile_width, dot}; }

  /// Height of the row's highest caption.
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

}  // namespace coif::render
