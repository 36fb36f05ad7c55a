#include "report/page/report_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {

CellFormat::CellFormat(const char* pattern, const char* missing)
    : of_number_([pattern, missing](double number) {
        const bool is_missing = missing != nullptr && std::isnan(number);
        return Cell{is_missing ? missing : fmt::format(fmt::runtime(pattern), number)};
      }) {}

Cell CellFormat::operator()(const ColumnValue& value) const {
  if (const Cell* cell = std::get_if<Cell>(&value)) return *cell;
  if (const bool* yes = std::get_if<bool>(&value)) return {*yes ? "yes" : "no"};
  if (const auto* three = std::get_if<std::array<double, 3>>(&value)) {
    return {fmt::format("{:.3f} {:.3f} {:.3f}", (*three)[0], (*three)[1], (*three)[2])};
  }
  const std::uint64_t* count = std::get_if<std::uint64_t>(&value);
  if (of_number_) return of_number_(count != nullptr ? double(*count) : std::get<double>(value));
  return {count != nullptr ? std::to_string(*count) : number_text(std::get<double>(value))};
}

namespace {

nlohmann::ordered_json value_json(const ColumnValue& value) {
  if (const Cell* cell = std::get_if<Cell>(&value)) return cell->text;
  if (const bool* yes = std::get_if<bool>(&value)) return *yes;
  if (const std::uint64_t* count = std::get_if<std::uint64_t>(&value)) return *count;
  if (const auto* three = std::get_if<std::array<double, 3>>(&value)) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const double number : *three) list.push_back(number_json(number));
    return list;
  }
  return number_json(std::get<double>(value));
}

std::string padded(const std::string& text, int width) {
  return width < 0 ? fmt::format("{:<{}}", text, -width) : fmt::format("{:>{}}", text, width);
}

/// Those that are in a form (&ReportColumn::page or text), in its order.
template <typename Form>
std::vector<const ReportColumn*> placed(const ColumnList& columns, Form ReportColumn::*form) {
  std::vector<const ReportColumn*> shown;
  for (const ReportColumn& column : columns) {
    if ((column.*form).heading != nullptr) shown.push_back(&column);
  }
  std::ranges::stable_sort(shown, {}, [form](const ReportColumn* column) { return (column->*form).place; });
  return shown;
}

}  // namespace

nlohmann::ordered_json json_of(const ColumnList& columns, const void* record) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const ReportColumn& column : columns) {
    if (column.key != nullptr) json[column.key] = value_json(column.value(record));
  }
  return json;
}

nlohmann::ordered_json json_list(const ColumnList& columns, const RecordList& records) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const void* record : records) array.push_back(json_of(columns, record));
  return array;
}

Table page_table(const ColumnList& columns, const RecordList& records) {
  const auto shown = placed(columns, &ReportColumn::page);
  Table table;
  for (const ReportColumn* column : shown) table.columns.push_back({column->page.heading, column->kind});
  for (const void* record : records) {
    table.rows.emplace_back();
    for (const ReportColumn* column : shown) table.rows.back().push_back(column->page.format(column->value(record)));
  }
  return table;
}

std::string text_heading(const ColumnList& columns) {
  std::string line = "  ";
  for (const ReportColumn* column : placed(columns, &ReportColumn::text)) {
    line += padded(column->text.heading, column->text.width);
  }
  return line + "\n";
}

std::string text_lines(const ColumnList& columns, const RecordList& records) {
  const auto shown = placed(columns, &ReportColumn::text);
  std::string text;
  for (const void* record : records) {
    text += "  ";
    for (const ReportColumn* column : shown) {
      text += padded(column->text.format(column->value(record)).text, column->text.width);
    }
    text += "\n";
  }
  return text;
}

std::string microseconds_text(double us) { return time_text(1e3 * us); }
std::string milliseconds_text(double ms) { return time_text(1e6 * ms); }

Cell spread_cell(double spread_pct) {
  // Samples that differ by a quarter are of a machine that had other work.
  constexpr double kUnsteadyPct = 25;
  const std::string text = fmt::format("\u00b1{:.1f} %", spread_pct / 2);
  return {text, spread_pct > kUnsteadyPct ? CellLook::kWarning : CellLook::kPlain};
}

}  // namespace coif
