#pragma once

// Table 1 of the thesis (6. Results): what a crowd costs to simulate and draw, each with and without.

#include <coif/chunks.h>

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

// What `coif report cost` found, as data: measured by measure_cost(), and for the pictures by measure_drawing(); shown by
// the renderers of report/page. Times are medians; the spread beside each is the width of the middle half of its
// samples, in % of the median.

/// A crowd of heads that all move, one frame of 1/60 s: poses handed over, hair stepped, bone matrices made.
struct SimulationCostRow {
  std::uint32_t heads = 0;
  std::string solver;
  std::uint32_t substeps = 1;    ///< Of the frame; iterations of `thesis`.
  double us_per_frame = 0;       ///< Microseconds of one core, all heads.
  double ns_per_bone_frame = 0;  ///< Per simulated bone of each head.
  double spread_pct = 0;
  std::uint64_t bytes = 0;    ///< What the runtime asks the game for, asset not included.
  double bytes_per_head = 0;  ///< bytes / heads.
};

/// The same crowd with one thing changed.
struct FeatureCostRow {
  std::string feature;      ///< Short, unique: "no-colliders". The first is "as-cooked".
  std::string description;  ///< One line for people.
  std::uint32_t heads = 0;
  double us_per_frame = 0;
  double ns_per_bone_frame = 0;
  double spread_pct = 0;
  double change_pct = 0;  ///< Of the time, against "as-cooked".
};

inline constexpr const char* kDrawnCrowd = "drawing";
inline constexpr const char* kDistances = "distance";
inline constexpr const char* kThesisTable = "Table 1";

/// A crowd that was not measured.
struct CostLeftOut {
  std::uint32_t heads = 0;
  std::string what;  ///< A solver, kDrawnCrowd, kDistances or kThesisTable.
  std::string why;
};

/// Memory of a crowd of n heads, where n is large: bytes_shared + n * bytes_per_head.
struct CrowdMemory {
  double bytes_per_head = 0;
  double bytes_shared = 0;
};

/// "simulation", "drawing", "tools".
[[nodiscard]] constexpr const char* name_of(ChunkUse use) {
  switch (use) {
    case ChunkUse::kSimulation: return "simulation";
    case ChunkUse::kDrawing:
    case ChunkUse::kDrawData: return "drawing";
    case ChunkUse::kTools: return "tools";
  }
  return "";
}

struct ChunkBytes {
  std::string id;    ///< As in the file: "BONE".
  std::string what;  ///< In words; empty for what this version does not know.
  std::uint64_t bytes = 0;
  ChunkUse use = ChunkUse::kTools;
};

struct AssetBytes {
  std::uint64_t total = 0;  ///< Of the file: the chunks and `framing`.
  std::vector<ChunkBytes> chunks;
  std::uint64_t framing = 0;  ///< Header, table of chunks, padding between them.
};

/// One frame of a crowd that fills the picture.
struct RenderingCostRow {
  std::uint32_t heads = 0;
  std::string transparency;   ///< As the command line calls it: "blend": four passes; "opaque": one.
  std::uint32_t samples = 1;  ///< Of a pixel.
  std::uint32_t lod = 0;
  bool simulation = false;      ///< The crowd is also simulated, on the same thread, before it is drawn.
  std::uint64_t triangles = 0;  ///< Of all heads; each is drawn once a pass.
  double ms_per_frame = 0;      ///< Wall time until the device has finished.
  double spread_pct = 0;
  std::optional<double> gpu_ms_per_frame{};  ///< What the device says that it took itself; nothing where it does not.
};

/// A crowd near and far, each head with the level of detail that choose_lod() gives it.
struct DistanceCostRow {
  std::uint32_t heads = 0;
  double times_as_far = 1;  ///< As where the crowd fills the picture.
  double screen_share = 0;  ///< Of the picture's height, that of a head.
  std::uint32_t lod = 0;
  std::uint64_t triangles_per_head = 0;
  double covered_pixels_per_head = 0;  ///< Pixels that hair touches / heads.
  double ms_per_head = 0;              ///< Wall time of a frame / heads.
  double spread_pct = 0;
  double finest_ms_per_head = 0;  ///< The same crowd with level 0.
  std::optional<double> gpu_ms_per_head{};
};

struct RenderingCost {
  std::string device;                   ///< What OpenGL calls itself; empty where nothing was drawn.
  std::uint32_t width = 0, height = 0;  ///< Pixels, but for the thesis's table.
  std::vector<RenderingCostRow> rows;
  std::vector<DistanceCostRow> distances;
  ThesisTable thesis_table;
  std::string note;  ///< Why there are no rows; empty where there are.
};

struct CostReport {
  std::string instruction_set;  ///< What the processor was found to have; empty where nothing was simulated.
  std::vector<SimulationCostRow> simulation;
  std::vector<FeatureCostRow> features;
  std::vector<CostLeftOut> left_out;
  CrowdMemory memory;
  AssetBytes asset;
  RenderingCost rendering;
};

}  // namespace coif
