#include "cook/cook.h"

#include "cook/pack/pack.h"
#include "cook/rig/skeleton.h"
#include "cook/stages/stages.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cook {
namespace {

ProvenanceRecord provenance_of(const importer::SourceModel& source, const Recipe& recipe,
                               const CookSettings& settings) {
  ProvenanceRecord record = make_provenance(source, recipe_hash(recipe), settings.source_hash);
  if (settings.draft) record.flags |= kProvenanceDraft;
  return record;
}

/// The files that were read before textures were baked.
CookInputs inputs_of(const importer::SourceModel& source, const BaseColor& color, const Recipe& recipe,
                     const CookSettings& settings) {
  CookInputs inputs;
  inputs.source_files.assign(source.side_files.begin(), source.side_files.end());
  inputs.source_files.insert(inputs.source_files.end(), color.files.begin(), color.files.end());
  if (!recipe.cards_body.empty()) inputs.recipe_files.push_back(settings.recipe_directory / recipe.cards_body);
  inputs.recipe_files.insert(inputs.recipe_files.end(), color.recipe_files.begin(), color.recipe_files.end());
  inputs.questions = color.questions;
  inputs.named_files = named_image_files(source);
  return inputs;
}

/// Figures that are known only at the end.
void fill_figures(const Drawn& drawn, CookReport& report) {
  const AssetContents& contents = drawn.contents;
  const bool is_drawn = !contents.vertices.empty();
  report.order = drawn.figures;
  report.triangles = is_drawn ? std::uint32_t(drawn.levels[0].triangle_count() + drawn.figures.added) : 0;
  report.vertices = std::uint32_t(contents.vertices.size());
  report.patches = is_drawn ? std::uint32_t(drawn.levels[0].patch_count()) : 0;
  report.patches_by_index = drawn.strips.extracted.by_index;
  report.patches_by_position = drawn.strips.extracted.by_position;
  report.chains = std::uint32_t(contents.chains.size());
  report.bones = std::uint32_t(contents.bones.size());
  report.simulated_bones = std::uint32_t(drawn.rig.skeleton.simulated_count());
}

/// Takes the listings out of `drawn`.
ListedPatches patches_of(Drawn& drawn) {
  ListedPatches listed;
  const HairStrips& hair = drawn.strips.hair;
  const Skeleton& skeleton = drawn.rig.skeleton;
  listed.patches = std::move(drawn.strips.listings);
  list_roots(hair, listed.patches);
  const std::vector<std::uint32_t> chains = chain_of_patches(hair, drawn.rig, listed.patches.size());
  for (PatchListing& patch : listed.patches) {
    patch.is_unsure = std::ranges::binary_search(hair.strands.unsure, patch.number);
    const std::uint32_t chain = chains[patch.number];
    if (chain != kNone) patch.chain = skeleton.bones[skeleton.chains[chain].first_bone].name;
  }
  listed.number_of_place.resize(drawn.order.patch.size());
  for (std::size_t i = 0; i < drawn.order.patch.size(); ++i) {
    listed.number_of_place[drawn.order.file_place[i]] = hair.patches.number_of(drawn.order.patch[i]);
  }
  return listed;
}

}  // namespace

tl::expected<CookResult, ToolError> cook(const importer::SourceModel& source, const Recipe& recipe,
                                         const CookSettings& settings) {
  CookResult result;
  result.report.warnings = source.warnings;
  CookLog log(settings, result.report);
  const Recipe used = settings.draft ? draft_of(recipe) : recipe;

  // The source's hair, its unit of length, and its base texture.
  auto hair = find_hair(source, used, used, settings, log);
  if (!hair) return tl::unexpected(hair.error());
  const importer::SourceModel& model = hair->model(source);
  result.inputs = inputs_of(model, hair->color, used, settings);

  // The hair's strips, the direction of their strands, and the head that it grows on.
  auto strips = find_strips(model, std::move(hair->mesh), hair->color, used, used, settings, log);
  if (!strips) return tl::unexpected(strips.error());

  // Bones and dynamics.
  auto rig = make_rig(model, *strips, used, settings, log);
  if (!rig) return tl::unexpected(rig.error());

  if (const Decision* asked = result.report.question(used.acknowledged_warnings))
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: {}", model.path, asked->doubt())});

  // Levels of detail, draw orders, textures and material.
  auto drawn = draw_hair(model, std::move(hair->color), std::move(*strips), std::move(*rig), used, used, settings, log);
  if (!drawn) return tl::unexpected(drawn.error());

  drawn->contents.provenance = {provenance_of(model, used, settings)};
  auto asset = write_hair(model.path, used, drawn->contents, log);
  if (!asset) return tl::unexpected(asset.error());

  fill_figures(*drawn, result.report);
  result.report.acknowledge(used.acknowledged_warnings);
  auto& files = result.inputs.recipe_files;
  files.insert(files.begin(), drawn->textures.files.begin(), drawn->textures.files.end());
  if (settings.list_patches) result.patches = patches_of(*drawn);
  result.asset = std::move(*asset);
  return result;
}

}  // namespace coif::cook
