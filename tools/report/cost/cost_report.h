#pragma once

// The results of `coif report cost`: records, measured by measure_cost(), and the columns that show them. Times are
// medians; the spread beside each is the width of the middle half of its samples, in % of the median.

#include "report/cost/drawing_cost.h"
#include "report/page/report_columns.h"

#include <coif/chunks.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace coif::report {

/// A crowd of heads that all move, one frame of 1/60 s: poses handed over, hair stepped, bone matrices made.
struct SimulationCostRow {
  std::uint32_t heads = 0;
  std::string solver;
  std::uint32_t substeps = 1;    ///< Per frame; iterations of `thesis`.
  double us_per_frame = 0;       ///< Microseconds of one core, all heads.
  double ns_per_bone_frame = 0;  ///< Per simulated bone of each head.
  double spread_pct = 0;
  std::uint64_t bytes = 0;    ///< The memory that the runtime asks the game for, without the asset.
  double bytes_per_head = 0;  ///< bytes / heads.
  bool usual_steps = false;   ///< Belongs to scaling_of().
  bool usual_heads = false;   ///< Belongs to substeps_of().
};

[[nodiscard]] inline Columns<SimulationCostRow> simulation_columns() {
  using Row = SimulationCostRow;
  const auto us_per_head = [](const Row& row) { return row.us_per_frame / row.heads; };
  const auto in_1_ms = [](const Row& row) { return std::floor(1e3 * row.heads / row.us_per_frame); };
  return {{"heads", &Row::heads, {"heads"}, {"heads", 8}},
          {"solver", &Row::solver, {"solver", {}, -1}, {"solver", -8, {}, -1}},
          {"substeps", &Row::substeps, {"steps", {}, -1}, {"steps", 6, {}, -1}},
          {"us_per_frame", &Row::us_per_frame, {"time a frame", us_format()}, {"us/frame", 14}},
          {"us_per_head", us_per_head, {"a head", us_format(), 1}, {"us/head", 12}},
          {"ns_per_bone_frame", &Row::ns_per_bone_frame, {"a bone", "{time}", 2}, {"ns/bone", 12}},
          {"spread_pct", &Row::spread_pct, {"spread", half_spread()}, {"spread", 9, "{percent}"}},
          {"bytes", &Row::bytes},
          {"bytes_per_head", &Row::bytes_per_head},
          {"heads_in_1_ms", in_1_ms, {"heads in 1 ms", "{:.0f}", 3}},
          {"usual_steps", &Row::usual_steps},
          {"usual_heads", &Row::usual_heads}};
}

[[nodiscard]] inline Columns<SimulationCostRow> memory_columns() {
  return {{"heads", &SimulationCostRow::heads, {"heads"}},
          {"bytes", &SimulationCostRow::bytes, {"memory of the crowd", "{bytes}"}},
          {"bytes_per_head", &SimulationCostRow::bytes_per_head, {"a head", "{bytes}"}}};
}

inline constexpr const char* kAsCooked = "as-cooked";

/// The same crowd with one change.
struct FeatureCostRow {
  std::string feature;      ///< Short, unique: "no-colliders". The first is kAsCooked.
  std::string description;  ///< One line for people.
  std::uint32_t heads = 0;
  double us_per_frame = 0;
  double ns_per_bone_frame = 0;
  double spread_pct = 0;
  double change_pct = 0;  ///< Change of the time relative to kAsCooked.
};

[[nodiscard]] inline Columns<FeatureCostRow> feature_columns() {
  using Row = FeatureCostRow;
  const auto us_per_head = [](const Row& row) { return row.us_per_frame / row.heads; };
  return {{"feature", &Row::feature, {"feature"}, {"", -22}},
          {"description", &Row::description, {"what is different", {}, 0, true}},
          {"heads", &Row::heads},
          {"us_per_frame", &Row::us_per_frame, {"time a frame", us_format()}, {"", 14}},
          {"us_per_head", us_per_head, {"a head", us_format(), 1}, {"", 12}},
          {"ns_per_bone_frame", &Row::ns_per_bone_frame},
          {"spread_pct", &Row::spread_pct, {"spread", half_spread()}, {"", 9, "{percent}", 1}},
          {"change_pct", &Row::change_pct, {"change", "{:+.0f} %", 2}, {"", 13, "{:+.0f} %"}}};
}

inline constexpr const char* kDrawnCrowd = "drawing";
inline constexpr const char* kDistances = "distance";
inline constexpr const char* kThesisTable = "Table 1";

