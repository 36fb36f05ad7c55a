#include "base/files.h"
#include "base/json.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/report_options.h"
#include "report/accuracy/show_accuracy.h"
#include "report/cost/show_cost.h"
#include "report/order/show_order.h"
#include "report/page/plot.h"
#include "report/shadow/show_shadows.h"
#include "report/stability/show_stability.h"

#include <chrono>
#include <memory>

namespace coif {
namespace {

constexpr const char* kPageSuffix = ".html";

/// A report in the forms that somebody asked for.
struct Rendered {
  std::string printed;  ///< For the standard output.
  std::string file;     ///< For the output file; empty where there is none.
};

/// Shows what is measured while it is, and writes the time it took into the heading.
template <typename Measure>
auto timed(const std::string& file, ReportHeading& heading, Measure measure) {
  ProgressLine line(file);
  const auto begin = std::chrono::steady_clock::now();
  auto report = measure([&line](const std::string& step) { line.show(step.c_str()); });
  heading.seconds_taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

template <typename Page>
tl::expected<Rendered, ToolError> render(const ReportOptions& options, const std::string& suffix,
                                         const std::string& text, const nlohmann::ordered_json& json, Page page) {
  const std::string numbers = json_text(json);
  const bool as_json = options.format == OutputFormat::kJson;
  Rendered rendered{as_json ? numbers : text, ""};
  if (suffix.empty()) return rendered;
  if (!as_json) rendered.printed += options.output + ": written\n";
  tl::expected<std::string, ToolError> content = suffix == kPageSuffix ? page() : numbers;
  if (!content) return tl::unexpected(content.error());
  rendered.file = std::move(*content);
  return rendered;
}

tl::expected<Rendered, ToolError> report_accuracy(const ReportOptions& options, const AccuracySettings& settings,
                                                  const std::string& suffix, const Asset& asset) {
  ReportHeading heading = heading_of(asset, options.file);
  const auto report = timed(options.file, heading, [&](const ReportProgress& progress) {
    return measure_accuracy(asset, settings, progress);
  });
  if (!report) return tl::unexpected(report.error());
  return render(options, suffix, accuracy_text(heading, *report), accuracy_json(heading, *report),
                [&] { return accuracy_page(heading, *report); });
}

tl::expected<Rendered, ToolError> report_stability(const ReportOptions& options, const std::string& suffix,
                                                   const Asset& asset) {
  ReportHeading heading = heading_of(asset, options.file);
  const auto report = timed(options.file, heading, [&](const ReportProgress& progress) {
    return measure_stability(asset, options.stability, progress);
  });
  if (!report) return tl::unexpected(report.error());
  return render(options, suffix, stability_text(heading, *report), stability_json(heading, *report),
                [&] { return tl::expected<std::string, ToolError>(stability_page(heading, *report)); });
}

tl::expected<Rendered, ToolError> report_cost(const ReportOptions& options, const std::string& suffix,
                                              const Asset& asset) {
  CostChoice choice = options.cost;
  choice.width = options.size.width;
  choice.height = options.size.height;
  if (options.size_option->count() > 0) {
    choice.thesis_width = options.size.width;
    choice.thesis_height = options.size.height;
  }
  ReportHeading heading = heading_of(asset, options.file);
  const auto report = timed(options.file, heading,
                            [&](const ReportProgress& progress) { return measure_all_cost(asset, choice, progress); });
  if (!report) return tl::unexpected(report.error());
  return render(options, suffix, cost_text(heading, *report), cost_json(heading, *report),
                [&] { return cost_page(heading, *report); });
}

tl::expected<Rendered, ToolError> report_order(const ReportOptions& options, const std::string& suffix,
                                               const Asset& asset) {
  OrderSettings settings = options.order;
  if (options.size_option->count() > 0) {
    settings.width = options.size.width;
    settings.height = options.size.height;
  }
  ReportHeading heading = heading_of(asset, options.file);
  const auto report = timed(options.file, heading,
                            [&](const ReportProgress& progress) { return measure_order(asset, settings, progress); });
  if (!report) return tl::unexpected(report.error());
  return render(options, suffix, order_text(heading, *report), order_json(heading, *report),
                [&] { return order_page(heading, *report); });
}

tl::expected<Rendered, ToolError> report_shadows(const ReportOptions& options, const std::string& suffix,
                                                 const Asset& asset) {
  ReportHeading heading = heading_of(asset, options.file);
  const auto report = timed(options.file, heading, [&](const ReportProgress& progress) {
    return measure_shadows(asset, options.shadows, progress);
  });
  if (!report) return tl::unexpected(report.error());
  return render(options, suffix, shadow_text(heading, *report), shadow_json(heading, *report),
                [&] { return shadow_page(heading, *report); });
}

tl::expected<Rendered, ToolError> report_subject(const ReportOptions& options, const AccuracySettings& accuracy,
                                                 const std::string& suffix, const Asset& asset) {
  switch (options.subject) {
    case ReportSubject::kAccuracy: return report_accuracy(options, accuracy, suffix, asset);
    case ReportSubject::kStability: return report_stability(options, suffix, asset);
    case ReportSubject::kOrder: return report_order(options, suffix, asset);
    case ReportSubject::kShadows: return report_shadows(options, suffix, asset);
    case ReportSubject::kCost: return report_cost(options, suffix, asset);
  }
  return tl::unexpected(ToolError{ToolError::Kind::kInternal, "no such subject"});
}

/// What would make the minutes of measuring useless.
tl::expected<void, ToolError> check_before(const ReportOptions& options, const std::string& suffix) {
  if (options.output.empty()) return {};
  if (auto checked = check_output(options.output, {options.file}); !checked) return checked;
  const bool draws = suffix == kPageSuffix && options.subject != ReportSubject::kStability;
  return draws ? check_plotter() : tl::expected<void, ToolError>{};
}

tl::expected<AccuracySettings, ToolError> accuracy_settings(const ReportOptions& options, const Messages& messages) {
  AccuracySettings settings = options.accuracy;
  if (!options.clip) return settings;
  const auto clip = open_clip(*options.clip, messages);
  if (!clip) return tl::unexpected(clip.error());
  settings.clip = NamedPath{clip->name, clip->path};
  return settings;
}

tl::expected<Exit, ToolError> run_report(const ReportOptions& options, const Messages& messages) {
  if (auto checked = check_subject(options); !checked) return tl::unexpected(checked.error());
  std::string suffix;
  if (!options.output.empty()) {
    const auto chosen = choose_suffix(options.output, {kPageSuffix, ".json"});
    if (!chosen) return tl::unexpected(chosen.error());
    suffix = *chosen;
  }
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  if (auto checked = check_before(options, suffix); !checked) return tl::unexpected(checked.error());

  const auto settings = accuracy_settings(options, messages);
  if (!settings) return tl::unexpected(settings.error());

  const auto rendered = report_subject(options, *settings, suffix, file->asset());
  if (!rendered) {
    return tl::unexpected(ToolError{rendered.error().kind, options.file + ": " + rendered.error().message});
  }
  if (!options.output.empty()) {
    const auto written = write_output(options.output, std::as_bytes(std::span(rendered->file)));
    if (!written) return tl::unexpected(written.error());
  }
  print_result(rendered->printed);
  return Exit::kOk;
}

}  // namespace

Command add_report(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report", "Measure how wrong every way to run or draw an asset is, what it survives or what it costs");
  app->description(app->get_description() + "\n\n" + motion_help());
  const auto options = std::make_shared<ReportOptions>();
  add_report_options(*app, *options);
  return {app, [options](const Messages& messages) { return run_report(*options, messages); }};
}

}  // namespace coif
