#include "cli/body.h"

#include "base/files.h"
#include "cli/input_files.h"
#include "cook/size/settle_size.h"
#include "import/import.h"
#include "payload_hash.h"

#include <utility>

namespace coif::cli {
namespace {

/// Whether the asset was cooked from this very file.
bool is_source_of(const Asset& asset, const std::filesystem::path& file) {
  const ProvenanceRecord* const made = asset.provenance();
  const auto bytes = FileBytes::read(file);
  return made != nullptr && bytes && xxh64(bytes->span()) == made->source_hash;
}

}  // namespace

tl::expected<Body, ToolError> read_body(const BodyOptions& options, const Asset& asset, const Messages& messages) {
  const auto choice = choose_recipe(options.file, options.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  auto model = importer::import_model(
      options.file, options.limits.of_import(import_settings(choice->recipe, options.roots), messages));
  if (!model) return tl::unexpected(model.error());
  std::vector<std::filesystem::path> files = files_of(*model);
  const std::vector<std::filesystem::path> of_recipe = files_of(*choice);
  files.insert(files.end(), of_recipe.begin(), of_recipe.end());
  cook::Findings findings;
  if (auto resized = cook::settle_size(*model, choice->recipe, findings).model) *model = std::move(*resized);
  model = keep_body(std::move(*model), options.mesh, choice->recipe, is_source_of(asset, options.file));
  if (!model) return tl::unexpected(model.error());
  return Body{std::move(*model), std::move(files), std::move(findings)};
}

}  // namespace coif::cli
