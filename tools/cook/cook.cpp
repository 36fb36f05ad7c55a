#include "cook/cook.h"

#include "cook/bake_dynamics.h"
#include "cook/bake_textures.h"
#include "cook/build_skeleton.h"
#include "cook/extract_patches.h"
#include "cook/fit_head.h"
#include "cook/pack_mesh.h"
#include "cook/pack_skeleton.h"
#include "cook/select_hair.h"
#include "cook/smooth_normals.h"
#include "cook/sort_patches.h"
#include "cook/strand_direction.h"
#include "payload_hash.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <memory>
#include <new>

namespace coif {
namespace {

/// Runs one pass and notes its time.
template <typename Pass>
auto timed(CookReport& report, const char* name, const Pass& pass) {
  const auto start = std::chrono::steady_clock::now();
  auto result = pass();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  report.passes.push_back({name, elapsed.count()});
  return result;
}

/// What each pass made; the input of packing.
struct CookedParts {
  SelectedHair selected;
  ExtractedPatches extracted;
  Skeleton skeleton;
  FittedHead head;
  StrandField strands;
  PatchOrder order;
  BakedTextures textures;
};

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

ProvenanceRecord make_provenance(const SourceModel& source, const Recipe& recipe, const CookSettings& settings) {
  const std::string text = print_recipe(recipe);
  ProvenanceRecord record{};
  record.source_hash = settings.source_hash;
  record.recipe_hash = xxh64(std::as_bytes(std::span(text.data(), text.size())));
  record.tool_version[0] = COIF_VERSION_MAJOR;
  record.tool_version[1] = COIF_VERSION_MINOR;
  record.tool_version[2] = COIF_VERSION_PATCH;
  std::copy_n(source.importer_version, 3, record.importer_version);
  return record;
}

/// Opens what was written: an asset that the runtime would refuse must never reach a disk.
tl::expected<void, ToolError> check_written(const SourceModel& source, const std::vector<std::byte>& bytes) {
  const auto memory = std::make_unique<std::byte[]>(bytes.size() + 64);
  void* aligned = memory.get();
  std::size_t space = bytes.size() + 64;
  std::align(64, bytes.size(), aligned, space);
  std::memcpy(aligned, bytes.data(), bytes.size());
  Asset asset;
  const LoadStatus status = asset.open({static_cast<const std::byte*>(aligned), bytes.size()});
  if (status) return {};
  char text[256];
  describe(status, text, sizeof text);
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, fmt::format("{}: the cooked asset is not valid: {}", source.path, text)});
}

tl::expected<CookedParts, ToolError> run_passes(const SourceModel& source, const Recipe& recipe,
                                                const CookSettings& settings, CookReport& report) {
  CookedParts parts;
  auto selected = timed(report, "select", [&] { return select_hair(source, recipe); });
  if (!selected) return tl::unexpected(selected.error());
  parts.selected = std::move(*selected);
  HairMesh& mesh = parts.selected.mesh;
  parts.extracted = timed(report, "patches", [&] {
    return extract_patches(mesh, {recipe.patch_connectivity, recipe.patch_weld_distance});
  });
  auto skeleton = timed(report, "skeleton", [&] { return build_skeleton(source, mesh, recipe); });
  if (!skeleton) return tl::unexpected(skeleton.error());
  parts.skeleton = std::move(*skeleton);
  parts.head =
      timed(report, "head", [&] { return fit_head(source, mesh, parts.selected.meshes, parts.skeleton, recipe); });
  timed(report, "normals", [&] { return complete_normals(mesh, recipe.patch_weld_distance); });
  parts.strands = timed(report, "strands", [&] {
    return find_strand_direction(mesh, parts.extracted.patches, parts.head, settings.threads);
  });
  parts.order = timed(report, "order", [&] { return sort_patches(mesh, parts.extracted.patches, parts.head.center); });
  auto textures =
      timed(report, "textures", [&] { return bake_textures(source, mesh, parts.strands.along_u, recipe, settings); });
  if (!textures) return tl::unexpected(textures.error());
  parts.textures = std::move(*textures);
  return parts;
}

AssetContents pack(CookedParts& parts, const SourceModel& source, const Recipe& recipe, const CookSettings& settings) {
  const HairMesh& mesh = parts.selected.mesh;
  const SourceMaterial* material = mesh.material < source.materials.size() ? &source.materials[mesh.material] : nullptr;
  AssetContents contents;
  pack_skeleton(parts.skeleton, parts.head, contents);
  pack_mesh(mesh, parts.extracted.patches, parts.order, parts.strands, parts.skeleton, contents);
  contents.dynamics = bake_dynamics(parts.skeleton, recipe);
  contents.material = {pack_material(material, recipe)};
  contents.textures = parts.textures.records;
  contents.texels = std::move(parts.textures.texels);
  contents.provenance = {make_provenance(source, recipe, settings)};
  return contents;
}

void fill_report(const CookedParts& parts, const AssetContents& contents, CookReport& report) {
  append(report.warnings, parts.selected.warnings);
  append(report.warnings, parts.skeleton.warnings);
  append(report.warnings, parts.head.warnings);
  append(report.warnings, parts.textures.warnings);
  append(report.left_out, parts.selected.left_out);
  append(report.left_out, parts.textures.left_out);
  report.triangles = std::uint32_t(contents.indices.size() / 3);
  report.vertices = std::uint32_t(contents.vertices.size());
  report.patches = std::uint32_t(contents.patches.size());
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
  result.report.warnings = source.warnings;
  auto parts = run_passes(source, recipe, settings, result.report);
  if (!parts) return tl::unexpected(parts.error());
  const AssetContents contents = timed(result.report, "pack", [&] { return pack(*parts, source, recipe, settings); });
  result.asset = timed(result.report, "write", [&] { return write_asset(contents); });
  fill_report(*parts, contents, result.report);
  if (auto ok = check_written(source, result.asset); !ok) return tl::unexpected(ok.error());
  return result;
}

}  // namespace coif
