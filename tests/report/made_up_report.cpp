#include "report/made_up_report.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::report {

Keys keys_of(const nlohmann::ordered_json& object) {
  Keys keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

namespace {

struct MadeUpSolver {
  const char* name;
  double error_pct, ns, stretch_pct;
};

constexpr MadeUpSolver kSolvers[] = {{"coif", 1, 30, 0}, {"thesis", 30, 25, 60}, {"slow", 2, 300, 0.2}};
constexpr const char* kMotions[] = {"nod", "turn"};

AccuracyRow made_up_row(const char* motion, const MadeUpSolver& solver, double fps, std::uint32_t substeps) {
  AccuracyRow row;
  row.motion = motion;
  row.solver = solver.name;
  row.fps = fps;
  row.substeps = substeps;
  row.ns_per_bone_frame = solver.ns * substeps;
  row.rms_error_pct = solver.error_pct / substeps * 60 / fps;
  row.max_error_pct = 4 * row.rms_error_pct;
  row.stretch_max_pct = solver.stretch_pct * 60 / fps;
  row.penetration_max_pct = 0.5;
  row.segment_penetration_max_pct = 0.75;
  return row;
}

}  // namespace

ReportHeading made_up_heading() {
  ReportHeading heading;
  heading.asset = "bob <b>.coif";
  heading.bones = 12;
  heading.simulated_bones = 10;
  heading.chains = 2;
  heading.shortest_chain = 0.125;
  heading.median_chain = 0.25;
  heading.longest_chain = 0.5;
  heading.machine = "processor, 2 cores";
  heading.seconds_taken = 3.25;
  return heading;
}

AccuracyReport made_up_accuracy() {
  AccuracyReport report;
  for (const char* motion : kMotions) {
    for (const MadeUpSolver& solver : kSolvers) {
      for (const double fps : {30.0, 60.0, 120.0}) {
        for (const std::uint32_t substeps : {1u, 4u}) {
          report.rows.push_back(made_up_row(motion, solver, fps, substeps));
        }
      }
      report.spread.push_back({motion, solver.name, 1, 2 * solver.error_pct});
    }
    report.reference.push_back({motion, 0.25, 48000});
  }
  for (const MadeUpSolver& solver : kSolvers) report.settle.push_back({solver.name, solver.error_pct / 10});
  report.chosen = ChosenSolver{"coif", 1, 1, 30};
  report.budget_rms_pct = 2;
  return report;
}

StabilityReport made_up_stability() {
  StabilityReport report;
  report.stress_cases = {{"turn_10fps", "head shaken at 10 frames per second"}, {"nan_pose", "a pose of NaN"}};
  report.rows = {
      {"turn_10fps", "coif", Outcome::kOk, 0, 0, 0, 9, 12, 0.01, 0.5},
      {"turn_10fps", "thesis", Outcome::kOk, 132, 7, 0.9, kNoNumber, 40, 0.5, 3},
      {"turn_10fps", "slow", Outcome::kDiverged, 4.0e9, 100, 3, kNoNumber, 1.0e12, kNoNumber, kNoNumber},
      {"nan_pose", "coif", Outcome::kOk, 0.25, 0, 1e-6, 10, 1, 0.02, 0.75},
      {"nan_pose", "thesis", Outcome::kRejected, kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber,
       kNoNumber},
      {"nan_pose", "slow", Outcome::kNan, kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber}};
  return report;
}

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
                              .spread_pct = 2,
                              .step_ms = simulation ? heads * (transparency ? 3 : 2) * 0.5 : 0});
      }
    }
  }
  return table;
}

namespace {

OrderError error_of(double db) {
  OrderError error;
  error.psnr_db = db;
  error.median_psnr_db = db + 1;
  error.worst_psnr_db = db - 5;
  error.rmse = std::pow(10, -db / 20);
  error.bad_pixels_pct = 100 * error.rmse;
  error.view_psnr_db = {db - 5, db, db + 2, db + 3};
  return error;
}

}  // namespace

OrderReport made_up_order() {
  OrderReport report;
  report.device = "made-up device";
  report.solver = "coif";
  report.width = report.height = 64;
  report.opaque_threshold = 0.8;
  report.orders = 3;
  report.directions = {{0, 0}, {90, 0}, {180, 0}, {270, 10}};
  report.orbit_frames = 30;
  for (const char* pose : {"rest", "turn"}) {
    report.rows.push_back({"head", pose, false, error_of(20), 0.02, 1, std::nullopt, 1000});
    report.rows.push_back({"view", pose, true, error_of(40), 0.01, 1.5, 7, 3000});
    report.rows.push_back({"triangles", pose, true, error_of(44), std::nullopt, 2, 90000, 1000});
    report.gains.push_back({pose, 20});
  }
  report.modes = {{"blend", 1, "rest", error_of(40), 0.01, 1.5}, {"opaque", 1, "rest", error_of(18), 0.05, 0.5}};
  report.thresholds = {{0.8, true, error_of(40)}, {0.9, false, error_of(41)}};
  report.distance = {{512, 99.5, 0, 99.5}, {256, 98, 0, 98}, {16, 62, 2, 50}};
  report.reference = {{"again", kEqualDb, 0}};
  report.left_out = {{"bones", "this program <cannot>"}};
  report.worst = {{"head", "rest", 90, 0, 15, {1, 2, 3}}};
  return report;
}

}  // namespace coif::report
