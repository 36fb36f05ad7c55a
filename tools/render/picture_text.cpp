#include "render/picture_text.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif::render {
namespace {

constexpr std::uint32_t kLineDots = 12;  // Line spacing of the font.

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

}  // namespace

void fill_rectangle(Picture& picture, std::uint32_t left, std::uint32_t top, std::uint32_t right, std::uint32_t bottom,
                    const PictureColor& color) {
  for (std::uint32_t y = top; y < std::min(bottom, picture.height); ++y) {
    for (std::uint32_t x = left; x < std::min(right, picture.width); ++x) {
      std::ranges::copy(color, &picture.rgba[4 * (std::size_t{y} * picture.width + x)]);
    }
  }
}

PictureText::PictureText(std::string_view text, std::uint32_t width, std::uint32_t dot) : dot_(dot) {
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

std::uint32_t PictureText::width() const { return width_in_dots(lines_) * dot_; }

std::uint32_t PictureText::height() const { return line_count_ * kLineDots * dot_; }

void PictureText::draw(Picture& picture, std::uint32_t x, std::uint32_t y, const PictureColor& color) const {
  const auto pixels = [this](float dots) { return std::uint32_t(std::lround(dots)) * dot_; };
  const std::vector<FontVertex> corners = letter_boxes(lines_);
  for (std::size_t box = 0; box < corners.size(); box += 4) {
    const FontVertex &first = corners[box], &opposite = corners[box + 2];
    fill_rectangle(picture, x + pixels(first.x), y + pixels(first.y), x + pixels(opposite.x), y + pixels(opposite.y),
                   color);
  }
}

}  // namespace coif::render
