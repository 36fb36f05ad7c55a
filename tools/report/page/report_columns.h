#pragma once

// One list of columns says how the records of a report look in all its forms: JSON, tables of a page, a terminal's
// lines.

#include "base/json.h"
#include "report/page/html_page.h"
#include "report/page/report_heading.h"

#include <algorithm>
#include <array>
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

/// What a column has of a record. NaN stands for a number that does not exist; a list in JSON are three numbers.
using ColumnValue = std::variant<Cell, bool, std::uint64_t, double, std::array<double, 3>>;

/// Text, cells and directions as they are; numbers that may be missing as numbers or NaN.
template <typename Value>
[[nodiscard]] ColumnValue column_value(const Value& value) {
  if constexpr (std::same_as<Value, bool> || std::same_as<Value, Cell> || std::same_as<Value, std::array<double, 3>>) {
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

/// A column, whatever records it is of.
struct ReportColumn {
  const char* key = kNoKey;                              ///< In JSON.
  std::function<ColumnValue(const void* record)> value;  ///< Of a record of the list's type.
  Column::Kind kind = Column::Kind::kWords;
  PageColumn page;
  TextColumn text;
};

/// A column of records of that type.
template <typename Record>
struct ColumnOf : ReportColumn {
  /// `of`: a member of the record, or a function of it; to text, a Cell, bool, an unsigned number or one that may be
  /// missing.
  template <typename Of>
  ColumnOf(const char* json_key, Of of, PageColumn on_page = {}, TextColumn in_text = {}) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Of, const Record&>>;
    constexpr bool is_number = std::convertible_to<Value, std::optional<double>> && !std::same_as<Value, bool>;
    key = json_key;
    value = [of](const void* record) {
      return column_value<Value>(std::invoke(of, *static_cast<const Record*>(record)));
    };
    kind = on_page.is_prose ? Column::Kind::kProse : is_number ? Column::Kind::kNumbers : Column::Kind::kWords;
    page = std::move(on_page);
    text = std::move(in_text);
  }
};

using ColumnList = std::vector<ReportColumn>;
using RecordList = std::vector<const void*>;

/// A list of columns that knows what they are of. Only its making and the steps through records are compiled for each
/// type.
template <typename Record>
class Columns {
 public:
  Columns(std::initializer_list<ColumnOf<Record>> columns) {
    for (const ReportColumn& column : columns) list_.push_back(column);
  }
  void add(ColumnOf<Record> column) { list_.push_back(std::move(column)); }
  /// Puts all of `more` behind these.
  void append(const Columns& more) { list_.insert(list_.end(), more.list_.begin(), more.list_.end()); }
  /// All but those with these keys.
  [[nodiscard]] Columns without(std::initializer_list<std::string_view> keys) const {
    Columns rest = *this;
    std::erase_if(rest.list_, [&](const ReportColumn& column) {
      return column.key != nullptr && std::ranges::find(keys, std::string_view(column.key)) != keys.end();
    });
    return rest;
  }

  [[nodiscard]] const ColumnList& list() const { return list_; }

 private:
  ColumnList list_;
};

[[nodiscard]] nlohmann::ordered_json json_of(const ColumnList& columns, const void* record);
[[nodiscard]] nlohmann::ordered_json json_list(const ColumnList& columns, const RecordList& records);
[[nodiscard]] Table page_table(const ColumnList& columns, const RecordList& records);
[[nodiscard]] std::string text_heading(const ColumnList& columns);
[[nodiscard]] std::string text_lines(const ColumnList& columns, const RecordList& records);

template <typename Record>
[[nodiscard]] RecordList places_of(const std::vector<Record>& records) {
  RecordList places;
  for (const Record& record : records) places.push_back(&record);
  return places;
}

template <typename Record>
[[nodiscard]] nlohmann::ordered_json json_of(const Columns<Record>& columns, const Record& record) {
  return json_of(columns.list(), static_cast<const void*>(&record));
}

template <typename Record>
[[nodiscard]] nlohmann::ordered_json json_list(const Columns<Record>& columns, const std::vector<Record>& records) {
  return json_list(columns.list(), places_of(records));
}

template <typename Record>
[[nodiscard]] Table page_table(const Columns<Record>& columns, const std::vector<Record>& records) {
  return page_table(columns.list(), places_of(records));
}

template <typename Record>
[[nodiscard]] std::string text_heading(const Columns<Record>& columns) {
  return text_heading(columns.list());
}

template <typename Record>
[[nodiscard]] std::string text_lines(const Columns<Record>& columns, const std::vector<Record>& records) {
  return text_lines(columns.list(), places_of(records));
}

/// Heading and lines; nothing without records.
template <typename Record>
[[nodiscard]] std::string text_table(const Columns<Record>& columns, const std::vector<Record>& records) {
  return records.empty() ? "" : text_heading(columns) + text_lines(columns, records);
}

/// time_text() of microseconds and of milliseconds.
[[nodiscard]] std::string microseconds_text(double us);
[[nodiscard]] std::string milliseconds_text(double ms);

/// Half the width of the middle half of samples, which `spread_pct` is, in % of their median; stands out where the
/// machine was not steady.
[[nodiscard]] Cell spread_cell(double spread_pct);

}  // namespace coif
