#include "report/page/made_up_cost.h"

namespace coif {
namespace {

constexpr std::uint32_t kBones = 10;

SimulationCostRow made_up_row(const char* solver, std::uint32_t heads, std::uint32_t substeps, double us) {
  SimulationCostRow row{.heads = heads, .solver = solver, .substeps = substeps};
  row.us_per_frame = us * heads * substeps;
  row.ns_per_bone_frame = 1e3 * us * substeps / kBones;
  row.spread_pct = 4;
  row.bytes = 1000 + 500 * heads;
  row.bytes_per_head = double(row.bytes) / heads;
  return row;
}

void add_solver(const char* solver, double us, CostReport& report) {
  for (const std::uint32_t heads : {1u, 10u, 100u}) report.simulation.push_back(made_up_row(solver, heads, 1, us));
  for (const std::uint32_t substeps : {2u, 4u}) report.simulation.push_back(made_up_row(solver, 10, substeps, us));
}

RenderingCostRow drawn_row(std::uint32_t heads, const char* transparency, bool simulation) {
  return {.heads = heads,
          .transparency = transparency,
          .simulation = simulation,
          .triangles = 300ull * heads,
          .ms_per_frame = 0.5 * heads,
          .spread_pct = 40};
}

RenderingCost made_up_rendering() {
  RenderingCost rendering;
  rendering.device = "made-up device";
  rendering.width = 64;
  rendering.height = 48;
  for (const std::uint32_t heads : {1u, 10u}) {
    for (const char* transparency : {"blend", "opaque"}) {
      for (const bool simulation : {false, true}) {
        rendering.rows.push_back(drawn_row(heads, transparency, simulation));
      }
    }
  }
  rendering.rows.push_back({.heads = 1,
                            .transparency = "blend",
                            .samples = 4,
                            .lod = 1,
                            .triangles = 100,
                            .ms_per_frame = 0.25,
                            .spread_pct = 2,
                            .gpu_ms_per_frame = 0.125});
  rendering.distances = {{1, 1, 0.8, 0, 300, 500, 4, 2, 4}, {10, 2, 0.2, 1, 100, 40, 1, 2, 4}};
  return rendering;
}

}  // namespace

CostReport made_up_cost() {
  CostReport report;
  report.instruction_set = "AVX9";
  add_solver("coif", 2, report);
  add_solver("thesis", 1, report);
  report.features = {{"as-cooked", "all heads run", 10, 20, 200, 3, 0},
                     {"no-colliders", "the hair touches nothing", 10, 15, 150, 60, -25}};
  report.left_out = {{100, kDrawnCrowd, "one frame takes too long"}, {1000, kDrawnCrowd, "fewer are too slow already"}};
  report.memory = {500, 1000};
  report.asset = {
      1000, {{"BONE", "bones", 480, ChunkUse::kSimulation}, {"TEXD", "texels", 400, ChunkUse::kDrawing}}, 120};
  report.rendering = made_up_rendering();
  return report;
}

ThesisTable made_up_thesis_table() {
  ThesisTable table{.width = 64, .height = 48, .rows = {}};
  for (const std::uint32_t heads : {20u, 7u}) {
    for (const bool simulation : {true, false}) {
      for (const bool transparency : {true, false}) {
        table.rows.push_back({.heads = heads,
                              .transparency = transparency,
                              .simulation = simulation,
                              .ms_per_frame = heads * (transparency ? 3 : 2) * (simulation ? 1.5 : 1),
                              .spread_pct = 2});
      }
    }
  }
  return table;
}

}  // namespace coif
