#pragma once

#include "render/picture.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace coif {

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

}  // namespace coif
