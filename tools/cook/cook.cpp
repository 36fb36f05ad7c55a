#include "cook/cook.h"

#include "cook/bake_dynamics.h"
#include "cook/bake_textures.h"
#include "cook/build_skeleton.h"
#include "cook/extract_patches.h"
#include "cook/fit_chains.h"
#include "cook/fit_head.h"
#include "cook/make_lods.h"
#include "cook/pack_mesh.h"
#include "cook/pack_skeleton.h"
#include "cook/select_hair.h"
#include "cook/settle_colliders.h"
#include "cook/skin_weights.h"
#include "cook/smooth_normals.h"
#include "cook/sort_patches.h"
#include "cook/split_shells.h"
#include "cook/spring_colliders.h"
#include "cook/strand_direction.h"
#include "cook/weld.h"
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

constexpr double kBackwards = 0.5;     ///< Share of the mean strand along -Z.
constexpr double kWidestPatch = 0.75;  ///< Of the head's radius: what hides its own back half cannot be sorted as one.

/// Runs passes one after the other, announces each and notes its time.
class PassTimer {
 public:
  PassTimer(const CookSettings& settings, CookReport& report) : settings_(settings), report_(report) {}

  template <typename Pass>
  auto operator()(const char* name, const Pass& pass) const {
    if (settings_.progress) settings_.progress(name);
    const auto start = std::chrono::steady_clock::now();
    auto result = pass();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    report_.passes.push_back({name, elapsed.count()});
    return result;
  }

 private:
  const CookSettings& settings_;
  CookReport& report_;
};

/// What each pass made; the input of packing.
struct CookedParts {
  SelectedHair selected;
  HeadBone head_bone;
  FittedHead head;
  ExtractedPatches extracted;
  StrandField strands;
  ShellSplit split;
  Skeleton skeleton;
  SkinWeights weights;
  Colliders colliders;
  BakedDynamics dynamics;
  PatchOrder order;
  DetailLevels lods;
  BaseColor base_color;
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

StrandField find_strands(const SourceModel& source, const Recipe& recipe, const CookSettings& settings,
                         const CookedParts& parts) {
  const HairMesh& mesh = parts.selected.mesh;
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, recipe.patch_weld_distance);
  const std::vector<float> depths = depths_below(source, parts.head_bone.node);
  StrandSettings strands;
  strands.root = recipe.strand_root;
  strands.trust_texture = parts.extracted.chosen != "position";
  strands.depth_of_node = depths;
  strands.threads = settings.threads;
  return find_strand_direction(mesh, place, parts.extracted.patches, parts.head, strands);
}

/// Hair hangs. Where nearly all of it runs straight backwards the file was more likely written with Z up.
void warn_of_up_axis(const StrandField& strands, CookReport& report) {
  if (strands.mean.z() > -kBackwards || strands.mean.y() < -0.5 * kBackwards) return;
  report.warnings.push_back(
      "most strands run horizontally, along -Z; if the hair hangs in the modeller, the file has Z up: set "
      "\"source.up_axis\": \"z\" in the recipe");
}

/// Splits patches that are too wide to be drawn at once; their parts get vertices of their own.
ShellSplit divide_shells(const Recipe& recipe, CookedParts& parts) {
  HairMesh& mesh = parts.selected.mesh;
  const double widest = recipe.patch_widest > 0 ? recipe.patch_widest : kWidestPatch * parts.head.radii.mean();
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, recipe.patch_weld_distance);
  const ShellSplit split = split_shells(mesh, place, parts.strands, widest, parts.extracted.patches);
  const std::vector<std::uint32_t> original = separate_patches(mesh, parts.extracted.patches);
  parts.strands.append_copies(original);
  return split;
}

