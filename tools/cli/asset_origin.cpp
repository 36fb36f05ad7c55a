#include "cli/asset_origin.h"

#include "cli/asset_file.h"
#include "cli/recipe_choice.h"
#include "cook/cook.h"
#include "cook/provenance.h"
#include "parallel_for.h"
#include "payload_hash.h"
#include "validate/asset_issues.h"
#include "validate/origin_issues.h"

#include <algorithm>

namespace coif {
namespace {

using Found = tl::expected<std::vector<Issue>, ToolError>;

Found compare_with_new_cook(const Asset& asset, const SourceModel& model, const RecipeChoice& choice,
                            std::uint64_t source_hash) {
  CookSettings settings;
  settings.threads = all_threads();
  settings.recipe_directory = choice.directory;
  settings.source_hash = source_hash;
  const auto result = cook(model, choice.recipe, settings);
  if (!result) return tl::unexpected(result.error());
  const FileBytes bytes = FileBytes::copy(result->asset);
  Asset cooked_anew;
  const LoadStatus opened = open_whole(bytes.span(), cooked_anew);
  if (!opened) return tl::unexpected(ToolError{ToolError::Kind::kInternal, describe_text(opened)});
  return find_recook_issues(asset, cooked_anew);
}

}  // namespace

Found compare_with_origin(const Asset& asset, const OriginOptions& options, const Messages& messages) {
  const auto bytes = FileBytes::read(options.source);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto choice = choose_recipe(options.source, options.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  const auto model = import_model(options.source, import_settings(choice->recipe));
  if (!model) return tl::unexpected(model.error());
  const ProvenanceRecord now = make_provenance(*model, choice->recipe, xxh64(bytes->span()));
  std::vector<Issue> issues = find_origin_issues(asset, now);
  if (!options.recook) return issues;
  auto differences = compare_with_new_cook(asset, *model, *choice, now.source_hash);
  if (!differences) return tl::unexpected(differences.error());
  issues.insert(issues.end(), differences->begin(), differences->end());
  return issues;
}

}  // namespace coif
