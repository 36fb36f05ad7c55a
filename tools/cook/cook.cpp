#include "cook/cook.h"

#include "cook/bake_occlusion.h"
#include "cook/choose_order.h"
#include "cook/cook_passes.h"
#include "cook/keep_coverage.h"
#include "cook/leave_out.h"
#include "cook/pack_material.h"
#include "cook/pack_mesh.h"
#include "cook/pack_skeleton.h"
#include "cook/provenance.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <new>

namespace coif {
namespace {

/// Opens what was written: an asset that the runtime would refuse must never reach a disk.
tl::expected<void, ToolError> check_written(const SourceModel& source, const std::vector<std::byte>& bytes) {
  const auto memory = std::make_unique<std::byte[]>(bytes.size() + 64);
  void* aligned = memory.get();
  std::size_t space = bytes.size() + 64;
  std::align(64, bytes.size(), aligned, space);
  std::memcpy(aligned, bytes.data(), bytes.size());
  Asset asset;
  LoadStatus status = asset.open({static_cast<const std::byte*>(aligned), bytes.size()});
  if (status) status = asset.verify_draw_data();
  if (status) return {};
  char text[256];
  describe(status, text, sizeof text);
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, fmt::format("{}: the cooked asset is not valid: {}", source.path, text)});
}

AssetContents pack(CookedParts& parts, const SourceModel& source, const Recipe& recipe, const CookSettings& settings) {
  const HairMesh& mesh = parts.selected.mesh;
  AssetContents contents;
  pack_skeleton(parts.skeleton, parts.colliders, contents);
  pack_mesh(mesh, parts.lods.levels, parts.order, parts.strands, parts.head_bone.joint, parts.weights, contents);
  contents.dynamics = parts.dynamics.records;
  contents.tuning = parts.tuned.tuning;
  contents.quality = parts.tuned.quality;
  contents.material = {pack_material(parts.base_color, parts.textures, mesh, recipe)};
  contents.textures = parts.textures.records;
  contents.texels = std::move(parts.textures.texels);
  contents.provenance = {make_provenance(source, recipe, settings.source_hash)};
  return contents;
}

CookInputs inputs_of(const CookedParts& parts, const SourceModel& source, const Recipe& recipe) {
  CookInputs inputs;
  inputs.source_files.assign(source.side_files.begin(), source.side_files.end());
  inputs.recipe_files = parts.textures.files;
  auto& of_color = recipe.base_color_texture.empty() ? inputs.source_files : inputs.recipe_files;
  of_color.insert(of_color.end(), parts.base_color.files.begin(), parts.base_color.files.end());
  inputs.questions = parts.base_color.questions;
  return inputs;
}

void fill_figures(const CookedParts& parts, const AssetContents& contents, CookReport& report) {
  const bool is_drawn = !contents.vertices.empty();
  report.triangles = is_drawn ? std::uint32_t(parts.lods.levels[0].triangle_count()) : 0;
  report.vertices = std::uint32_t(contents.vertices.size());
  report.patches = is_drawn ? std::uint32_t(parts.lods.levels[0].patch_count()) : 0;
  report.patches_by_index = parts.extracted.by_index;
  report.patches_by_position = parts.extracted.by_position;
  report.chains = std::uint32_t(contents.chains.size());
  report.bones = std::uint32_t(contents.bones.size());
  report.simulated_bones = std::uint32_t(parts.skeleton.simulated_count());
}

}  // namespace

tl::expected<CookResult, ToolError> cook(const SourceModel& source, const Recipe& recipe,
                                         const CookSettings& settings) {
  CookResult result;
  CookReport& report = result.report;
  report.warnings = source.warnings;
  auto parts = run_passes(source, recipe, settings, report);
  if (!parts) return tl::unexpected(parts.error());
  AssetContents contents = run_timed(settings, report, "pack", [&] { return pack(*parts, source, recipe, settings); });
  if (recipe.scene_draw) {
    const auto notes =
        run_timed(settings, report, "occlusion", [&] { return bake_occlusion(recipe, settings.threads, contents); });
    report.notes.insert(report.notes.end(), notes.begin(), notes.end());
  }
  auto order = run_timed(settings, report, "order",
                         [&] { return choose_order(recipe, parts->textures.used, settings.threads, contents); });
  if (!order) return tl::unexpected(order.error());
  report.notes.insert(report.notes.end(), order->begin(), order->end());
  // Last, since the threshold in use decides how much alpha the mips need.
  const KeptCoverage kept =
      run_timed(settings, report, "mips", [&] { return keep_coverage(parts->textures.used, contents); });
  report.notes.insert(report.notes.end(), kept.notes.begin(), kept.notes.end());
  report.warnings.insert(report.warnings.end(), kept.warnings.begin(), kept.warnings.end());
  const std::vector<LeftOut> left_out = leave_out_parts(recipe, contents);
  report.left_out.insert(report.left_out.end(), left_out.begin(), left_out.end());
  fill_figures(*parts, contents, report);
  result.inputs = inputs_of(*parts, source, recipe);
  result.asset = run_timed(settings, report, "write", [&] { return write_asset(contents); });
  if (auto ok = check_written(source, result.asset); !ok) return tl::unexpected(ok.error());
  return result;
}

}  // namespace coif
