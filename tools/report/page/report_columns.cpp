#include "report/page/report_columns.h"

#include <fmt/format.h>

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
  const std::uint64_t* count = std::get_if<std::uint64_t>(&value);
  if (of_number_) return of_number_(count != nullptr ? double(*count) : std::get<double>(value));
  return {count != nullptr ? std::to_string(*count) : number_text(std::get<double>(value))};
}

nlohmann::ordered_json column_json(const ColumnValue& value) {
  if (const Cell* cell = std::get_if<Cell>(&value)) return cell->text;
  if (const bool* yes = std::get_if<bool>(&value)) return *yes;
  if (const std::uint64_t* count = std::get_if<std::uint64_t>(&value)) return *count;
  return number_json(std::get<double>(value));
}

std::string padded(const std::string& text, int width) {
  return width < 0 ? fmt::format("{:<{}}", text, -width) : fmt::format("{:>{}}", text, width);
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
