#include "cli/report_options.h"

#include "cli/options.h"
#include "cli/verb_options.h"
#include "cli/view_output.h"

#include <algorithm>
#include <utility>

namespace coif::cli {
namespace {

constexpr Choice<ReportSubject> kSubjects[] = {
    {"accuracy", ReportSubject::kAccuracy}, {"stability", ReportSubject::kStability}, {"order", ReportSubject::kOrder},
    {"shadows", ReportSubject::kShadows},   {"cost", ReportSubject::kCost},           {"cards", ReportSubject::kCards},
    {"picture", ReportSubject::kPicture}};

/// The option may occur several times, each time with one value or several separated by commas.
CLI::Option* as_list(CLI::Option* option) {
  return option->allow_extra_args(false)->delimiter(',')->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

template <typename Value>
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<Value>& values, const std::string& help) {
  return as_list(app.add_option(name, values, help));
}

void take_motion(const std::string& word, ReportOptions& options) {
  if (const auto motion = motion::find_motion(word)) {
    options.accuracy.motions.push_back(*motion);
    return;
  }
  const auto clip = find_clip(word);
  if (!clip) {
    throw CLI::ValidationError("--motion", fmt::format("'{}' is neither a motion nor a file; see --help", word));
  }
  if (options.clip) throw CLI::ValidationError("--motion", fmt::format("'{}': one clip at a time", word));
  options.clip = clip;
}

CLI::Option* add_motions(CLI::App& app, ReportOptions& options) {
  const auto parse = [&options](const std::vector<std::string>& words) {
    for (const std::string& word : words) take_motion(word, options);
  };
  CLI::Option* option = app.add_option_function<std::vector<std::string>>(
      "--motion", parse, "How the head moves, repeatable (default: all built-in motions)");
  return as_list(option->type_name("NAME|CLIP[:NODE]"));
}

void add_solvers(CLI::App& app, ReportOptions& options) {
  const auto parse = [&options](const std::vector<std::string>& words) {
    const std::vector<std::string> known = report::report_solvers();
    for (const std::string& word : words) {
      if (std::ranges::find(known, word) != known.end()) continue;
      throw CLI::ValidationError("--solver", fmt::format("'{}' is not one of {}", word, fmt::join(known, ", ")));
    }
    options.accuracy.solvers = options.stability.solvers = options.cost.simulation.solvers = words;
  };
  CLI::Option* option = app.add_option_function<std::vector<std::string>>(
      "--solver", parse,
      "Which methods, repeatable (default: all); for order the one that "
      "moves the hair (default: coif)");
  as_list(option->type_name("NAME"));
}

std::vector<const CLI::Option*> add_accuracy_options(CLI::App& app, ReportOptions& options) {
  report::AccuracySettings& accuracy = options.accuracy;
  return {add_motions(app, options),
          add_list(app, "--fps", accuracy.fps, "Frame rates, repeatable")
              ->check(CLI::Range(10.0, 1000.0))
              ->capture_default_str(),
          add_list(app, "--substeps", accuracy.substeps, "Sub-steps of a frame, for solvers that have them, repeatable")
              ->check(CLI::Range(1u, 64u))
              ->capture_default_str(),
          app.add_option("--seconds", accuracy.seconds, "Length of each motion")
              ->check(CLI::Range(0.1, 60.0))
              ->capture_default_str(),
          app.add_flag("--velocities", accuracy.tells_velocities,
                       "Tell the runtime with each pose how fast the head moves, as hosts may that know it"),
          app.add_option("--budget", accuracy.budget_rms_pct, "RMS error that is good enough, % of a chain's length")
              ->check(CLI::Range(0.001, 1000.0))
              ->capture_default_str()};
}

std::vector<const CLI::Option*> add_cost_options(CLI::App& app, CostChoice& cost) {
  CLI::Option* const undrawn = app.add_flag("!--no-drawing", cost.draws, "Leave out what drawing costs");
  return {add_list(app, "--heads", cost.simulation.heads, "Sizes of the crowd, repeatable")
              ->check(CLI::Range(1u, 1000000u))
              ->capture_default_str(),
          app.add_option("--time", cost.seconds, "Seconds to measure for, about")
              ->check(CLI::Range(0.1, 3600.0))
              ->capture_default_str(),
          undrawn,
          app.add_flag("--table1", cost.thesis_table,
                       "Also Table 1 of the thesis: 20, 50, 100 and 200 heads at 1024x768 or --size, for --time again")
              ->excludes(undrawn)};
}

std::vector<const CLI::Option*> add_order_options(CLI::App& app, report::OrderSettings& order) {
  return {
      app.add_option("--views", order.views, "Directions to look from")
          ->check(CLI::Range(1u, report::kMostOrderViews))
          ->capture_default_str(),
      app.add_option("--orbit", order.orbit_frames, "Frames, a degree apart, in which popping is looked for; 0: none")
          ->check(CLI::Range(0u, 360u))
          ->capture_default_str(),
      app.add_flag("!--no-modes", order.modes, "Leave out other ways to draw, opaque thresholds and distances")};
}

std::vector<const CLI::Option*> add_shadow_options(CLI::App& app, report::ShadowSettings& shadows) {
  return {add_list(app, "--map-size", shadows.sizes, "Texels each way of a shadow's map, repeatable")
              ->check(CLI::Range(16u, 4096u))
              ->capture_default_str(),
          app.add_option("--spacing", shadows.spacing, "Metres between the lines of the exact reference")
              ->check(CLI::Range(0.0005, 0.02))
              ->capture_default_str()};
}

std::vector<const CLI::Option*> add_cards_options(CLI::App& app, CardsChoice& cards) {
  std::vector<const CLI::Option*> options = add_source_limits(app, cards.limits);
  for (const CLI::Option* option :
       {app.add_option("--source", cards.source, "The strands that the asset was cooked from")->type_name("GROOM"),
        app.add_option("--recipe", cards.recipe,
                       "The recipe that it was cooked with (default: GROOM's name with .recipe.json)")
            ->type_name("FILE"),
        add_list(app, "--budgets", cards.settings.budgets, "Triangles of each set of cards, repeatable")
            ->check(CLI::Range(2u, 1000000u))
            ->capture_default_str(),
        app.add_flag("--ablation", cards.settings.ablation,
                     "Also make each set of cards without the fit of its opacity and without cards on the scalp"),
        app.add_option("--directions", cards.settings.directions, "To compare cards and strands from")
            ->check(CLI::Range(1u, 512u))
            ->capture_default_str()}) {
    options.push_back(option);
  }
  return options;
}

std::vector<const CLI::Option*> add_truth_options(CLI::App& app, PictureChoice& picture) {
  return {app.add_option("--truth", picture.settings.truth,
                         "The folder of path-traced pictures of the same hair, with their list, truth.json")
              ->type_name("FOLDER"),
          app.add_option("--body", picture.body, "The model that hides and shades the hair there")->type_name("SOURCE"),
          add_shading(app, picture.settings.shading),
          app.add_option("--lod", picture.settings.lod, "Level of detail, 0 is the finest")->capture_default_str()};
}

/// Error (kUsage): one of `only`, which only `subject` takes, was given.
tl::expected<void, ToolError> refuse(const std::vector<const CLI::Option*>& only, const char* subject) {
  for (const CLI::Option* option : only) {
    if (option->count() == 0) continue;
    return tl::unexpected(
        ToolError{ToolError::Kind::kUsage,
                  fmt::format("{} is for 'coif report FILE.coif {}' only; leave it out", option->get_name(), subject)});
  }
  return {};
}

}  // namespace

void add_report_options(CLI::App& app, ReportOptions& options) {
  app.add_option("FILE", options.file, "A cooked asset")->required();
  add_choice<ReportSubject>(app, "SUBJECT", options.subject, kSubjects, "What about (default accuracy)");
  app.add_option("-o,--output", options.output, "A page with plots and tables, or the numbers")
      ->type_name("OUT.html|OUT.json");
  app.add_option("--view", options.view,
                 "With OUT.html: also write the page of coif view of this asset, to which the report links")
      ->type_name("PAGE.html");
  add_page(app, options.page);
  add_solvers(app, options);
  options.only.push_back({ReportSubject::kAccuracy, "accuracy", add_accuracy_options(app, options)});
  options.only.push_back({ReportSubject::kCost, "cost", add_cost_options(app, options.cost)});
  options.only.push_back({ReportSubject::kOrder, "order", add_order_options(app, options.order)});
  options.only.push_back({ReportSubject::kShadows, "shadows", add_shadow_options(app, options.shadows)});
  options.only.push_back({ReportSubject::kCards, "cards", add_cards_options(app, options.cards)});
  options.only.push_back({ReportSubject::kPicture, "picture", add_truth_options(app, options.picture)});
  options.size_option = add_size(app, options.size)
                            ->description("Pixels of a picture (default: cost 512x384, order 160x160, cards 256x256)");
  add_format(app, options.format);
}

tl::expected<void, ToolError> check_subject(const ReportOptions& options) {
  for (const SubjectOptions& of : options.only) {
    if (of.subject == options.subject) continue;
    if (auto refused = refuse(of.options, of.name); !refused) return refused;
  }
  if (options.subject == ReportSubject::kOrder && options.accuracy.solvers.size() > 1) {
    return tl::unexpected(ToolError{ToolError::Kind::kUsage, "--solver: draw orders are measured with one at a time"});
  }
  if (options.subject == ReportSubject::kCards && options.cards.source.empty()) {
    return usage("cards are compared with strands; name those that the asset was cooked from: --source GROOM");
  }
  if (options.subject == ReportSubject::kPicture && options.picture.settings.truth.empty()) {
    return usage("pictures are compared with true ones; name their folder: --truth FOLDER");
  }
  const bool has_pictures = options.subject == ReportSubject::kCost || options.subject == ReportSubject::kOrder ||
                            options.subject == ReportSubject::kCards;
  return has_pictures ? tl::expected<void, ToolError>{} : refuse({options.size_option}, "cost', 'order' or 'cards");
}

}  // namespace coif::cli
