#include "base/files.h"
#include "base/json.h"
#include "cli/body.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/report_options.h"
#include "cli/view_output.h"
#include "render/camera.h"
#include "report/accuracy/accuracy_report.h"
#include "report/cards/cards_report.h"
#include "report/cost/cost_report.h"
#include "report/order/order_report.h"
#include "report/page/report_page.h"
#include "report/picture/picture_report.h"
#include "report/shadow/shadow_report.h"
#include "report/stability/stability_report.h"

#include <chrono>
#include <memory>
#include <optional>

namespace coif::cli {
namespace {

/// A report in the requested forms.
struct Rendered {
  std::string printed;  ///< For standard output.
  std::string file;     ///< For the output file; empty where there is none.
};

/// Shows progress while measuring, and writes the elapsed time into the heading.
template <typename Measure>
auto timed(const std::string& file, report::ReportHeading& heading, Measure measure) {
  ProgressLine line(file);
  const auto begin = std::chrono::steady_clock::now();
  auto report = measure([&line](const std::string& step) { line.show(step.c_str()); });
  heading.seconds_taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

/// The file, and the options of its report.
struct ReportJob {
  const ReportOptions& options;
  const std::string& suffix;  ///< The output file's suffix; empty where there is none.
  const std::string& view;    ///< The text of the page that the report links to; empty where there is none.
  const Asset& asset;
  const std::optional<ReportStrands>& strands;  ///< For a report about cards.
  const report::PictureReportSettings& picture;
};

/// How a report is printed.
template <typename Report>
struct ReportForms {
  std::string (*text)(const report::ReportHeading&, const Report&);
  nlohmann::ordered_json (*json)(const report::ReportHeading&, const Report&);
  const char* layout;  ///< The page's.
};

/// Pictures are for the page.
nlohmann::ordered_json without_pictures(nlohmann::ordered_json report) {
  for (const char* const list : {"worst", "sheets"}) {
    if (!report.contains(list)) continue;
    for (auto& picture : report[list]) picture.erase("png");
  }
  return report;
}

template <typename Report, typename Measure>
tl::expected<Rendered, ToolError> report_on(const ReportJob& job, const ReportForms<Report>& forms, Measure measure) {
  report::ReportHeading heading = report::heading_of(job.asset, job.options.file);
  if (!job.view.empty()) {
    heading.view = report::relative_url(job.options.view, job.options.output);
    heading.view_name = std::filesystem::path(job.options.view).filename().string();
  }
  const auto report = timed(job.options.file, heading, measure);
  if (!report) return tl::unexpected(report.error());
  const nlohmann::ordered_json json = forms.json(heading, *report);
  const std::string numbers = json_text(without_pictures(json));
  const bool as_json = job.options.format == OutputFormat::kJson;
  Rendered rendered{as_json ? numbers : forms.text(heading, *report), ""};
  if (job.suffix.empty()) return rendered;
  if (!as_json) {
    if (!job.view.empty()) rendered.printed += job.options.view + ": written\n";
    rendered.printed += job.options.output + ": written\n";
  }
  rendered.file = job.suffix == kPageSuffix ? report::page_html(json, forms.layout) : numbers;
  return rendered;
}

CostChoice cost_choice(const ReportOptions& options) {
  CostChoice choice = options.cost;
  choice.width = options.size.width;
  choice.height = options.size.height;
  if (options.size_option->count() > 0) {
    choice.thesis_width = options.size.width;
    choice.thesis_height = options.size.height;
  }
  return choice;
}

report::OrderSettings order_settings(const ReportOptions& options) {
  report::OrderSettings settings = options.order;
  if (!options.accuracy.solvers.empty()) settings.solver = options.accuracy.solvers.front();
  if (options.size_option->count() > 0) {
    settings.width = options.size.width;
    settings.height = options.size.height;
  }
  return settings;
}

tl::expected<Rendered, ToolError> report_subject(const ReportJob& job, const report::AccuracySettings& accuracy) {
  const auto with = [&job](auto measure, const auto& settings) {
    return [&job, measure, &settings](const report::ReportProgress& progress) {
      return measure(job.asset, settings, progress);
    };
  };
  switch (job.options.subject) {
    case ReportSubject::kAccuracy:
      return report_on<report::AccuracyReport>(
          job, {report::accuracy_text, report::accuracy_json, report::coif_accuracy_page},
          with(report::measure_accuracy, accuracy));
    case ReportSubject::kStability:
      return report_on<report::StabilityReport>(
          job, {report::stability_text, report::stability_json, report::coif_stability_page},
          with(report::measure_stability, job.options.stability));
    case ReportSubject::kOrder:
      return report_on<report::OrderReport>(job, {report::order_text, report::order_json, report::coif_order_page},
                                            with(report::measure_order, order_settings(job.options)));
    case ReportSubject::kShadows:
      return report_on<report::ShadowReport>(job, {report::shadow_text, report::shadow_json, report::coif_shadows_page},
                                             with(report::measure_shadows, job.options.shadows));
    case ReportSubject::kCards:
      return report_on<report::CardsReport>(job, {report::cards_text, report::cards_json, report::coif_cards_page},
                                            [&job](const report::ReportProgress& progress) {
                                              const ReportStrands& strands = *job.strands;
                                              return report::measure_cards(job.asset, strands.groom, strands.hash,
                                                                           strands.settings, progress);
                                            });
    case ReportSubject::kPicture:
      return report_on<report::PictureReport>(job,
                                              {report::picture_text, report::picture_json, report::coif_picture_page},
                                              with(report::measure_pictures, job.picture));
    case ReportSubject::kCost:
      return report_on<report::CostReport>(job, {report::cost_text, report::cost_json, report::coif_cost_page},
                                           with(measure_all_cost, cost_choice(job.options)));
  }
  return tl::unexpected(ToolError{ToolError::Kind::kInternal, "no such subject"});
}

tl::expected<report::AccuracySettings, ToolError> accuracy_settings(const ReportOptions& options,
                                                                    const Messages& messages) {
  report::AccuracySettings settings = options.accuracy;
  if (!options.clip) return settings;
  const auto clip = open_clip(*options.clip, messages);
  if (!clip) return tl::unexpected(clip.error());
  settings.clip = report::NamedPath{clip->name, clip->path};
  return settings;
}

tl::expected<void, ToolError> check_report_outputs(const ReportOptions& options) {
  const NamedOutput outputs[] = {{"--output", options.output}, {"--view", options.view}};
  std::vector<std::filesystem::path> inputs{options.file, options.page, options.cards.source,
                                            options.cards.recipe.value_or(""), options.picture.body};
  if (options.clip) inputs.push_back(options.clip->file);
  return check_outputs(outputs, inputs);
}

/// The page of `coif view` that the report links to; empty where none was requested. Made before the minutes of
/// measuring.
tl::expected<std::string, ToolError> linked_page(const ReportOptions& options, const std::string& suffix,
                                                 const AssetFile& file) {
  if (options.view.empty()) {
    if (!options.page.empty()) return usage("--page is for a report with --view");
    return "";
  }
  if (suffix != kPageSuffix) return usage("--view is for a report that is a page; name one: --output OUT.html");
  if (auto html = choose_suffix(options.view, {kPageSuffix}); !html) return tl::unexpected(html.error());
  if (auto checked = check_report_outputs(options); !checked) return tl::unexpected(checked.error());
  if (const auto drawable = render::check_drawable(file.asset()); !drawable) {
    return file_failure(drawable.error().kind, options.file, "{}", drawable.error().message);
  }
  return filled_page(options.page, file, options.file);
}

tl::expected<void, ToolError> write_text(const std::string& path, const std::string& text) {
  return path.empty() ? tl::expected<void, ToolError>{} : write_output(path, std::as_bytes(std::span(text)));
}

/// None where none was named.
tl::expected<std::optional<Body>, ToolError> body_of_truth(const ReportOptions& options, const Asset& asset,
                                                           const Messages& messages) {
  if (options.picture.body.empty()) return std::nullopt;
  return read_body({options.picture.body, "", std::nullopt, {}, {}}, asset, messages).map([](Body body) {
    return std::optional(std::move(body));
  });
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
  if (!options.output.empty()) {  // before the minutes of measuring
    if (auto checked = check_report_outputs(options); !checked) return tl::unexpected(checked.error());
  }
  std::optional<ReportStrands> strands;
  if (options.subject == ReportSubject::kCards) {
    auto read = read_report_strands(options, messages);
    if (!read) return tl::unexpected(read.error());
    strands = std::move(*read);
    strands->settings.sheets = suffix == kPageSuffix;
  }
  const auto settings = accuracy_settings(options, messages);
  if (!settings) return tl::unexpected(settings.error());

  const auto view = linked_page(options, suffix, *file);
  if (!view) return tl::unexpected(view.error());

  const auto body = body_of_truth(options, file->asset(), messages);
  if (!body) return tl::unexpected(body.error());
  report::PictureReportSettings picture = options.picture.settings;
  if (*body) picture.body = &(*body)->model;
  picture.sheets = suffix == kPageSuffix;
  const auto rendered = report_subject({options, suffix, *view, file->asset(), strands, picture}, *settings);
  if (!rendered) {
    return tl::unexpected(ToolError{rendered.error().kind, options.file + ": " + rendered.error().message});
  }
  if (const auto written = write_text(options.view, *view); !written) return tl::unexpected(written.error());
  if (const auto written = write_text(options.output, rendered->file); !written) return tl::unexpected(written.error());
  print_result(rendered->printed);
  return Exit::kOk;
}

}  // namespace

Command add_report(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report", "Measure how wrong every way to run or draw an asset is, what it survives or what it costs");
  app->footer(motion_help());
  const auto options = std::make_shared<ReportOptions>();
  add_report_options(*app, *options);
  return {app, [options](const Messages& messages) { return run_report(*options, messages); }};
}

}  // namespace coif::cli
