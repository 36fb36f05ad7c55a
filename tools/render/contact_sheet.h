#pragma once
// Many small pictures on one.

#include "render/picture.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

struct SheetTile {
  std::string caption;  ///< Below the picture, broken into lines where it is wider.
  Picture picture;
};

/// Begins a new row beneath its title.
struct SheetSection {
  std::string title;
  std::vector<SheetTile> tiles;
};

/// All tiles have the first one's size; `columns` (> 0) of them make a row. ASCII only.
[[nodiscard]] Picture contact_sheet(std::span<const SheetSection> sections, std::uint32_t columns);

}  // namespace coif
