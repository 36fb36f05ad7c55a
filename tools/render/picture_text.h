#pragma once

#include "render/picture.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace coif::render {

using PictureColor = std::array<std::uint8_t, 3>;  ///< sRGB.

/// Lines of a small bitmap font, whose dots are squares of `dot` pixels.
class PictureText {
 public:
  /// Breaks `text` at spaces into lines no wider than `width` pixels; a longer word stays whole. ASCII only.
  PictureText(std::string_view text, std::uint32_t width, std::uint32_t dot);

  [[nodiscard]] std::uint32_t width() const;   ///< Pixels, of the longest line.
  [[nodiscard]] std::uint32_t height() const;  ///< Pixels, with the space below each line.

  /// Its upper left corner is at (x, y). Parts outside `picture` are left out.
  void draw(Picture& picture, std::uint32_t x, std::uint32_t y, const PictureColor& color) const;

 private:
  std::string lines_;
  std::uint32_t line_count_ = 1;
  std::uint32_t dot_;
};

/// Fills from the upper left corner up to but not including the lower right one; parts outside the picture are left
/// out.
void fill_rectangle(Picture& picture, std::uint32_t left, std::uint32_t top, std::uint32_t right, std::uint32_t bottom,
                    const PictureColor& color);

}  // namespace coif::render
