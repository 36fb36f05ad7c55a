#pragma once

// One list of columns defines the records of a report in all its forms: JSON, tables of the page, a terminal's lines.

#include "base/json.h"
#include "report/page/report_format.h"
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
#include <vector>

namespace coif::report {

/// A column of the page's table; with a null heading there is none. Columns are sorted by their places; those of one
/// place keep the order of the list, which is that of the JSON.
struct PageColumn {
  const char* heading = nullptr;
  Format format{};
  int place = 0;
  bool is_prose = false;  ///< Broken into lines where it is long.
};

/// A column of the terminal's table, likewise.
struct TextColumn {
  const char* heading = nullptr;
  int width = 0;  ///< Letters; negative: left-aligned.
  Format format{};
  int place = 0;
};

/// As a key: the column exists only in the terminal's table.
inline constexpr const char* kNoKey = nullptr;

/// A column, whatever records it is of.
struct ColumnForm {
  const char* key = kNoKey;  ///< In JSON.
  bool is_number = false;
  PageColumn page;
  TextColumn text;
};

/// A value of a record in JSON: null for a number that does not exist.
template <typename Value>
[[nodiscard]] nlohmann::ordered_json value_json(const Value& value) {
  if constexpr (std::convertible_to<Value, std::optional<double>> && !std::integral<Value>) {
    return number_json(std::optional<double>(value).value_or(kNoNumber));
  } else {
    return value;
  }
}

/// A column of records of that type.
template <typename Record>
struct Column : ColumnForm {
  /// `of`: a member of the record, or a function of it, whose value is a text, a bool, an unsigned number, an optional,
  /// or several.
  template <typename Of>
  Column(const char* json_key, Of of, PageColumn on_page = {}, TextColumn in_text = {})
      : ColumnForm{json_key, false, std::move(on_page), std::move(in_text)} {
    using Value = std::remove_cvref_t<std::invoke_result_t<Of, const Record&>>;
    is_number = std::convertible_to<Value, std::optional<double>> && !std::same_as<Value, bool>;
    if (is_number && page.format.pattern.empty()) page.format.pattern = std::integral<Value> ? "{}" : "{number}";
    value = [of](const Record& record) { return value_json<Value>(std::invoke(of, record)); };
  }

  std::function<nlohmann::ordered_json(const Record&)> value;
};

/// A list of columns that can be composed of others.
template <typename Record>
struct Columns : std::vector<Column<Record>> {
  using std::vector<Column<Record>>::vector;

  void add(Column<Record> column) { this->push_back(std::move(column)); }
  void append(const Columns& more) { this->insert(this->end(), more.begin(), more.end()); }
  /// All columns except those with these keys.
  [[nodiscard]] Columns without(std::initializer_list<std::string_view> keys) const {
    Columns rest = *this;
    std::erase_if(rest, [&](const Column<Record>& column) {
      return column.key != nullptr && std::ranges::find(keys, std::string_view(column.key)) != keys.end();
    });
    return rest;
  }
  [[nodiscard]] std::vector<ColumnForm> forms() const { return {this->begin(), this->end()}; }
};

/// How the page shows a list: "key", "title" and "kind" of each column, and its format where it differs from the
/// default.
[[nodiscard]] nlohmann::ordered_json page_columns(const std::vector<ColumnForm>& columns);
[[nodiscard]] std::string text_heading(const std::vector<ColumnForm>& columns);
/// `values`: one for each column.
[[nodiscard]] std::string text_line(const std::vector<ColumnForm>& columns,
                                    const std::vector<nlohmann::ordered_json>& values);

template <typename Record>
[[nodiscard]] nlohmann::ordered_json json_of(const Columns<Record>& columns, const Record& record) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Column<Record>& column : columns) {
    if (column.key != nullptr) json[column.key] = column.value(record);
  }
  return json;
}

template <typename Record>
[[nodiscard]] nlohmann::ordered_json json_list(const Columns<Record>& columns, const std::vector<Record>& records) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Record& record : records) list.push_back(json_of(columns, record));
  return list;
}

template <typename Record>
[[nodiscard]] std::string text_lines(const Columns<Record>& columns, const std::vector<Record>& records) {
  const std::vector<ColumnForm> forms = columns.forms();
  std::string text;
  for (const Record& record : records) {
    std::vector<nlohmann::ordered_json> values;
    for (const Column<Record>& column : columns) {
      values.push_back(column.text.heading != nullptr ? column.value(record) : nlohmann::ordered_json());
    }
    text += text_line(forms, values);
  }
  return text;
}

/// Heading and lines; nothing without records.
template <typename Record>
[[nodiscard]] std::string text_table(const Columns<Record>& columns, const std::vector<Record>& records) {
  return records.empty() ? "" : text_heading(columns.forms()) + text_lines(columns, records);
}

/// Puts a list into a report, and its columns into "columns" beside the others. A key with dots is nested:
/// "file.chunks".
template <typename Record>
void add_list(nlohmann::ordered_json& report, const char* key, const Columns<Record>& columns,
              const std::vector<Record>& records) {
  report[key] = json_list(columns, records);
  report["columns"][key] = page_columns(columns.forms());
}

}  // namespace coif::report
