#include "report/page/order_tables.h"

#include "report/page/cost_cells.h"
#include "report/page/cost_rows.h"
#include "report/page/number_text.h"

#include <fmt/format.h>

namespace coif {
namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;

/// The eye finds no difference from some 40 dB on, and plain ones below some 30.
Cell decibel_cell(double db) {
  constexpr double kGoodDb = 40, kBadDb = 30;
  const CellLook look = db >= kGoodDb ? CellLook::kGood : db < kBadDb ? CellLook::kBad : CellLook::kNeutral;
  return {fmt::format("{:.1f} dB", db), look};
}

const std::vector<Column> kErrorColumns = {{"PSNR", kNumbers},
                                           {"median view", kNumbers},
                                           {"worst view", kNumbers},
                                           {"RMS error", kNumbers},
                                           {"pixels off by > 0.1", kNumbers}};

void add_error(const OrderError& error, std::vector<Cell>& cells) {
  cells.push_back(decibel_cell(error.psnr_db));
  cells.push_back(decibel_cell(error.median_psnr_db));
  cells.push_back(decibel_cell(error.worst_psnr_db));
  cells.push_back({number_text(error.rmse)});
  cells.push_back({percent_text(error.bad_pixels_pct)});
}

Table error_table(std::vector<Column> first, const std::vector<Column>& last) {
  first.insert(first.end(), kErrorColumns.begin(), kErrorColumns.end());
  first.insert(first.end(), last.begin(), last.end());
  return {std::move(first), {}};
}

Cell popping_cell(const std::optional<double>& popping) { return {popping ? number_text(*popping) : "-"}; }

Cell time_cell(double ms) { return {time_text(1e6 * ms)}; }

}  // namespace

Table orders_table(const OrderReport& report) {
  Table table = error_table({{"pose"}, {"order"}, {"faces"}},
                            {{"popping", kNumbers}, {"time a frame", kNumbers}, {"indices", kNumbers}});
  for (const OrderRow& row : report.rows) {
    std::vector<Cell> cells = {{row.pose}, {row.order}, {row.faces_together ? "together" : "apart"}};
    add_error(row.error, cells);
    cells.insert(cells.end(),
                 {popping_cell(row.popping), time_cell(row.ms_per_frame), {bytes_text(double(row.bytes))}});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table order_modes_table(const OrderReport& report) {
  Table table = error_table({{"pose"}, {"transparency"}, {"samples", kNumbers}},
                            {{"popping", kNumbers}, {"time a frame", kNumbers}});
  for (const OrderModeRow& row : report.modes) {
    std::vector<Cell> cells = {{row.pose}, {row.transparency}, count_cell(row.samples)};
    add_error(row.error, cells);
    cells.insert(cells.end(), {popping_cell(row.popping), time_cell(row.ms_per_frame)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table thresholds_table(const OrderReport& report) {
  Table table = error_table({{"opaque from", kNumbers}, {""}}, {});
  for (const ThresholdRow& row : report.thresholds) {
    std::vector<Cell> cells = {{fmt::format("{:.3f}", row.opaque_threshold)}, {row.is_own ? "the asset's" : ""}};
    add_error(row.error, cells);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table order_distances_table(const OrderReport& report) {
  Table table{{{"height in pixels", kNumbers},
               {"covers, finest level", kNumbers},
               {"level a game draws", kNumbers},
               {"covers", kNumbers}},
              {}};
  for (const DistanceRow& row : report.distance) {
    table.rows.push_back({count_cell(row.pixels),
                          {fmt::format("{:.1f} %", row.coverage_pct)},
                          count_cell(row.lod),
                          {fmt::format("{:.1f} %", row.lod_coverage_pct)}});
  }
  return table;
}

Table order_reference_table(const OrderReport& report) {
  Table table{{{"exact picture against"}, {"PSNR", kNumbers}, {"largest difference", kNumbers}}, {}};
  for (const SelfDifferenceRow& row : report.reference) {
    table.rows.push_back({{row.against}, decibel_cell(row.psnr_db), {number_text(row.max_difference)}});
  }
  return table;
}

}  // namespace coif
