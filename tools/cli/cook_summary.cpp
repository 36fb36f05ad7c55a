#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/cook_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace coif::cli {
namespace {

double total_ms(const cook::CookReport& report) {
  double sum = 0;
  for (const cook::PassTime& pass : report.passes) sum += pass.ms;
  return sum;
}

std::string next_step(const CookSummary& summary) {
  const cook::CookReport& report = summary.report;
  if (report.simulated_bones == 0) {
    return "nothing will move; where hair should, name its bones in a recipe ('coif cook SOURCE --list' prints them) "
           "or make \"chains.shortest\" less ('coif cook --print-recipe')";
  }
  if (report.triangles == 0) return fmt::format("coif simulate {} --motion turn -o turn.csv", summary.output);
  return fmt::format("coif render {} -o picture.png", summary.output);
}

/// Decibels are expected values.
nlohmann::ordered_json draw_order_json(const cook::OrderFigures& order) {
  return {{"orders", order.orders},       {"psnr_db", order.psnr},          {"median_psnr_db", order.median},
          {"worst_psnr_db", order.worst}, {"moving_psnr_db", order.moving}, {"crossings", order.crossings},
          {"cuts", order.cuts},           {"triangles_added", order.added}, {"cut_gain_db", order.cut_gain}};
}

nlohmann::ordered_json left_out_json(const cook::CookReport& report) {
  auto list = nlohmann::ordered_json::array();
  for (const cook::LeftOut& left_out : report.left_out) {
    list.push_back({{"what", left_out.what},
                    {"why", left_out.why},
                    {"bytes", left_out.bytes},
                    {"bytes_per_head", left_out.bytes_per_head},
                    {"ns_per_frame", left_out.ns_per_frame}});
  }
  return list;
}

/// All findings, the time of each pass, and the files that were read.
std::string details(const CookSummary& summary) {
  const cook::CookReport& report = summary.report;
  std::string text;
  for (const std::string& note : report.notes) text += fmt::format("  {}\n", note);
  for (const cook::LeftOut& left_out : report.left_out) text += fmt::format("  left out: {}\n", left_out.text());
  for (const cook::PassTime& pass : report.passes) text += fmt::format("  {:>9.1f} ms  {}\n", pass.ms, pass.name);
  for (const std::filesystem::path& file : summary.files) {
    std::error_code error;
    text +=
        fmt::format("  {}: {}\n", std::filesystem::exists(file, error) ? "read" : "looked for in vain", file.string());
  }
  return text;
}

std::string told_with_v(const cook::CookReport& report) {
  if (report.notes.empty() && report.left_out.empty()) return {};
  return fmt::format("  {}, {} left out: -v tells them\n", counted(report.notes.size(), "note", "notes"),
                     counted(report.left_out.size(), "thing", "things"));
}

}  // namespace

nlohmann::ordered_json cook_json(const CookSummary& summary) {
  const cook::CookReport& report = summary.report;
  auto passes = nlohmann::ordered_json::array();
  for (const cook::PassTime& pass : report.passes) passes.push_back({{"name", pass.name}, {"ms", pass.ms}});
  return {{"output", summary.output},
          {"bytes", summary.bytes},
          {"draft", summary.draft},
          {"from_cache", summary.from_cache},
          {"passes", std::move(passes)},
          {"warnings", messages_of(report.warnings)},
          {"issues", validate::issues_json(report.warnings)},
          {"triangles", report.triangles},
          {"vertices", report.vertices},
          {"patches", report.patches},
          {"patches_by_index", report.patches_by_index},
          {"patches_by_position", report.patches_by_position},
          {"chains", report.chains},
          {"bones", report.bones},
          {"simulated_bones", report.simulated_bones},
          {"draw_order", draw_order_json(report.order)},
          {"notes", report.notes},
          {"decisions", report.decisions},
          {"left_out", left_out_json(report)}};
}

namespace {

/// Errors and warnings as `coif validate` would count them.
nlohmann::ordered_json issues_json(const CookOptions& options, const FailedCook& failed) {
  validate::IssuePolicy policy{.lowest = Severity::kWarning, .warnings_as_errors = options.warnings_as_errors};
  policy.most_of_a_code = std::max<std::size_t>(1, failed.issues.size());
  return validate::issues_json(validate::judge(failed.issues, policy).shown);
}

}  // namespace

nlohmann::ordered_json failed_cook_json(const CookOptions& options, const FailedCook& failed) {
  const Exit code = exit_code(failed.kind);
  return {{"source", options.sources.empty() ? "" : options.source()},
          {"output", options.output},
          {"status", status_word(code)},
          {"exit_code", int(code)},
          {"error", failed.message},
          {"issues", issues_json(options, failed)}};
}

namespace {

/// Whether the file is a JSON object with the members of a report: "output", and the passes or the error.
bool is_report(const std::filesystem::path& file) {
  const auto bytes = FileBytes::read(file);
  if (!bytes) return false;
  const auto document = parse_shallow_json({reinterpret_cast<const char*>(bytes->span().data()), bytes->span().size()});
  return document && document->is_object() && document->contains("output") &&
         (document->contains("passes") || document->contains("error"));
}

}  // namespace

void report_failed_cook(const CookOptions& options, const FailedCook& failed, const Messages& messages) {
  const bool is_for_one = options.sources.size() == 1 && options.manifest.empty();
  if (options.report.empty() || !is_for_one || failed.kind == ToolError::Kind::kUsage) return;
  std::error_code ignored;
  if (std::filesystem::exists(options.report, ignored) && std::filesystem::is_regular_file(options.report, ignored) &&
      !is_report(options.report)) {
    return messages.warning(options.report + ": is no report of an earlier cook, and was left as it is");
  }
  const std::string report = json_text(failed_cook_json(options, failed));
  if (auto written = write_output(options.report, std::as_bytes(std::span(report))); !written)
    messages.warning(written.error().message);
}

std::string cook_text(const CookSummary& summary, bool in_full) {
  const cook::CookReport& report = summary.report;
  std::string text =
      fmt::format("{}: {} in {} ({} by index, {} by position)\n", summary.output,
                  counted(report.triangles, "triangle", "triangles"), counted(report.patches, "patch", "patches"),
                  report.patches_by_index, report.patches_by_position);
  text += fmt::format("  {} of {}, {} of them simulated\n", counted(report.chains, "chain", "chains"),
                      counted(report.bones, "bone", "bones"), report.simulated_bones);
  text += fmt::format("  {} bytes {} {:.0f} ms, {}\n", summary.bytes,
                      summary.from_cache ? "from the cache, once cooked in" : "in", total_ms(report),
                      counted(report.warnings.size(), "warning", "warnings"));
  if (summary.draft) text += "  a draft, to look at: cook without --draft before it goes into a game\n";
  text += in_full ? details(summary) : told_with_v(report);
  return text + fmt::format("  next: {}\n", next_step(summary));
}

}  // namespace coif::cli
