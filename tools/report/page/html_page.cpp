#include "report/page/html_page.h"

#include "base/encodings.h"
#include "base/text.h"
#include "report/page/page_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace coif {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : clean_text(text)) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += c;
    }
  }
  return result;
}

const char* class_of(CellLook look) {
  switch (look) {
    case CellLook::kPlain: return "";
    case CellLook::kGood: return "good";
    case CellLook::kNeutral: return "neutral";
    case CellLook::kWarning: return "warning";
    case CellLook::kBad: return "bad";
  }
  return "";
}

const char* class_of(Column::Kind kind) {
  switch (kind) {
    case Column::Kind::kWords: return "";
    case Column::Kind::kNumbers: return "number";
    case Column::Kind::kProse: return "prose";
  }
  return "";
}

std::string class_attribute(std::string_view first, std::string_view second = "") {
  if (first.empty() && second.empty()) return "";
  return fmt::format(" class=\"{}{}{}\"", first, first.empty() || second.empty() ? "" : " ", second);
}

std::string escaped_lines(std::string_view text) {
  std::string html;
  for (;;) {
    const std::size_t end = text.find('\n');
    html += escaped(text.substr(0, end));
    if (end == std::string_view::npos) return html;
    html += "<br>";
    text.remove_prefix(end + 1);
  }
}

std::string head_row(const std::vector<Column>& columns) {
  std::string html = "<tr>";
  for (const Column& column : columns) {
    html += fmt::format("<th scope=\"col\"{}>{}</th>", class_attribute(class_of(column.kind)), escaped(column.title));
  }
  return html + "</tr>";
}

std::string image(std::span<const std::uint8_t> png, std::string_view meaning) {
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(meaning), base64(png));
}

std::string body_row(const std::vector<Column>& columns, const std::vector<Cell>& cells) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Cell cell = i < cells.size() ? cells[i] : Cell{};
    html += fmt::format("<td{}>{}{}</td>", class_attribute(class_of(columns[i].kind), class_of(cell.look)),
                        cell.png.empty() ? "" : image(cell.png, ""), escaped_lines(cell.text));
  }
  return html + "</tr>\n";
}

}  // namespace

Cell count_cell(std::uint64_t count) { return {std::to_string(count)}; }

Cell spread_cell(double spread_pct) {
  // Samples that differ by a quarter are of a machine that had other work.
  constexpr double kUnsteadyPct = 25;
  const std::string text = fmt::format("\u00b1{:.1f} %", spread_pct / 2);
  return {text, spread_pct > kUnsteadyPct ? CellLook::kWarning : CellLook::kPlain};
}

HtmlPage::HtmlPage(std::string_view title) : title_(escaped(title)) {}

void HtmlPage::element(std::string_view tag, std::string_view text) {
  const std::string_view name = tag.substr(0, tag.find(' '));
  body_ += fmt::format("<{}>{}</{}>\n", tag, escaped(text), name);
}

void HtmlPage::heading(std::string_view text) { element("h2", text); }
void HtmlPage::summary(std::string_view text) { element("p class=\"summary\"", text); }
void HtmlPage::paragraph(std::string_view text) { element("p", text); }

void HtmlPage::table(const Table& table) {
  body_ += "<div class=\"table\"><table>\n<thead>" + head_row(table.columns) + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) body_ += body_row(table.columns, row);
  body_ += "</tbody></table></div>\n";
}

void HtmlPage::figure(std::string_view svg, std::string_view caption) {
  body_ += "<figure>\n" + scope_svg_ids(svg, fmt::format("figure{}_", ++figures_));
  body_ += "\n";
  element("figcaption", caption);
  body_ += "</figure>\n";
}

void HtmlPage::picture(std::span<const std::uint8_t> png, std::string_view caption) {
  body_ += fmt::format("<figure>\n{}\n", image(png, caption));
  element("figcaption", caption);
  body_ += "</figure>\n";
}

std::string HtmlPage::text() const {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      title_, kPageStyle, body_);
}

namespace {

// What an id stands behind, as gnuplot and most others write it.
constexpr std::string_view kBeforeId[] = {" id='",     " id=\"",   "xlink:href='#", "xlink:href=\"#",
                                          " href=\"#", " href='#", "url(#"};

std::string scoped_tag(std::string_view tag, std::string_view prefix) {
  std::string result;
  while (!tag.empty()) {
    const auto* const found =
        std::ranges::find_if(kBeforeId, [tag](std::string_view before) { return tag.starts_with(before); });
    const bool hit = found != std::end(kBeforeId);
    const std::size_t length = hit ? found->size() : 1;
    result += tag.substr(0, length);
    if (hit) result += prefix;
    tag.remove_prefix(length);
  }
  return result;
}

}  // namespace

std::string scope_svg_ids(std::string_view svg, std::string_view prefix) {
  std::string result;
  while (!svg.empty()) {
    const std::size_t open = std::min(svg.find('<'), svg.size());
    result += svg.substr(0, open);
    svg.remove_prefix(open);
    const std::size_t close = std::min(svg.find('>'), svg.size());
    result += scoped_tag(svg.substr(0, close), prefix);
    svg.remove_prefix(close);
  }
  return result;
}

}  // namespace coif