/// The file's own colliders where its springs use any that the head carries, else the head as fitted.
Colliders settle_colliders(const SourceModel& source, const Recipe& recipe, const CookedParts& parts,
                           CookReport& report) {
  Colliders colliders = head_colliders(parts.head, parts.skeleton, recipe);
  if (recipe.dynamics_source != "curves" && recipe.head_shape == "auto" && !parts.head.declared) {
    SpringColliders springs = spring_colliders(source, parts.head_bone.node, parts.skeleton);
    append(report.left_out, springs.left_out);
    if (!springs.colliders.shapes.empty()) {
      colliders = std::move(springs.colliders);
      report.notes.push_back(
          fmt::format("colliders: {} of the file's spring bones on the head", colliders.shapes.size()));
    }
  }
  drop_colliders_out_of_reach(parts.skeleton, colliders);
  report_rest_penetration(parts.skeleton, colliders);
  return colliders;
}

bool wants_fitted_chains(const Skeleton& skeleton, const Recipe& recipe) {
  return recipe.chain_source == "fit" || (recipe.chain_source == "auto" && skeleton.chains.empty());
}

/// The file's skeleton, or the head alone for chains to be fitted to.
tl::expected<void, ToolError> rig(const SourceModel& source, const Recipe& recipe, const PassTimer& timed,
                                  CookReport& report, CookedParts& parts) {
  const HairMesh& mesh = parts.selected.mesh;
  auto skeleton = timed("skeleton", [&] { return build_skeleton(source, mesh, parts.head_bone, recipe); });
  if (!skeleton) return tl::unexpected(skeleton.error());
  parts.skeleton = std::move(*skeleton);
  if (!wants_fitted_chains(parts.skeleton, recipe)) {
    parts.weights = weights_of_source(mesh, parts.skeleton);
    return {};
  }
  FittedRig fitted = timed("chains", [&] {
    return fit_chains(source, mesh, parts.strands, parts.head, head_alone(source, parts.head_bone), recipe);
  });
  parts.skeleton = std::move(fitted.skeleton);
  parts.weights = std::move(fitted.weights);
  append(report.notes, fitted.notes);
  return {};
}

DetailLevels find_lods(const Recipe& recipe, const CookSettings& settings, const CookedParts& parts) {
  const HairMesh& mesh = parts.selected.mesh;
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, recipe.patch_weld_distance);
  return make_lods(mesh, place, parts.extracted.patches, parts.skeleton, parts.weights, parts.head,
                   alpha_test(parts.base_color, parts.textures.transparency, recipe),
                   lod_settings(recipe, settings.threads));
}

tl::expected<CookedParts, ToolError> run_passes(const SourceModel& source, const Recipe& recipe,
                                                const CookSettings& settings, const PassTimer& timed,
                                                CookReport& report) {
  CookedParts parts;
  auto selected = timed("select", [&] { return select_hair(source, recipe); });
  if (!selected) return tl::unexpected(selected.error());
  parts.selected = std::move(*selected);
  HairMesh& mesh = parts.selected.mesh;
  auto base_color = timed("base color", [&] { return find_base_color(source, mesh, recipe, settings); });
  if (!base_color) return tl::unexpected(base_color.error());
  parts.base_color = std::move(*base_color);
  auto head_bone = timed("head bone", [&] { return find_head_bone(source, mesh, recipe.head_bone); });
  if (!head_bone) return tl::unexpected(head_bone.error());
  parts.head_bone = std::move(*head_bone);
  parts.head = timed("head", [&] { return fit_head(source, mesh, parts.selected.meshes, parts.head_bone, recipe); });
  if (parts.head_bone.node == kNoIndex) parts.head_bone.joint = parts.head.center;
  parts.extracted = timed("patches", [&] {
    const std::vector<std::uint32_t> place = weld_places(mesh.positions, recipe.patch_weld_distance);
    ExtractedPatches extracted = extract_patches(mesh, place, recipe.patch_connectivity);
    separate_patches(mesh, extracted.patches);
    return extracted;
  });
  timed("normals", [&] { return complete_normals(mesh, recipe.patch_weld_distance); });
  parts.strands = timed("strands", [&] { return find_strands(source, recipe, settings, parts); });
  warn_of_up_axis(parts.strands, report);
  parts.split = timed("shells", [&] { return divide_shells(recipe, parts); });
  if (auto ok = rig(source, recipe, timed, report, parts); !ok) return tl::unexpected(ok.error());
  parts.colliders = timed("colliders", [&] { return settle_colliders(source, recipe, parts, report); });
  parts.dynamics = timed("dynamics", [&] { return bake_dynamics(source, parts.skeleton, recipe); });
  parts.order = timed("order", [&] { return sort_patches(mesh, parts.extracted.patches, parts.head.center); });
  auto textures =
      timed("textures", [&] { return bake_textures(parts.base_color, mesh, parts.strands.along_u, recipe, settings); });
  if (!textures) return tl::unexpected(textures.error());
  parts.textures = std::move(*textures);
  parts.lods = timed("lods", [&] { return find_lods(recipe, settings, parts); });
  return parts;
}

