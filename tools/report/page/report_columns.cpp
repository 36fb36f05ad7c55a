#include "report/page/report_columns.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::report {
namespace {

/// Indices of the columns that a form has (&ColumnForm::page or text), in its order.
template <typename Form>
std::vector<std::size_t> placed(const std::vector<ColumnForm>& columns, Form ColumnForm::*form) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if ((columns[i].*form).heading != nullptr) shown.push_back(i);
  }
  std::ranges::stable_sort(shown, {}, [&](std::size_t i) { return (columns[i].*form).place; });
  return shown;
}

std::string padded(const std::string& text, int width) {
  return width < 0 ? fmt::format("{:<{}}", text, -width) : fmt::format("{:>{}}", text, width);
}

nlohmann::ordered_json page_column(const ColumnForm& column) {
  const Format& format = column.page.format;
  const char* const kind = column.page.is_prose ? "prose" : column.is_number ? "number" : "words";
  nlohmann::ordered_json json{{"key", column.key}, {"title", column.page.heading}, {"kind", kind}};
  if (!format.pattern.empty()) json["pattern"] = format.pattern;
  if (format.missing != "-") json["missing"] = format.missing;
  if (format.scale != 1) json["scale"] = format.scale;
  if (!format.looks.is_null()) json["looks"] = format.looks;
  return json;
}

}  // namespace

nlohmann::ordered_json page_columns(const std::vector<ColumnForm>& columns) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::size_t i : placed(columns, &ColumnForm::page)) list.push_back(page_column(columns[i]));
  return list;
}

std::string text_heading(const std::vector<ColumnForm>& columns) {
  std::string line = "  ";
  for (const std::size_t i : placed(columns, &ColumnForm::text)) {
    line += padded(columns[i].text.heading, columns[i].text.width);
  }
  return line + "\n";
}

std::string text_line(const std::vector<ColumnForm>& columns, const std::vector<nlohmann::ordered_json>& values) {
  std::string line = "  ";
  for (const std::size_t i : placed(columns, &ColumnForm::text)) {
    line += padded(columns[i].text.format.text(values[i]), columns[i].text.width);
  }
  return line + "\n";
}

}  // namespace coif::report
