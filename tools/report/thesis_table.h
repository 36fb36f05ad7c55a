#pragma once
// Table 1 of the thesis (6. Results): what a crowd costs to simulate and draw, each with and without.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif {

inline constexpr std::uint32_t kThesisTableWidth = 1024, kThesisTableHeight = 768;  ///< Pixels.
inline constexpr const char* kThesisTableDevice = "NVIDIA GeForce GTX 470, 2011";

/// One row of the table as published. Simulation made no difference there.
struct PublishedFrameRate {
  std::uint32_t heads = 0;
  double transparent_fps = 0;  ///< Frames per second, whole ones, of a game with all that it draws beside hair.
  double opaque_fps = 0;
};
inline constexpr std::array<PublishedFrameRate, 4> kPublishedFrameRates{
    {{20, 53, 58}, {50, 27, 30}, {100, 14, 16}, {200, 7, 8}}};

/// One cell, measured here. Heads are as large in every row: all of the largest crowd fit into the picture.
struct ThesisTableRow {
  std::uint32_t heads = 0;
  bool transparency = true;                  ///< The four passes; without, one that cuts off.
  bool simulation = true;                    ///< The crowd is stepped before it is drawn, on the same thread.
  double ms_per_frame = 0;                   ///< Wall time until the device has finished; median.
  double spread_pct = 0;                     ///< Width of the middle half of the frames, % of the median.
  std::optional<double> gpu_ms_per_frame{};  ///< What the device says that it took itself.
};

[[nodiscard]] double frames_per_second(const ThesisTableRow& row);
/// What the thesis has in this row's place; nothing for crowds that it did not measure.
[[nodiscard]] std::optional<double> published_frames_per_second(const ThesisTableRow& row);

/// How much longer a frame takes with something than without.
struct ThesisTableRatio {
  std::uint32_t heads = 0;
  double transparency_on_off = 1;  ///< Time of both ways with / time of both without.
  double simulation_on_off = 1;
  std::optional<double> published_transparency{};  ///< From whole frames per second, so some percent off.
  std::optional<double> published_simulation{};
};

struct ThesisTable {
  std::uint32_t width = 0, height = 0;  ///< Pixels.
  std::vector<ThesisTableRow> rows;     ///< Empty where it was not asked for.
};

/// One for each crowd of which all four ways are there, in order of their first rows.
[[nodiscard]] std::vector<ThesisTableRatio> ratios_of(const ThesisTable& table);

}  // namespace coif
