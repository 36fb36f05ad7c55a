#include "base/files.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/cook_job.h"
#include "cli/cook_process.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"
#include "cli/verdict.h"
#include "cook/cook.h"
#include "import/import.h"
#include "payload_hash.h"
#include "validate/find_issues.h"
#include "validate/issue_codes.h"

#include <algorithm>
#include <map>
#include <memory>
#include <ranges>

namespace coif::cli {
namespace {

namespace fs = std::filesystem;
using Found = tl::expected<Diagnostics, ToolError>;

/// The inputs that the asset should have been cooked from.
struct OriginOptions {
  std::string source;                 ///< Empty: nothing is compared.
  std::optional<std::string> recipe;  ///< None: the recipe beside the source, or the defaults.
  std::vector<fs::path> roots;        ///< ImportSettings::roots.
  SourceLimits limits;
  bool recook = false;  ///< Compare with the bytes of a new cook, too.
};

struct ValidateOptions {
  std::vector<std::string> files;
  OriginOptions origin;
  validate::IssuePolicy policy;
  std::string report;
  bool list_codes = false;
  OutputFormat format = OutputFormat::kText;
};

constexpr Choice<Severity> kSeverities[] = {
    {"error", Severity::kError}, {"warning", Severity::kWarning}, {"info", Severity::kInfo}};

Found compare_with_new_cook(const Asset& asset, std::span<const std::byte> cooked) {
  const FileBytes bytes = FileBytes::copy(cooked);
  Asset cooked_anew;
  const LoadStatus opened = open_whole(bytes.span(), cooked_anew);
  if (!opened) return tl::unexpected(ToolError{ToolError::Kind::kInternal, describe_text(opened)});
  return validate::find_recook_issues(asset, cooked_anew);
}

/// The order and the limits for a child process that reads a source.
CookOrder order_of(const std::string& source, const RecipeChoice& choice, const OriginOptions& options,
                   const Messages& messages) {
  CookOrder order;
  order.source = source;
  order.recipe = choice.recipe;
  order.recipe_directory = choice.directory;
  order.import = options.limits.of_import(import_settings(choice.recipe, options.roots), messages);
  order.threads = platform::all_threads();
  return order;
}

/// Whether a cook of the source would still give this asset. Errors: those of reading source and recipe; with `recook`
/// also those of the cook.
Found compare_with_origin(const Asset& asset, const OriginOptions& options, const Messages& messages) {
  const auto bytes = FileBytes::read(options.source);
  if (!bytes) return tl::unexpected(bytes.error());
  auto choice = held_recipe(options.source, options.recipe, options.limits.requires_sandbox, options.roots, messages);
  if (!choice) return tl::unexpected(choice.error());
  CookOrder order = order_of(options.source, *choice, options, messages);
  order.source_hash = xxh64(bytes->span());
  order.cooks = options.recook;
  const auto answer = cook_in_child(order, {options.source, options.limits, platform::all_threads()});
  if (!answer) return tl::unexpected<ToolError>(answer.error());
  Diagnostics issues = validate::find_origin_issues(asset, answer->provenance);
  if (!options.recook) return issues;
  auto differences = compare_with_new_cook(asset, answer->result.asset);
  if (!differences) return tl::unexpected(differences.error());
  issues.insert(issues.end(), differences->begin(), differences->end());
  return issues;
}

Found validate_asset(std::span<const std::byte> bytes, const OriginOptions& origin, const Messages& messages) {
  Asset asset;
  const LoadStatus status = open_whole(bytes, asset);
  if (!status) return std::vector{validate::refusal_issue(status)};
  Diagnostics issues = validate::find_asset_issues(asset);
  if (origin.source.empty()) return issues;
  auto differences = compare_with_origin(asset, origin, messages);
  if (!differences) return differences;
  issues.insert(issues.end(), differences->begin(), differences->end());
  return issues;
}

/// Cooks the source without the search for draw orders, which takes longest and gives no warnings.
Diagnostics issues_of_a_cook(const fs::path& path, RecipeChoice choice, const OriginOptions& options,
                             const Messages& messages) {
  choice.recipe.order_method = cook::OrderMethod::kHead;
  choice.recipe.occlusion_strength = 0;
  CookOrder order = order_of(path.string(), choice, options, messages);
  order.finds_issues = true;
  auto answer = cook_in_child(order, {path.string(), options.limits, platform::all_threads()});
  return answer ? std::move(answer->issues) : std::vector{validate::import_issue(answer.error())};
}

Diagnostics validate_source(const fs::path& path, const OriginOptions& options, const Messages& messages) {
  const auto choice = held_recipe(path, options.recipe, options.limits.requires_sandbox, options.roots, messages);
  const RecipeChoice used = choice ? *choice : RecipeChoice{cook::default_recipe(), {}, {}};
  Diagnostics issues;
  if (!choice) issues.push_back(validate::make_issue("S103", choice.error().message, "recipe"));
  if (const auto known = check_ignored(used.recipe.acknowledged_warnings, "\"warnings.acknowledged\""); !known)
    issues.push_back(validate::make_issue("S103", known.error().message, "recipe"));
  const auto found = issues_of_a_cook(path, used, options, messages);
  issues.insert(issues.end(), found.begin(), found.end());
  return issues;
}

/// Empty for a file that is not an asset or does not open.
IssuePictures pictures_of(std::span<const std::byte> bytes, const validate::JudgedIssues& issues) {
  Asset asset;
  return open_whole(bytes, asset) ? picture_issues(asset, issues.shown) : IssuePictures{};
}

tl::expected<Verdict, ToolError> validate_file(const std::string& path, const ValidateOptions& options,
                                               const Messages& messages) {
  const auto bytes = FileBytes::read(path);
  if (!bytes)
    return Verdict{
        path, false, validate::judge({validate::make_issue("F101", bytes.error().message)}, options.policy), {}};
  const bool source = is_source(path, bytes->span());
  auto issues = source ? Found(validate_source(path, options.origin, messages))
                       : validate_asset(bytes->span(), options.origin, messages);
  if (!issues) return tl::unexpected(issues.error());
  Verdict verdict{path, true, validate::judge(std::move(*issues), options.policy), {}};
  if (!options.report.empty()) verdict.pictures = pictures_of(bytes->span(), verdict.issues);
  return verdict;
}

/// A note that further issues of a code are left out comes after the last one that is shown.
void tell(const Verdict& verdict, const Messages& messages) {
  std::map<std::string, std::size_t> last;
  for (std::size_t i = 0; i < verdict.issues.shown.size(); ++i) last[verdict.issues.shown[i].code] = i;
  for (std::size_t i = 0; i < verdict.issues.shown.size(); ++i) {
    const Diagnostic& issue = verdict.issues.shown[i];
    messages.tell(issue.severity, issue.text(verdict.path));
    const auto more = std::ranges::find(verdict.issues.folded, issue.code, &validate::FoldedIssues::code);
    if (last[issue.code] != i || more == verdict.issues.folded.end()) continue;
    messages.tell(more->severity, fmt::format("{}: {} more like this [{}]", verdict.path, more->count, more->code));
  }
}

tl::expected<void, ToolError> check_page(const ValidateOptions& options) {
  if (options.report.empty()) return {};
  if (auto suffix = choose_suffix(options.report, {".html"}); !suffix) return tl::unexpected(suffix.error());
  for (const std::string& file : options.files) {
    if (auto checked = check_output(options.report, {file, options.origin.source, options.origin.recipe.value_or("")});
        !checked)
      return checked;
  }
  return {};
}

tl::expected<void, ToolError> check_usage(const ValidateOptions& options) {
  if (options.files.empty() && !options.list_codes) return usage("FILE is required; see 'coif validate --help'");
  if (!options.origin.source.empty() && options.files.size() != 1) return usage("--source is for one asset at a time");
  if (const auto page = check_page(options); !page) return page;
  return check_ignored(options.policy.ignored, "--ignore");
}

/// Every error of the file says that this version cannot read it.
bool is_only_unsupported(const Verdict& verdict) {
  const auto is_error = [](const Diagnostic& issue) { return issue.severity == Severity::kError; };
  auto errors = verdict.issues.shown | std::views::filter(is_error);
  return !std::ranges::empty(errors) &&
         std::ranges::all_of(errors, [](const Diagnostic& e) { return validate::is_unsupported(e.code); });
}

Exit exit_of(std::span<const Verdict> verdicts) {
  const auto unreadable = [](const Verdict& v) { return !v.readable; };
  const auto invalid = [](const Verdict& v) { return !v.issues.valid(); };
  const auto wrong = [&](const Verdict& v) { return invalid(v) && !is_only_unsupported(v); };
  if (std::ranges::any_of(verdicts, unreadable)) return Exit::kFileAccess;
  if (std::ranges::any_of(verdicts, wrong)) return Exit::kBadInput;
  return std::ranges::any_of(verdicts, invalid) ? Exit::kUnsupported : Exit::kOk;
}

/// Prints the verdicts and writes the page, if requested.
tl::expected<Exit, ToolError> publish(const std::vector<Verdict>& verdicts, const ValidateOptions& options) {
  print_result(options.format == OutputFormat::kJson ? verdicts_json(verdicts) : verdicts_text(verdicts));
  if (!options.report.empty()) {
    const std::string page = verdict_page(verdicts);
    if (auto written = write_output(options.report, std::as_bytes(std::span(page))); !written)
      return tl::unexpected(written.error());
  }
  return exit_of(verdicts);
}

tl::expected<Exit, ToolError> run_validate(const ValidateOptions& options, const Messages& messages) {
  if (const auto checked = check_usage(options); !checked) return tl::unexpected(checked.error());
  if (options.list_codes) {
    print_result(options.format == OutputFormat::kJson ? validate::code_json() : validate::code_page());
    return Exit::kOk;
  }
  std::vector<Verdict> verdicts;
  for (const std::string& path : options.files) {
    auto verdict = validate_file(path, options, messages);
    if (!verdict) return tl::unexpected(verdict.error());
    verdicts.push_back(std::move(*verdict));
    tell(verdicts.back(), messages);
  }
  return publish(verdicts, options);
}

void add_policy(CLI::App& app, validate::IssuePolicy& policy) {
  add_choice<Severity>(app, "--severity", policy.lowest, kSeverities, "The lowest that is shown (default info)");
  add_ignored(app, policy.ignored);
  app.add_flag("--warnings-as-errors", policy.warnings_as_errors, "A warning makes a file invalid, too");
  add_number(app, "--max-issues", policy.most_of_a_code, 1u, 1000000u,
             "Shown of each code and file; the others are counted")
      ->type_name("N");
}

void add_origin(CLI::App& app, OriginOptions& origin) {
  CLI::Option* source =
      app.add_option("--source", origin.source, "What the asset was cooked from: is it still the same?")
          ->type_name("MODEL");
  app.add_option("--recipe", origin.recipe, "The source's recipe (default: its name with .recipe.json)")
      ->type_name("R.json");
  add_roots(app, origin.roots);
  add_source_limits(app, origin.limits);
  app.add_flag("--recook", origin.recook, "Cook the source again and compare what comes out")->needs(source);
}

}  // namespace

Command add_validate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("validate",
                                         "Check assets and sources; exit code 3 where one has an error, 5 where all "
                                         "that is wrong is that it is not read here");
  const auto options = std::make_shared<ValidateOptions>();
  app->add_option("FILE", options->files, "Cooked assets or models");
  add_policy(*app, options->policy);
  add_origin(*app, options->origin);
  app->add_option("--report", options->report, "Also write a page, with pictures of the patches that have issues")
      ->type_name("OUT.html");
  app->add_flag("--list-codes", options->list_codes, "Print what every code means, check nothing");
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_validate(*options, messages); }};
}

}  // namespace coif::cli
