#include "cli/asset_file.h"
#include "cli/asset_issues.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/recipe_choice.h"
#include "cli/results.h"
#include "cli/verdict.h"
#include "import/import.h"
#include "import/source_format.h"
#include "write/chunk_file.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace coif {
namespace {

namespace fs = std::filesystem;

struct ValidateOptions {
  std::vector<std::string> files;
  OutputFormat format = OutputFormat::kText;
};

bool has_asset_magic(std::span<const std::byte> bytes) {
  return bytes.size() >= sizeof kAssetMagic && std::memcmp(bytes.data(), kAssetMagic, sizeof kAssetMagic) == 0;
}

/// A file is taken for a source only by a suffix that the importer knows; everything else should be an asset.
bool is_source(const fs::path& path, std::span<const std::byte> bytes) {
  return find_suffix(path).has_value() && !has_asset_magic(bytes);
}

std::string place(const LoadStatus& status) {
  if (status.chunk == 0) return "";
  const std::string chunk = "chunk " + chunk_name(status.chunk);
  return status.code == LoadCode::kHash ? chunk : fmt::format("{}, record {}", chunk, status.item);
}

std::vector<Issue> validate_asset(std::span<const std::byte> bytes) {
  Asset asset;
  const LoadStatus status = open_whole(bytes, asset);
  if (status) return find_asset_issues(asset);
  return {{fmt::format("A{}", 100 + int(status.code)), Severity::kError, describe_text(status), place(status)}};
}

std::vector<Issue> validate_source(const fs::path& path, const Messages& messages) {
  const auto choice = choose_recipe(path, std::nullopt, messages);
  const auto model = import_model(path, import_settings(choice ? choice->recipe : default_recipe()));
  std::vector<Issue> issues;
  if (!choice) issues.push_back({"S103", Severity::kError, choice.error().message, "recipe"});
  if (!model) {
    const bool unsupported = model.error().kind == ToolError::Kind::kUnsupported;
    issues.push_back({unsupported ? "S102" : "S101", Severity::kError, model.error().message, ""});
    return issues;
  }
  for (const std::string& warning : model->warnings) issues.push_back({"S201", Severity::kWarning, warning, ""});
  return issues;
}

Verdict validate_file(const std::string& path, const Messages& messages) {
  const auto bytes = FileBytes::read(path);
  if (!bytes) return {path, false, {{"F101", Severity::kError, bytes.error().message, ""}}};
  if (is_source(path, bytes->span())) return {path, true, validate_source(path, messages)};
  return {path, true, validate_asset(bytes->span())};
}

/// Messages of other passes begin with the path already.
std::string issue_text(const Verdict& verdict, const Issue& issue) {
  const bool has_path = issue.message.starts_with(verdict.path + ":");
  const std::string where = issue.where.empty() || issue.message.starts_with(issue.where) ? "" : issue.where + ": ";
  return fmt::format("{}{}{} [{}]", has_path ? "" : verdict.path + ": ", where, issue.message, issue.code);
}

void tell(const Verdict& verdict, const Messages& messages) {
  for (const Issue& issue : verdict.issues) {
    const std::string text = issue_text(verdict, issue);
    switch (issue.severity) {
      case Severity::kError: messages.error(text); break;
      case Severity::kWarning: messages.warning(text); break;
      case Severity::kInfo: messages.note(text); break;
    }
  }
}

tl::expected<Exit, ToolError> run_validate(const ValidateOptions& options, const Messages& messages) {
  std::vector<Verdict> verdicts;
  for (const std::string& path : options.files) {
    verdicts.push_back(validate_file(path, messages));
    tell(verdicts.back(), messages);
  }
  print_result(options.format == OutputFormat::kJson ? verdicts_json(verdicts) : verdicts_text(verdicts));
  const auto unreadable = [](const Verdict& v) { return !v.readable; };
  const auto invalid = [](const Verdict& v) { return !v.valid(); };
  if (std::any_of(verdicts.begin(), verdicts.end(), unreadable)) return Exit::kFileAccess;
  return std::any_of(verdicts.begin(), verdicts.end(), invalid) ? Exit::kBadInput : Exit::kOk;
}

}  // namespace

Command add_validate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("validate", "Check assets and sources; exit code 3 where one has an error");
  const auto options = std::make_shared<ValidateOptions>();
  app->add_option("FILE", options->files, "Cooked assets or models")->required();
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_validate(*options, messages); }};
}

}  // namespace coif
