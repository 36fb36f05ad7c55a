#include "cook/cook.h"

#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/order/choose_order.h"
#include "cook/pack/pack.h"
#include "cook/rig/colliders.h"
#include "cook/rig/fit_chains.h"
#include "cook/rig/skeleton.h"
#include "cook/select/mesh_topology.h"
#include "cook/strands/patches.h"
#include "cook/texture/alpha.h"
#include "cook/texture/hair_views.h"
#include "lab/rig.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <new>

namespace coif {
namespace {

constexpr double kBackwards = 0.5;     ///< Share of the mean strand along -Z.
constexpr double kWidestPatch = 0.75;  ///< Of the head's radius: what hides its own back half cannot be sorted as one.

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void append(std::vector<LeftOut>& to, const std::vector<LeftOut>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

class CookRun {
 public:
  CookRun(const SourceModel& source, const Recipe& recipe, const CookSettings& settings, CookReport& report)
      : source_(source), recipe_(recipe), settings_(settings), report_(report) {}

  tl::expected<CookedParts, ToolError> run() {
    using Stage = tl::expected<void, ToolError> (CookRun::*)();
    for (const Stage stage : {&CookRun::find_hair, &CookRun::find_head, &CookRun::find_patches, &CookRun::find_bones,
                              &CookRun::find_motion, &CookRun::find_looks}) {
      if (auto ok = (this->*stage)(); !ok) return tl::unexpected(ok.error());
    }
    return std::move(parts_);
  }

 private:
  using Done = tl::expected<void, ToolError>;

  template <typename Pass>
  auto timed(const char* name, const Pass& pass) {
    return run_timed(settings_, report_, name, pass);
  }

  HairMesh& mesh() { return parts_.selected.mesh; }

  Done find_hair() {
    auto selected = timed("select", [&] { return select_hair(source_, recipe_); });
    if (!selected) return tl::unexpected(selected.error());
    parts_.selected = std::move(*selected);
    append(report_.notes, parts_.selected.notes);
    append(report_.left_out, parts_.selected.left_out);
    append(report_.warnings, parts_.selected.warnings);
    // Joining textures moves texture coordinates and splits vertices, so it comes before anything that numbers them.
    auto color = timed("base color", [&] { return find_base_color(source_, mesh(), recipe_, settings_); });
    if (!color) return tl::unexpected(color.error());
    parts_.base_color = std::move(*color);
    append(report_.notes, parts_.base_color.notes);
    append(report_.warnings, parts_.base_color.warnings);
    return {};
  }

  Done find_head() {
    auto bone = timed("head bone", [&] { return find_head_bone(source_, mesh(), recipe_.head_bone); });
    if (!bone) return tl::unexpected(bone.error());
    parts_.head_bone = std::move(*bone);
    parts_.head =
        timed("head", [&] { return fit_head(source_, mesh(), parts_.selected.meshes, parts_.head_bone, recipe_); });
    if (parts_.head_bone.node == kNoIndex) parts_.head_bone.joint = parts_.head.center;
    report_.notes.push_back(fmt::format("head: {}; moved by '{}'", parts_.head.origin, parts_.head_bone.name));
    return {};
  }

  Done find_patches() {
    parts_.place = timed("places", [&] { return weld_places(mesh().positions, recipe_.patch_weld_distance); });
    parts_.extracted = timed("patches", [&] {
      ExtractedPatches extracted = extract_patches(mesh(), parts_.place, recipe_.patch_connectivity);
      follow_copies(separate_patches(mesh(), extracted.patches));
      return extracted;
    });
    report_.notes.push_back(fmt::format("patches {}", parts_.extracted.reason));
    timed("normals", [&] { return complete_normals(mesh(), parts_.place); });
    parts_.strands = timed("strands", [&] { return find_strands(); });
    report_.notes.push_back(parts_.strands.reason);
    warn_of_up_axis();
    const ShellSplit split = timed("shells", [&] { return divide_shells(); });
    if (split.shells == 0) return {};
    report_.notes.push_back(fmt::format("patches: {} too wide to sort, cut along the strands into {}{}", split.shells,
                                        split.parts,
                                        split.left == 0 ? "" : fmt::format("; {} are still too wide", split.left)));
    return {};
  }

  StrandField find_strands() {
    const std::vector<float> depths = depths_below(source_, parts_.head_bone.node);
    StrandSettings strands;
    strands.root = recipe_.strand_root;
    strands.trust_texture = parts_.extracted.chosen != "position";
    strands.depth_of_node = depths;
    strands.threads = settings_.threads;
    return find_strand_direction(mesh(), parts_.place, parts_.extracted.patches, parts_.head, strands);
  }

  /// Hair hangs. Where nearly all of it runs straight backwards the file was more likely written with Z up.
  void warn_of_up_axis() {
    const Eigen::Vector3d& mean = parts_.strands.mean;
    if (mean.z() > -kBackwards || mean.y() < -0.5 * kBackwards) return;
    report_.warnings.emplace_back(
        "most strands run horizontally, along -Z; if the hair hangs in the modeller, the file has Z up: set "
        "\"source.up_axis\": \"z\" in the recipe");
  }

  /// Splits patches that are too wide to be drawn at once; their parts get vertices of their own.
  ShellSplit divide_shells() {
    const double widest = recipe_.patch_widest > 0 ? recipe_.patch_widest : kWidestPatch * parts_.head.radii.mean();
    const ShellSplit split = split_shells(mesh(), parts_.place, parts_.strands, widest, parts_.extracted.patches);
    const std::vector<std::uint32_t> originals = separate_patches(mesh(), parts_.extracted.patches);
    parts_.strands.append_copies(originals);
    follow_copies(originals);
    return split;
  }

  void follow_copies(const std::vector<std::uint32_t>& originals) {
    for (const std::uint32_t v : originals) parts_.place.push_back(std::uint32_t(parts_.place[v]));
  }

  /// The file's skeleton, or the head alone, with or without chains fitted to it.
  Done find_bones() {
    auto skeleton = timed("skeleton", [&] { return build_skeleton(source_, mesh(), parts_.head_bone, recipe_); });
    if (!skeleton) return tl::unexpected(skeleton.error());
    const bool none_in_file = skeleton->chains.empty();
    if (recipe_.chain_source == "fit" || (recipe_.chain_source == "auto" && none_in_file)) {
      fit_bones();
    } else {
      parts_.skeleton = recipe_.chain_source == "none" ? head_alone(source_, parts_.head_bone) : std::move(*skeleton);
      parts_.weights = weights_of_source(mesh(), parts_.skeleton);
    }
    if (!recipe_.scene_simulate) {
      append(report_.left_out,
             leave_out_motion(head_alone(source_, parts_.head_bone), parts_.skeleton, parts_.weights));
    }
    const std::vector<std::uint32_t> moved_to = order_bones(parts_.skeleton);
    for (auto& of_vertex : parts_.weights) {
      for (BoneWeight& weight : of_vertex) weight.bone = moved_to[weight.bone];
    }
    append(report_.warnings, parts_.skeleton.warnings);
    return {};
  }

  void fit_bones() {
    FittedRig fitted = timed("chains", [&] {
      return fit_chains(source_, mesh(), parts_.place, parts_.strands, parts_.head,
                        head_alone(source_, parts_.head_bone), recipe_);
    });
    parts_.skeleton = std::move(fitted.skeleton);
    parts_.weights = std::move(fitted.weights);
    append(report_.notes, fitted.notes);
  }

  Done find_motion() {
    parts_.colliders = timed("colliders", [&] { return settle_colliders(); });
    // Hair that nothing moves keeps its head: pictures show it.
    if (parts_.skeleton.simulated_count() > 0) append(report_.left_out, leave_out_colliders(parts_.colliders));
    append(report_.notes, parts_.colliders.notes);
    append(report_.warnings, parts_.colliders.warnings);
    parts_.dynamics = timed("dynamics", [&] { return bake_dynamics(source_, parts_.skeleton, recipe_); });
    append(report_.notes, parts_.dynamics.notes);
    append(report_.warnings, parts_.dynamics.warnings);
    return settle_dynamics();
  }

  /// Makes each chain's equation one that has a solution, then looks for the cheapest way to solve it.
  Done settle_dynamics() {
    std::vector<DynamicsRecord>& dynamics = parts_.dynamics.records;
    for (std::size_t b = 0; b < parts_.colliders.hit_radius.size() && b < dynamics.size(); ++b) {
      dynamics[b].hit_radius = float(parts_.colliders.hit_radius[b]);
    }
    if (parts_.skeleton.chains.empty()) return {};
    AssetContents rig;
    pack_skeleton(parts_.skeleton, parts_.colliders, rig);
    rig.dynamics = dynamics;
    if (!OpenedAsset(rig).asset().is_open())
      return {};  // numbers that no asset may hold: the check after packing says which
    if (recipe_.conditioning != "off") {
      ConditionedChains settled = timed("conditioning", [&] { return condition_chains(rig, settings_.threads); });
      append(report_.notes, settled.notes);
      append(report_.warnings, settled.warnings);
      rig.dynamics = dynamics = std::move(settled.dynamics);
    }
    if (!recipe_.torsion) {
      ChosenTwist twist = timed("twist", [&] { return choose_twist(rig, settings_.threads); });
      append(report_.notes, twist.notes);
      append(report_.left_out, twist.left_out);
      rig.dynamics = dynamics = std::move(twist.dynamics);
    }
    auto tuned = timed("tuning", [&] { return tune_solver(rig, recipe_, settings_.threads); });
    if (!tuned) return tl::unexpected(ToolError{tuned.error().kind, source_.path + ": " + tuned.error().message});
    parts_.tuned = std::move(*tuned);
    append(report_.notes, parts_.tuned.notes);
    return {};
  }

  /// The file's own colliders where its springs use any that the head carries, else the head as fitted.
  Colliders settle_colliders() {
    Colliders colliders = head_colliders(parts_.head, parts_.skeleton, recipe_);
    if (recipe_.dynamics_source != "curves" && recipe_.head_shape == "auto" && !parts_.head.declared) {
      SpringColliders springs = spring_colliders(source_, parts_.head_bone.node, parts_.skeleton);
      append(report_.left_out, springs.left_out);
      if (!springs.colliders.shapes.empty()) {
        colliders = std::move(springs.colliders);
        colliders.notes.push_back(
            fmt::format("colliders: {} of the file's spring bones on the head", colliders.shapes.size()));
      }
    }
    drop_colliders_out_of_reach(parts_.skeleton, colliders);
    report_rest_penetration(parts_.skeleton, colliders);
    return colliders;
  }

  Done find_looks() {
    parts_.order = timed("order", [&] { return sort_patches(mesh(), parts_.extracted.patches, parts_.head.center); });
    auto textures = timed("textures", [&] {
      return bake_textures(parts_.base_color, mesh(), parts_.strands.along_u, recipe_, settings_);
    });
    if (!textures) return tl::unexpected(textures.error());
    parts_.textures = std::move(*textures);
    append(report_.notes, parts_.textures.transparency.notes);
    append(report_.warnings, parts_.textures.transparency.warnings);
    append(report_.left_out, parts_.textures.left_out);
    append(report_.warnings, timed("tips", [&] { return find_hard_ends(); }).warnings);
    parts_.lods = timed("lods", [&] {
      return make_lods(mesh(), parts_.place, parts_.extracted.patches, parts_.skeleton, parts_.weights, parts_.head,
                       alpha_test(parts_.base_color, parts_.textures.transparency, recipe_),
                       lod_settings(recipe_, settings_.threads));
    });
    append(report_.notes, parts_.lods.notes);
    append(report_.left_out, leave_out_levels(recipe_, parts_.lods));
    return {};
  }

  HardTips find_hard_ends() {
    AlphaTest opaque = alpha_test(parts_.base_color, parts_.textures.transparency, recipe_);
    opaque.threshold = parts_.textures.transparency.opaque_threshold;
    return find_hard_tips(mesh(), parts_.place, parts_.extracted.patches, parts_.strands, parts_.head, opaque,
                          settings_.threads);
  }

  const SourceModel& source_;
  const Recipe& recipe_;
  const CookSettings& settings_;
  CookReport& report_;
  CookedParts parts_;
};

}  // namespace

tl::expected<CookedParts, ToolError> run_passes(const SourceModel& source, const Recipe& recipe,
                                                const CookSettings& settings, CookReport& report) {
  return CookRun(source, recipe, settings, report).run();
}

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
