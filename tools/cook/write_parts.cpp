#include "cook/cooking.h"
#include "cook/pack/pack.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {

void pack_parts(Cooking& c) {
  AssetContents& contents = c.contents;
  pack_mesh(c.hair, c.rig, c.levels, c.order, contents);
  contents.tuning = c.tuned.tuning;
  contents.quality = c.tuned.quality;
  contents.motion_names = c.tuned.motions;
  contents.material = {pack_material(c.color, c.textures, c.hair.mesh, c.recipe)};
  contents.textures = c.textures.stored.records;
  contents.texels = std::move(c.textures.stored.texels);
  contents.reliefs = c.textures.relief.records;
  contents.relief_texels = std::move(c.textures.relief.texels);
  contents.provenance = {make_provenance(c.source, c.recipe, c.settings.source_hash)};
  if (c.settings.draft) contents.provenance.front().flags |= kProvenanceDraft;
}

void judge_coverage(Cooking& c) {
  const auto texels = c.contents.texels;
  keep_coverage(c.textures.used, c.contents);
  report_coverage(c.textures.used, c.contents, c.report);
  c.contents.texels = texels;
}

tl::expected<void, ToolError> write_parts(Cooking& c) {
  leave_out_parts(c.recipe, c.contents, c.report);
  c.asset = write_asset(c.contents);
  const OpenedAsset opened(c.asset);
  LoadStatus status = opened.status();
  if (status) status = opened.asset().verify_draw_data();
  if (status) return {};
  char text[256];
  describe(status, text, sizeof text);
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, fmt::format("{}: the cooked asset is not valid: {}", c.source.path, text)});
}

void fill_figures(Cooking& c) {
  CookReport& report = c.report;
  const bool is_drawn = !c.contents.vertices.empty();
  report.triangles = is_drawn ? std::uint32_t(c.levels[0].triangle_count() + report.order.added) : 0;
  report.vertices = std::uint32_t(c.contents.vertices.size());
  report.patches = is_drawn ? std::uint32_t(c.levels[0].patch_count()) : 0;
  report.patches_by_index = c.extracted.by_index;
  report.patches_by_position = c.extracted.by_position;
  report.chains = std::uint32_t(c.contents.chains.size());
  report.bones = std::uint32_t(c.contents.bones.size());
  report.simulated_bones = std::uint32_t(c.rig.skeleton.simulated_count());
}

ListedPatches patches_of(Cooking& c) {
  ListedPatches listed;
  if (!c.settings.list_patches) return listed;
  list_roots(c.hair, c.listings);
  const std::vector<std::uint32_t> chains = chain_of_patches(c.hair, c.rig, c.listings.size());
  for (PatchListing& patch : c.listings) {
    patch.is_unsure = std::ranges::binary_search(c.hair.strands.unsure, patch.number);
    const std::uint32_t chain = chains[patch.number];
    if (chain != kNone) patch.chain = c.rig.skeleton.bones[c.rig.skeleton.chains[chain].first_bone].name;
  }
  listed.number_of_place.resize(c.order.patch.size());
  for (std::size_t i = 0; i < c.order.patch.size(); ++i) {
    listed.number_of_place[c.order.file_place[i]] = c.hair.patches.number_of(c.order.patch[i]);
  }
  listed.patches = std::move(c.listings);
  return listed;
}

CookInputs inputs_of(const Cooking& c) {
  CookInputs inputs;
  inputs.source_files.assign(c.source.side_files.begin(), c.source.side_files.end());
  inputs.recipe_files = c.textures.files;
  if (!c.recipe.cards_body.empty()) inputs.recipe_files.push_back(c.settings.recipe_directory / c.recipe.cards_body);
  inputs.source_files.insert(inputs.source_files.end(), c.color.files.begin(), c.color.files.end());
  inputs.recipe_files.insert(inputs.recipe_files.end(), c.color.recipe_files.begin(), c.color.recipe_files.end());
  inputs.questions = c.color.questions;
  inputs.named_files = named_image_files(c.source);
  return inputs;
}

}  // namespace coif
