#include "base/text.h"
#include "cli/asset_summary.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"

#include <fmt/format.h>

#include <memory>

namespace coif::cli {
namespace {

struct InfoOptions {
  std::string file;
  OutputFormat format = OutputFormat::kText;
};

tl::expected<Exit, ToolError> run_info(const InfoOptions& options) {
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  print_result(options.format == OutputFormat::kJson ? asset_json(file->asset())
                                                     : asset_text(options.file, file->asset()));
  return Exit::kOk;
}

}  // namespace

Command add_info(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "Print what an asset holds and what each part costs");
  const auto options = std::make_shared<InfoOptions>();
  app->add_option("FILE", options->file, "A cooked asset")->required();
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_info(*options); }};
}

namespace {

using nlohmann::ordered_json;

double percent(float share) { return 100 * double(share); }

/// The motions behind the numbers of assets without MOTN (formats/SPECIFICATION.md).
constexpr const char* kMotionsBeforeNames[] = {"still", "nod",    "turn",     "charge", "run",
                                               "jump",  "tumble", "teleport", "bow",    "lie"};

/// open() has refused a number that none of the asset's names belongs to.
std::string worst_motion(const Asset& asset, const QualityRecord& row) {
  const std::uint32_t number = row.worst_motion;
  if (!asset.motion_names().empty()) return printable_text(asset.motion_names()[number].name);
  return number < std::size(kMotionsBeforeNames) ? kMotionsBeforeNames[number] : fmt::format("motion {}", number);
}

std::string tuning_lines(const TuningRecord& tuning) {
  const std::string error_asked =
      tuning.asked_error > 0 ? fmt::format(" (asked: {:.3g} %)", percent(tuning.asked_error)) : "";
  const std::string cost_asked = tuning.asked_cost > 0 ? fmt::format(" (asked: {:.0f} ns)", tuning.asked_cost) : "";
  std::string text = fmt::format("tuning ({})\n", tuning.met != 0 ? "met" : "not met");
  text +=
      fmt::format("  {:<16}{:>12.4g} .. {:.4g} frames per second\n", "for", tuning.slowest_rate, tuning.fastest_rate);
  text += fmt::format("  {:<16}{:>12.4g} Hz\n", "sub-steps", tuning.substep_rate);
  text += fmt::format("  {:<16}{:>12.3g} % of the chain's length, RMS{}\n", "error", percent(tuning.reached_error),
                      error_asked);
  text += fmt::format("  {:<16}{:>12.0f} ns per head and frame, nominal{}\n", "cost", tuning.cost, cost_asked);
  return text;
}

std::string quality_line(const Asset& asset, const QualityRecord& row) {
  return fmt::format("  {:>6g} {:>6} {:>10.3g} {:>10.3g} {:>10.2g} {:>10.2g} {:>10.0f}  {}\n", row.frame_rate,
                     row.substeps, percent(row.rms_error), percent(row.max_error), percent(row.stretch),
                     percent(row.penetration), row.cost, worst_motion(asset, row));
}

}  // namespace

ordered_json tuning_json(const Asset& asset) {
  if (asset.tuning() == nullptr) return nullptr;
  const TuningRecord& tuning = *asset.tuning();
  return {{"substep_rate", tuning.substep_rate},
          {"asked_error_pct", percent(tuning.asked_error)},
          {"reached_error_pct", percent(tuning.reached_error)},
          {"asked_ns", tuning.asked_cost},
          {"nominal_ns", tuning.cost},
          {"slowest_rate", tuning.slowest_rate},
          {"fastest_rate", tuning.fastest_rate},
          {"met", tuning.met != 0}};
}

ordered_json quality_json(const Asset& asset) {
  ordered_json rows = ordered_json::array();
  for (const QualityRecord& row : asset.quality()) {
    rows.push_back({{"frame_rate", row.frame_rate},
                    {"substeps", row.substeps},
                    {"rms_error_pct", percent(row.rms_error)},
                    {"max_error_pct", percent(row.max_error)},
                    {"stretch_pct", percent(row.stretch)},
                    {"penetration_pct", percent(row.penetration)},
                    {"nominal_ns", row.cost},
                    {"worst_motion", worst_motion(asset, row)}});
  }
  return rows;
}

std::string tuning_text(const Asset& asset) {
  std::string text;
  if (asset.tuning() != nullptr) text += tuning_lines(*asset.tuning());
  if (asset.quality().empty()) return text;
  text += "quality (tips against the converged motion, % of the chain's length; depth in % of the collider's radius)\n";
  text += fmt::format("  {:>6} {:>6} {:>10} {:>10} {:>10} {:>10} {:>10}  {}\n", "fps", "parts", "RMS %", "max %",
                      "stretch %", "depth %", "ns", "worst motion");
  for (const QualityRecord& row : asset.quality()) text += quality_line(asset, row);
  return text;
}

}  // namespace coif::cli