AssetContents pack(CookedParts& parts, const SourceModel& source, const Recipe& recipe, const CookSettings& settings) {
  const HairMesh& mesh = parts.selected.mesh;
  AssetContents contents;
  pack_skeleton(parts.skeleton, parts.colliders, contents);
  pack_mesh(mesh, parts.lods.levels, parts.order, parts.strands, parts.head_bone.joint, parts.weights, contents);
  contents.dynamics = parts.dynamics.records;
  for (std::size_t b = 0; b < parts.colliders.hit_radius.size() && b < contents.dynamics.size(); ++b) {
    contents.dynamics[b].hit_radius = float(parts.colliders.hit_radius[b]);
  }
  contents.material = {pack_material(parts.base_color, parts.textures.transparency, mesh, recipe)};
  contents.textures = parts.textures.records;
  contents.texels = std::move(parts.textures.texels);
  contents.provenance = {make_provenance(source, recipe, settings)};
  return contents;
}

void fill_report(const CookedParts& parts, const AssetContents& contents, CookReport& report) {
  append(report.warnings, parts.selected.warnings);
  append(report.warnings, parts.skeleton.warnings);
  append(report.warnings, parts.colliders.warnings);
  report.notes.insert(report.notes.begin(), parts.selected.notes.begin(), parts.selected.notes.end());
  append(report.notes, parts.colliders.notes);
  append(report.warnings, parts.dynamics.warnings);
  append(report.notes, parts.dynamics.notes);
  append(report.warnings, parts.base_color.warnings);
  append(report.warnings, parts.textures.transparency.warnings);
  append(report.notes, parts.base_color.notes);
  append(report.notes, parts.textures.transparency.notes);
  append(report.left_out, parts.selected.left_out);
  append(report.left_out, parts.textures.left_out);
  report.triangles = std::uint32_t(parts.lods.levels[0].triangle_count());
  report.vertices = std::uint32_t(contents.vertices.size());
  report.patches = std::uint32_t(parts.lods.levels[0].patch_count());
  append(report.notes, parts.lods.notes);
  report.notes.push_back(fmt::format("patches {}", parts.extracted.reason));
  report.notes.push_back(parts.strands.reason);
  if (parts.split.shells > 0) {
    report.notes.push_back(fmt::format("{} patches too wide to sort were cut along the strands into {}",
                                       parts.split.shells, parts.split.parts));
  }
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
  const PassTimer timed(settings, result.report);
  result.report.warnings = source.warnings;
  auto parts = run_passes(source, recipe, settings, timed, result.report);
  if (!parts) return tl::unexpected(parts.error());
  const AssetContents contents = timed("pack", [&] { return pack(*parts, source, recipe, settings); });
  result.asset = timed("write", [&] { return write_asset(contents); });
  fill_report(*parts, contents, result.report);
  if (auto ok = check_written(source, result.asset); !ok) return tl::unexpected(ok.error());
  return result;
}

}  // namespace coif
