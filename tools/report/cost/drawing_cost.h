#pragma once

// The results of `coif report cost` about drawing: records, measured by measure_drawing(), and the columns that show
// them. Times are medians of wall time until the device has finished; the spread beside each is the width of the middle
// half of its samples, in % of the median.

#include "report/page/report_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::report {

inline constexpr const char* kNotMeasured = "not measured";

/// Milliseconds that the device reports for itself; a column of the page where it did at least once.
[[nodiscard]] inline PageColumn on_the_device(bool is_told) {
  return {is_told ? "on the device" : nullptr, ms_format(kNotMeasured), 1};
}

template <typename Row>
[[nodiscard]] bool has_device_times(const std::vector<Row>& rows, std::optional<double> Row::*time) {
  return std::ranges::any_of(rows, [time](const Row& row) { return (row.*time).has_value(); });
}

[[nodiscard]] inline TextColumn milliseconds_on_device() { return {"gpu ms/frame", 14, {"{number}", kNotMeasured}}; }

/// One frame of a crowd that fills the picture.
struct RenderingCostRow {
  std::uint32_t heads = 0;
  std::string transparency;   ///< The name on the command line: "blend": four passes; "opaque": one.
  std::uint32_t samples = 1;  ///< Per pixel.
  std::uint32_t lod = 0;
  bool simulation = false;  ///< The crowd is also simulated, on the same thread, before it is drawn.
  /// With glow, dark roots and strands of different lightness, whatever the asset has.
  bool strand_terms = false;
  std::uint64_t triangles = 0;  ///< All heads together; each is drawn once per pass.
  double ms_per_frame = 0;      ///< Wall time until the device has finished.
  double spread_pct = 0;
  std::optional<double> gpu_ms_per_frame{};  ///< The device's own report; none where it gives none.
};

/// `device`: RenderingCost::device.
[[nodiscard]] inline Columns<RenderingCostRow> rendering_columns(const std::string& device,
                                                                 const std::vector<RenderingCostRow>& rows) {
  using Row = RenderingCostRow;
  const bool is_told = has_device_times(rows, &Row::gpu_ms_per_frame);
  return {{"heads", &Row::heads, {"heads", {}, -2}, {"heads", 6}},
          {"transparency", &Row::transparency, {"transparency"}, {"drawn", -12, {}, -1}},
          {"samples", &Row::samples, {"samples"}, {"samples", 9}},
          {"lod", &Row::lod, {"level of detail", {}, -1}, {"lod", 5}},
          {"simulation", &Row::simulation, {"simulated"}, {"simulated", 11}},
          {"strand_terms", &Row::strand_terms, {"strand terms"}, {"terms", 7}},
          {"triangles", &Row::triangles, {"triangles"}, {"triangles", 11}},
          {"ms_per_frame", &Row::ms_per_frame, {"time a frame", ms_format()}, {"ms/frame", 10}},
          {"spread_pct", &Row::spread_pct, {"spread", half_spread()}, {"spread", 9, "{percent}"}},
          {"gpu_ms_per_frame", &Row::gpu_ms_per_frame, on_the_device(is_told), milliseconds_on_device()},
          {"device", [device](const Row&) { return device; }},
          {"ms_per_head", [](const Row& row) { return row.ms_per_frame / row.heads; }, {"a head", ms_format()}}};
}

/// A crowd near and far, each head with the level of detail that choose_lod() gives it.
struct DistanceCostRow {
  std::uint32_t heads = 0;
  double times_as_far = 1;  ///< Multiple of the distance at which the crowd fills the picture.
  double screen_share = 0;  ///< A head's share of the picture's height.
  std::uint32_t lod = 0;
  std::uint64_t triangles_per_head = 0;
  double covered_pixels_per_head = 0;  ///< Pixels that hair touches / heads.
  double ms_per_head = 0;              ///< Wall time of a frame / heads.
  double spread_pct = 0;
  double finest_ms_per_head = 0;  ///< The same crowd with level 0.
  std::optional<double> gpu_ms_per_head{};
};

/// Time that the level of detail saves relative to the finest one, %.
[[nodiscard]] inline double saved_pct(const DistanceCostRow& row) {
  return 100 * (1 - row.ms_per_head / row.finest_ms_per_head);
}

[[nodiscard]] inline Columns<DistanceCostRow> cost_distance_columns(const std::vector<DistanceCostRow>& rows) {
  using Row = DistanceCostRow;
  const bool is_told = has_device_times(rows, &Row::gpu_ms_per_head);
  return {{"heads", &Row::heads, {"heads", {}, -3}, {"heads", 6, {}, -2}},
          {"times_as_far", &Row::times_as_far},
          {"screen_share",
           &Row::screen_share,
           {"head's share of the height", {"{percent}", "-", 100}, -2},
           {"head/height", -12, {"{percent}", "-", 100}, -3}},
          {"lod", &Row::lod, {"level of detail"}, {"lod", 5}},
          {"triangles_per_head", &Row::triangles_per_head, {"triangles a head"}, {"triangles/head", 16}},
          {"covered_pixels_per_head",
           &Row::covered_pixels_per_head,
           {"pixels a head", {}, -1},
           {"pixels/head", 14, {}, -1}},
          {"ms_per_head", &Row::ms_per_head, {"time a head", ms_format()}, {"ms/head", 9}},
          {"spread_pct", &Row::spread_pct, {"spread", half_spread()}},
          {"gpu_ms_per_head", &Row::gpu_ms_per_head, on_the_device(is_told)},
          {"finest_ms_per_head", &Row::finest_ms_per_head, {"with the finest level", ms_format()}, {"finest", 12}},
          {"saved_pct", saved_pct, {"saved", "{:.0f} %"}},
          {kNoKey,
           [](const Row& row) { return row.lod == 0 ? kNoNumber : saved_pct(row); },
           {},
           {"saved", 9, {"{:.0f} %", "0 %"}}}};
}

