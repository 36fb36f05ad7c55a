#pragma once

#include "report/page/plot.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// How a cell is coloured. The text must say the same: colours do not survive every printer and every eye.
enum class CellLook { kPlain, kGood, kNeutral, kWarning, kBad };

struct Cell {
  std::string text;  ///< Line feeds start new lines.
  CellLook look = CellLook::kPlain;
  std::span<const std::uint8_t> png{};  ///< Bytes of a PNG file, shown before the text; must live as long as the cell.
};

struct Column {
  enum class Kind {
    kWords,    ///< Never broken into lines.
    kNumbers,  ///< Right-aligned, digits of equal width.
    kProse,    ///< Broken into lines where it is long.
  };
  std::string title;
  Kind kind = Kind::kWords;
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< Short rows are filled up with empty cells.
};

/// To another document.
struct PageLink {
  std::string text;
  std::string url;
};

/// One HTML document that needs nothing but itself: no script, no file beside it, no network; its own policy forbids a
/// browser to fetch any. Readable on light and dark screens and on paper. Every text that comes in is escaped.
class HtmlPage {
 public:
  explicit HtmlPage(std::string_view title);

  void heading(std::string_view text);
  /// The sentence that a hurried reader should see.
  void summary(std::string_view text);
  /// Nothing for an empty text.
  void paragraph(std::string_view text);
  /// One after the other behind `lead`; nothing where there are none.
  void links(std::string_view lead, std::span<const PageLink> links);
  void table(const Table& table);
  void figure(const Figure& figure);
  /// Bytes of a PNG file, put into the page.
  void picture(std::span<const std::uint8_t> png, std::string_view caption);

  /// The whole document.
  [[nodiscard]] std::string text() const;

 private:
  void element(std::string_view tag, std::string_view text);

  std::string title_;
  std::string body_;
  unsigned figures_ = 0;
};

}  // namespace coif
