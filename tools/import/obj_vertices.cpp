#include "import/asked_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace coif::importer {
namespace {

constexpr std::size_t kPlace = 3, kWithColor = 6;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// The words of a vertex's line behind its "v"; empty for other lines.
std::size_t count_words(std::string_view line) {
  if (line.size() < 2 || line[0] != 'v' || !is_blank(line[1])) return 0;
  std::size_t count = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (!is_blank(line[i]) && line[i] != '\r' && is_blank(line[i - 1])) ++count;
  }
  return count;
}

/// The beginning of the line with `count` words behind its "v".
std::string_view first_words(std::string_view line, std::size_t count) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const bool begins = !is_blank(line[i]) && is_blank(line[i - 1]);
    if (begins && count-- == 0) return line.substr(0, i);
  }
  return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

/// The notation of colours: some programs write whole numbers up to 255.
struct ColorNumbers {
  bool are_whole = true, are_bright = false;
};

ColorNumbers color_numbers(std::string_view line) {
  const std::string color(line.substr(first_words(line, kPlace).size()));
  ColorNumbers out;
  const char* at = color.c_str();
  for (int k = 0; k < 3; ++k) {
    char* end = nullptr;
    const float number = std::strtof(at, &end);
    out.are_whole = out.are_whole && number == std::floor(number);
    out.are_bright = out.are_bright || number > 2;
    at = end;
  }
  return out;
}

void for_each_line(std::string_view text, auto&& visit) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    visit(text.substr(at, end - at));
    at = end + 1;
  }
}

struct VertexLines {
  std::size_t plain = 0, colored = 0, longer = 0;
  bool are_whole = true, has_bright = false;  ///< For all colours.
};

VertexLines count_vertices(std::string_view text) {
  VertexLines lines;
  for_each_line(text, [&](std::string_view line) {
    const std::size_t words = count_words(line);
    if (words == 0) return;
    if (words < kWithColor) {
      ++lines.plain;
    } else {
      ++(words == kWithColor ? lines.colored : lines.longer);
      const ColorNumbers numbers = color_numbers(line);
      lines.are_whole = lines.are_whole && numbers.are_whole;
      lines.has_bright = lines.has_bright || numbers.are_bright;
    }
  });
  return lines;
}

}  // namespace

std::optional<std::string> text_with_even_colors(std::string_view text) {
  const VertexLines lines = count_vertices(text);
  const bool is_mixed = lines.plain != 0 && lines.colored != 0;
  if (lines.longer == 0 && !is_mixed) return std::nullopt;
  const char* const white = lines.are_whole && lines.has_bright ? " 255 255 255" : " 1 1 1";
  std::string out;
  for_each_line(text, [&](std::string_view line) {
    const std::size_t words = count_words(line);
    if (words >= kPlace && words < kWithColor) {
      out.append(first_words(line, kPlace)).append(white);
    } else {
      out.append(words > kWithColor ? first_words(line, kWithColor) : line);
    }
    out += '\n';
  });
  return out;
}

}  // namespace coif::importer