// Table 1 of the thesis (6. Results): the cost of simulating and drawing a crowd, each with and without.

inline constexpr std::uint32_t kThesisTableWidth = 1024, kThesisTableHeight = 768;  ///< Pixels.
inline constexpr const char* kThesisTableDevice = "NVIDIA GeForce GTX 470, 2011";

/// One row of the published table. Simulation made no difference there.
struct PublishedFrameRate {
  std::uint32_t heads = 0;
  double transparent_fps = 0;  ///< Frames per second, integers, of a game with everything that it draws besides hair.
  double opaque_fps = 0;
};
inline constexpr std::array<PublishedFrameRate, 4> kPublishedFrameRates{
    {{20, 53, 58}, {50, 27, 30}, {100, 14, 16}, {200, 7, 8}}};

/// One cell, measured here. Heads have the same size in every row: the whole largest crowd fits into the picture.
struct ThesisTableRow {
  std::uint32_t heads = 0;
  bool transparency = true;                  ///< The four passes; without, one that cuts off.
  bool simulation = true;                    ///< The crowd is stepped before it is drawn, on the same thread.
  double ms_per_frame = 0;                   ///< Wall time until the device has finished; median.
  double spread_pct = 0;                     ///< Width of the middle half of the frames, % of the median.
  double step_ms = 0;                        ///< The time of stepping in these frames; median.
  std::optional<double> gpu_ms_per_frame{};  ///< The device's own report.
};

[[nodiscard]] inline Columns<PublishedFrameRate> published_columns() {
  using Row = PublishedFrameRate;
  return {{"heads", &Row::heads}, {"transparent_fps", &Row::transparent_fps}, {"opaque_fps", &Row::opaque_fps}};
}

[[nodiscard]] double frames_per_second(const ThesisTableRow& row);
/// The thesis's value for this row; none for crowds that it did not measure.
[[nodiscard]] std::optional<double> published_frames_per_second(const ThesisTableRow& row);

[[nodiscard]] inline Columns<ThesisTableRow> thesis_columns(const std::string& device,
                                                            const std::vector<ThesisTableRow>& rows) {
  using Row = ThesisTableRow;
  const bool is_told = has_device_times(rows, &Row::gpu_ms_per_frame);
  return {{"heads", &Row::heads, {"heads"}, {"heads", 6}},
          {"transparency", [](const Row& row) { return row.transparency ? "blend" : "opaque"; }, {"transparency"}},
          {"simulation", &Row::simulation, {"simulated"}, {"simulated", 11}},
          {kNoKey, &Row::transparency, {}, {"transparency", 14}},
          {"ms_per_frame", &Row::ms_per_frame, {"time a frame", ms_format()}, {"ms/frame", 10}},
          {"spread_pct", &Row::spread_pct, {"spread", half_spread()}, {"spread", 9, "{percent}"}},
          {"step_ms", &Row::step_ms, {"of it stepping", ms_format()}, {"stepping ms", 13}},
          {"gpu_ms_per_frame", &Row::gpu_ms_per_frame, on_the_device(is_told), milliseconds_on_device()},
          {"fps", frames_per_second, {"frames a second"}, {"fps", 8}},
          {"thesis_fps", published_frames_per_second, {"thesis: frames a second"}, {"thesis fps", 12, {"{:.0f}", "-"}}},
          {"device", [device](const Row&) { return device; }}};
}

/// How much longer a frame takes with something than without.
struct ThesisTableRatio {
  std::uint32_t heads = 0;
  double transparency_on_off = 1;  ///< Time of both ways with / time of both without.
  /// Time of both simulated ways divided by the time of the same frames without stepping. (Two drawings of the same
  /// thing differ by more than most crowds take to step.)
  double simulation_on_off = 1;
  std::optional<double> published_transparency{};  ///< From integer frames per second, so some percent off.
  std::optional<double> published_simulation{};
};

[[nodiscard]] inline Columns<ThesisTableRatio> ratio_columns() {
  using Ratio = ThesisTableRatio;
  const Format times = "{:.2f}", finely = "{:.3f}";
  return {{"heads", &Ratio::heads, {"heads"}},
          {"transparency_on_off", &Ratio::transparency_on_off, {"transparency on / off", times}},
          {"thesis_transparency_on_off", &Ratio::published_transparency, {"thesis", times}},
          {"simulation_on_off", &Ratio::simulation_on_off, {"simulation on / off", finely}},
          {"thesis_simulation_on_off", &Ratio::published_simulation, {"thesis", times}}};
}

struct ThesisTable {
  std::uint32_t width = 0, height = 0;  ///< Pixels.
  std::vector<ThesisTableRow> rows;     ///< Empty where it was not requested.
};

/// One for each crowd for which all four ways were measured, in order of their first rows.
[[nodiscard]] std::vector<ThesisTableRatio> ratios_of(const ThesisTable& table);

struct RenderingCost {
  std::string device;                   ///< OpenGL's name of itself; empty where nothing was drawn.
  std::uint32_t width = 0, height = 0;  ///< Pixels, except for the thesis's table.
  std::vector<RenderingCostRow> rows;
  std::vector<DistanceCostRow> distances;
  ThesisTable thesis_table;
  std::string note;  ///< Why there are no rows; empty where there are.
};

}  // namespace coif::report
