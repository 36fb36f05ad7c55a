#pragma once

// One list of columns says how the records of a report look in all its forms: JSON, tables of a page, a terminal's lines.

#include "base/json.h"
#include "report/page/html_page.h"
#include "report/page/report_heading.h"

#include <algorithm>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace coif {

/// What a column has of a record. NaN stands for a number that does not exist.
using ColumnValue = std::variant<Cell, bool, std::uint64_t, double>;

/// Text and cells as they are; numbers that may be missing as numbers or NaN.
template <typename Value>
[[nodiscard]] ColumnValue column_value(const Value& value) {
  if constexpr (std::same_as<Value, bool> || std::same_as<Value, Cell>) {
    return value;
  } else if constexpr (std::unsigned_integral<Value>) {
    return std::uint64_t{value};
  } else if constexpr (std::convertible_to<Value, std::optional<double>>) {
    return std::optional<double>(value).value_or(kNoNumber);
  } else {
    return Cell{std::string(value)};
  }
}

/// How a number becomes a cell. Values of other kinds need none: text is shown as it is, true and false as yes and no.
class CellFormat {
 public:
  /// number_text() of numbers, counts with all their digits.
  CellFormat() = default;
  /// From double to text or to a cell: percent_text.
  template <typename Format>
  requires std::invocable<Format, double> CellFormat(Format format)
      : of_number_([format](double number) { return Cell{format(number)}; }) {}
  /// A pattern of fmt: "{:.1f} dB". `missing`: instead of NaN, where that is not null.
  CellFormat(const char* pattern, const char* missing = nullptr);

  [[nodiscard]] Cell operator()(const ColumnValue& value) const;

 private:
  std::function<Cell(double)> of_number_;
};

/// A column of a page's table. Without a heading (null) there is none.
struct PageColumn {
  const char* heading = nullptr;
  CellFormat format{};
  int place =
      0;  ///< Columns stand by their places, those of one place as in the list, which is in the order of the JSON.
  bool is_prose = false;
};

/// A column of a terminal's table. Without a heading (null) there is none.
struct TextColumn {
  const char* heading = nullptr;
  int width = 0;  ///< Letters; negative: left-aligned.
  CellFormat format{};
  int place = 0;  ///< As a PageColumn's.
};

/// As a key: the column is in tables only.
inline constexpr const char* kNoKey = nullptr;

template <typename Record>
struct ReportColumn {
  /// `of`: a member of the record, or a function of it; to text, a Cell, bool, an unsigned number or one that may be missing.
  template <typename Of>
  ReportColumn(const char* json_key, Of of, PageColumn on_page = {}, TextColumn in_text = {})
      : key(json_key), page(std::move(on_page)), text(std::move(in_text)) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Of, const Record&>>;
    constexpr bool is_number = std::convertible_to<Value, std::optional<double>> && !std::same_as<Value, bool>;
    kind = page.is_prose ? Column::Kind::kProse : is_number ? Column::Kind::kNumbers : Column::Kind::kWords;
    value = [of](const Record& record) { return column_value<Value>(std::invoke(of, record)); };
  }

  const char* key;  ///< In JSON.
  std::function<ColumnValue(const Record&)> value;
  Column::Kind kind;
  PageColumn page;
  TextColumn text;
};

template <typename Record>
using Columns = std::vector<ReportColumn<Record>>;

[[nodiscard]] nlohmann::ordered_json column_json(const ColumnValue& value);
[[nodiscard]] std::string padded(const std::string& text, int width);

/// Those that are in a form (&ReportColumn::page or text), in its order.
template <typename Record, typename Form>
[[nodiscard]] std::vector<const ReportColumn<Record>*> placed(const Columns<Record>& columns,
                                                              Form ReportColumn<Record>::*form) {
  std::vector<const ReportColumn<Record>*> shown;
  for (const auto& column : columns) {
    if ((column.*form).heading != nullptr) shown.push_back(&column);
  }
  std::ranges::stable_sort(shown, {}, [form](const auto* column) { return (column->*form).place; });
  return shown;
}

template <typename Record>
[[nodiscard]] nlohmann::ordered_json json_of(const Columns<Record>& columns, const Record& record) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& column : columns) {
    if (column.key != nullptr) json[column.key] = column_json(column.value(record));
  }
  return json;
}

template <typename Record>
[[nodiscard]] nlohmann::ordered_json json_list(const Columns<Record>& columns, const std::vector<Record>& records) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const Record& record : records) array.push_back(json_of(columns, record));
  return array;
}

template <typename Record>
[[nodiscard]] Table page_table(const Columns<Record>& columns, const std::vector<Record>& records) {
  const auto shown = placed(columns, &ReportColumn<Record>::page);
  Table table;
  for (const auto* column : shown) table.columns.push_back({column->page.heading, column->kind});
  for (const Record& record : records) {
    table.rows.emplace_back();
    for (const auto* column : shown) table.rows.back().push_back(column->page.format(column->value(record)));
  }
  return table;
}

template <typename Record>
[[nodiscard]] std::string text_heading(const Columns<Record>& columns) {
  std::string line = "  ";
  for (const auto* column : placed(columns, &ReportColumn<Record>::text)) {
    line += padded(column->text.heading, column->text.width);
  }
  return line + "\n";
}

template <typename Record>
[[nodiscard]] std::string text_lines(const Columns<Record>& columns, const std::vector<Record>& records) {
  const auto shown = placed(columns, &ReportColumn<Record>::text);
  std::string text;
  for (const Record& record : records) {
    text += "  ";
    for (const auto* column : shown) {
      text += padded(column->text.format(column->value(record)).text, column->text.width);
    }
    text += "\n";
  }
  return text;
}

/// Heading and lines; nothing without records.
template <typename Record>
[[nodiscard]] std::string text_table(const Columns<Record>& columns, const std::vector<Record>& records) {
  return records.empty() ? "" : text_heading(columns) + text_lines(columns, records);
}

/// All columns but those with these keys.
template <typename Record>
[[nodiscard]] Columns<Record> without(Columns<Record> columns, std::initializer_list<std::string_view> keys) {
  std::erase_if(columns, [&](const auto& column) {
    return column.key != nullptr && std::ranges::find(keys, std::string_view(column.key)) != keys.end();
  });
  return columns;
}

/// Puts all of `more` behind `columns`.
template <typename Record>
void append(Columns<Record>& columns, const Columns<Record>& more) {
  columns.insert(columns.end(), more.begin(), more.end());
}

/// time_text() of microseconds and of milliseconds.
[[nodiscard]] std::string microseconds_text(double us);
[[nodiscard]] std::string milliseconds_text(double ms);

/// Half the width of the middle half of samples, which `spread_pct` is, in % of their median; stands out where the
/// machine was not steady.
[[nodiscard]] Cell spread_cell(double spread_pct);

}  // namespace coif