/// A crowd that was not measured.
struct CostLeftOut {
  std::uint32_t heads = 0;
  std::string what;  ///< A solver, kDrawnCrowd, kDistances or kThesisTable.
  std::string why;
};

[[nodiscard]] inline Columns<CostLeftOut> cost_left_out_columns() {
  return {{"heads", &CostLeftOut::heads}, {"what", &CostLeftOut::what}, {"why", &CostLeftOut::why}};
}

/// Memory of a crowd of n heads, where n is large: bytes_shared + n * bytes_per_head.
struct CrowdMemory {
  double bytes_per_head = 0;
  double bytes_shared = 0;
};

[[nodiscard]] inline Columns<CrowdMemory> crowd_memory_columns() {
  return {{"bytes_per_head", &CrowdMemory::bytes_per_head}, {"bytes_shared", &CrowdMemory::bytes_shared}};
}

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
  std::string id;    ///< As in the file: "BONE"; empty for sums.
  std::string what;  ///< In words; empty for a chunk that this version does not know.
  std::uint64_t bytes = 0;
  ChunkUse use = ChunkUse::kTools;
};

/// `total`: bytes of the file.
[[nodiscard]] inline Columns<ChunkBytes> chunk_columns(std::uint64_t total) {
  using Row = ChunkBytes;
  const auto share = [total](const Row& row) { return 100 * double(row.bytes) / double(total); };
  return {{"id", &Row::id, {"part of the file"}},
          {"what", &Row::what, {"what"}},
          {"bytes", &Row::bytes, {"bytes"}},
          {"share_pct", share, {"share", "{:.2f} %"}},
          {"use", [](const Row& row) { return row.id.empty() ? "" : name_of(row.use); }, {"is for"}}};
}

struct AssetBytes {
  std::uint64_t total = 0;  ///< The file: the chunks and `framing`.
  std::vector<ChunkBytes> chunks;
  std::uint64_t framing = 0;  ///< Header, table of chunks, padding between them.
};

struct CostReport {
  std::string instruction_set;  ///< The one used on this processor; empty where nothing was simulated.
  std::vector<SimulationCostRow> simulation;
  std::vector<FeatureCostRow> features;
  std::vector<CostLeftOut> left_out;
  CrowdMemory memory;
  AssetBytes asset;
  RenderingCost rendering;
};

// Rows that belong together.

/// Crowds of one solver with the asset's sub-steps, taken from the smallest crowd.
[[nodiscard]] std::vector<SimulationCostRow> scaling_of(const CostReport& report, const std::string& solver);

/// One solver with several numbers of sub-steps, all with the crowd of the feature rows.
[[nodiscard]] std::vector<SimulationCostRow> substeps_of(const CostReport& report, const std::string& solver);

/// Crowds drawn one way with the finest level of detail and one sample a pixel.
[[nodiscard]] std::vector<RenderingCostRow> drawings_of(const CostReport& report, const std::string& transparency,
                                                        bool simulation);

/// `coif report cost`: the heading, then
/// - `instruction_set`: the one that the simulation used, "" without simulation
/// - `simulation`, `features`, `left_out`
/// - `memory`: for n heads, n large, bytes_shared + n * bytes_per_head
/// - `file{bytes, chunks, framing_bytes}`; the chunks and the framing add up to the file
/// - `rendering`, `distances`; `table_1`, `table_1_ratios`: empty unless requested
/// - `rendering_note`: why `rendering` is empty, or null
///
/// Their members have the keys of the columns above and in drawing_cost.h. For the page also `memory_of_crowds`,
/// `file_parts`, `table_1_published` and sentences under `notes`.
[[nodiscard]] nlohmann::ordered_json cost_json(const ReportHeading& heading, const CostReport& measured);

/// `coif report cost` for a terminal: the rows, what was left out and the summary.
[[nodiscard]] std::string cost_text(const ReportHeading& heading, const CostReport& report);

/// The layout of the page: cost_page.json.
extern "C" const char coif_cost_page[];

/// The cost of one head and of a crowd, in a few sentences.
[[nodiscard]] std::string cost_summary(const CostReport& report);

/// The crowds of `what`, as in CostLeftOut, that were not measured, with the reason for the first one; empty where all
/// were.
[[nodiscard]] std::string left_out_text(const CostReport& report, const std::string& what);

/// The source of the times on the device itself, or why there are none.
[[nodiscard]] std::string device_time_text(const RenderingCost& rendering);

}  // namespace coif::report
