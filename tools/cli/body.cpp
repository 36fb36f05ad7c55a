#include "cli/body.h"

#include "base/files.h"
#include "base/words.h"
#include "cli/input_files.h"
#include "cook/select/select_hair.h"
#include "cook/size/settle_size.h"
#include "import/import.h"
#include "payload_hash.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace coif::cli {
namespace {

/// Whether the asset was cooked from this very file.
bool is_source_of(const Asset& asset, const std::filesystem::path& file) {
  const ProvenanceRecord* const made = asset.provenance();
  const auto bytes = FileBytes::read(file);
  return made != nullptr && bytes && xxh64(bytes->span()) == made->source_hash;
}

void remove_hair(const cook::HairChoice& hair, importer::SourceModel& model) {
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    std::vector<std::uint32_t>& triangles = model.meshes[m].triangles;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (!hair.takes(m, i / 3)) kept.push_back(triangles[i]);
    }
    triangles = std::move(kept);
  }
}

bool leaves_something(const cook::HairChoice& hair, const importer::SourceModel& model) {
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    for (std::size_t t = 0; t < model.meshes[m].triangles.size() / 3; ++t) {
      if (!hair.takes(m, t)) return true;
    }
  }
  return false;
}

/// Keeps only the body's meshes, so that hair is not drawn twice. `pattern`: meshes to keep, with * and ?; empty:
/// everything that a cook with this recipe would not take for hair. `is_hairs_own`: the hair was cooked from this
/// model; if it has nothing else, it is left without meshes. A model without hair, which a caller passes as the body of
/// hair from elsewhere, is kept whole. Errors: kBadInput with all names where nothing is left; those of
/// check_hair_names(), and of choose_hair() for the hair's own model.
tl::expected<importer::SourceModel, ToolError> keep_body(importer::SourceModel model, const std::string& pattern,
                                                         const cook::Recipe& recipe, bool is_hairs_own) {
  std::vector<std::string> names;
  for (const importer::SourceMesh& mesh : model.meshes) names.push_back(fmt::format("'{}'", mesh.name));
  if (pattern.empty()) {
    cook::Findings unsaid;
    const auto hair = cook::choose_hair(model, recipe, unsaid);
    if (!hair) {
      if (is_hairs_own) return tl::unexpected(hair.error());
      if (auto known = cook::check_hair_names(model, recipe); !known) return tl::unexpected(known.error());
      return model;
    }
    const bool leaves_body = leaves_something(*hair, model);
    if (!leaves_body && is_hairs_own) {
      model.meshes.clear();
      return model;
    }
    // A model without a sign of hair counts as hair; a caller who passes it as a body knows better.
    if (leaves_body) remove_hair(*hair, model);
  }
  std::erase_if(model.meshes, [&](const importer::SourceMesh& mesh) {
    return mesh.triangles.empty() || !(pattern.empty() || matches(mesh.name, pattern));
  });
  if (!model.meshes.empty()) return model;
  return tl::unexpected(ToolError{
      ToolError::Kind::kBadInput,
      fmt::format("{}: no mesh is left for the body; give --body-mesh one of {}", model.path, fmt::join(names, ", "))});
}

}  // namespace

tl::expected<Body, ToolError> body_of(importer::SourceModel read, const BodyOptions& options,
                                      const RecipeChoice& choice, const Asset& asset) {
  std::vector<std::filesystem::path> files = files_of(read);
  const std::vector<std::filesystem::path> of_recipe = files_of(choice);
  files.insert(files.end(), of_recipe.begin(), of_recipe.end());
  cook::Findings findings;
  if (auto resized = cook::settle_size(read, choice.recipe, findings).model) read = std::move(*resized);
  auto model = keep_body(std::move(read), options.mesh, choice.recipe, is_source_of(asset, options.file));
  if (!model) return tl::unexpected(model.error());
  return Body{std::move(*model), std::move(files), std::move(findings)};
}

tl::expected<Body, ToolError> read_body(const BodyOptions& options, const Asset& asset, const Messages& messages) {
  const auto choice = choose_recipe(options.file, options.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  auto model = importer::import_model(
      options.file, options.limits.of_import(import_settings(choice->recipe, options.roots), messages));
  if (!model) return tl::unexpected(model.error());
  return body_of(std::move(*model), options, *choice, asset);
}

}  // namespace coif::cli
