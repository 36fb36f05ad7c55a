#include "report/page/html_page.h"

#include "base/encodings.h"
#include "base/text.h"

#include <fmt/format.h>

#include <cstddef>

namespace coif {

namespace {

/// Style sheet of every page. Wide tables scroll in their own frame so that their header can stay in sight; on paper
/// they run on, the header repeats on every sheet and the colours are printed.
constexpr char kPageStyle[] = R"(:root {
  color-scheme: light dark;
  --text: #1d2228; --ground: #ffffff; --raised: #f1f3f5; --line: #cfd4da;
  --good: #cdeccf; --neutral: #e2e5e9; --warning: #fbe3ad; --bad: #f7c4c0;
}
@media (prefers-color-scheme: dark) {
  :root {
    --text: #e3e6ea; --ground: #16191d; --raised: #22272d; --line: #3d444c;
    --good: #1f4d2a; --neutral: #363c44; --warning: #5f4a12; --bad: #6b2723;
  }
}
body { color: var(--text); background: var(--ground); font: 15px/1.5 system-ui, sans-serif;
  max-width: 82rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.6rem; }
h2 { font-size: 1.2rem; margin-top: 2.2rem; break-after: avoid; border-bottom: 1px solid var(--line); }
p { max-width: 52rem; }
a { color: inherit; text-decoration-color: #2f8fd8; text-underline-offset: 0.15em; }
.summary { font-size: 1.1rem; background: var(--raised); border-left: 4px solid #2f8fd8; padding: 0.7rem 1rem; }
.table { overflow: auto; max-height: 90vh; margin: 1rem 0; }
table { border-collapse: collapse; }
th, td { padding: 0.2rem 0.7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top;
  white-space: nowrap; }
th { position: sticky; top: 0; background: var(--raised); }
.prose { white-space: normal; min-width: 11rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.good { background: var(--good); }
.neutral { background: var(--neutral); }
.warning { background: var(--warning); }
.bad { background: var(--bad); }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { width: 100%; max-width: 60rem; height: auto; }
figure img { max-width: 100%; }
figcaption { font-size: 0.9rem; max-width: 52rem; }
@media print {
  :root { --text: #000000; --ground: #ffffff; --raised: #f1f3f5; --line: #cfd4da;
    --good: #cdeccf; --neutral: #e2e5e9; --warning: #fbe3ad; --bad: #f7c4c0; }
  body { max-width: none; margin: 0; font-size: 10pt; }
  .table { overflow: visible; max-height: none; }
  th { position: static; }
  thead { display: table-header-group; }
  tr { break-inside: avoid; }
  table { font-size: 8pt; }
  th { white-space: normal; }
  th, td { padding: 0.1rem 0.4rem; print-color-adjust: exact; }
  .prose { min-width: 6rem; }
}
)";

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
    html += markup_text(text.substr(0, end));
    if (end == std::string_view::npos) return html;
    html += "<br>";
    text.remove_prefix(end + 1);
  }
}

std::string head_row(const std::vector<Column>& columns) {
  std::string html = "<tr>";
  for (const Column& column : columns) {
    html +=
        fmt::format("<th scope=\"col\"{}>{}</th>", class_attribute(class_of(column.kind)), markup_text(column.title));
  }
  return html + "</tr>";
}

std::string image(std::span<const std::uint8_t> png, std::string_view meaning) {
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", markup_text(meaning), base64(png));
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

HtmlPage::HtmlPage(std::string_view title) : title_(markup_text(title)) {}

void HtmlPage::element(std::string_view tag, std::string_view text) {
  const std::string_view name = tag.substr(0, tag.find(' '));
  body_ += fmt::format("<{}>{}</{}>\n", tag, markup_text(text), name);
}

void HtmlPage::heading(std::string_view text) { element("h2", text); }
void HtmlPage::summary(std::string_view text) { element("p class=\"summary\"", text); }
void HtmlPage::paragraph(std::string_view text) {
  if (!text.empty()) element("p", text);
}

void HtmlPage::links(std::string_view lead, std::span<const PageLink> links) {
  if (links.empty()) return;
  body_ += "<p>" + markup_text(lead);
  for (std::size_t i = 0; i < links.size(); ++i) {
    body_ += fmt::format("{}<a href=\"{}\">{}</a>", i > 0 ? ", " : "", markup_text(links[i].url),
                         markup_text(links[i].text));
  }
  body_ += "</p>\n";
}

void HtmlPage::table(const Table& table) {
  body_ += "<div class=\"table\"><table>\n<thead>" + head_row(table.columns) + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) body_ += body_row(table.columns, row);
  body_ += "</tbody></table></div>\n";
}

void HtmlPage::figure(const Figure& figure) {
  body_ += fmt::format("<figure>\n{}\n", draw(figure.plot, fmt::format("figure{}_", ++figures_)));
  element("figcaption", figure.caption);
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

}  // namespace coif
