#include "cook/stages/stages.h"

#include "cook/lods/make_lods.h"
#include "cook/pack/pack.h"
#include "cook/texture/alpha.h"
#include "cook/texture/compressed_color.h"
#include "cook/texture/patch_coverage.h"
#include "cook/texture/vertex_colors.h"

namespace coif::cook {
namespace {

using Done = tl::expected<void, ToolError>;

class HairDrawer {
 public:
  HairDrawer(const importer::SourceModel& source, BaseColor color, Strips strips, CookedRig rig,
             const DrawnRecipe& recipe, const CookSettings& settings, CookLog& log)
      : source_(source),
        color_(std::move(color)),
        recipe_(recipe),
        settings_(settings),
        log_(log),
        findings_(log.findings()),
        drawn_{std::move(strips), std::move(rig.rig), std::move(rig.contents), {}, {}, {}, {}} {}

  tl::expected<Drawn, ToolError> draw(const SceneRecipe& scene) {
    // Before textures, which keep only what some triangle shows.
    if (has_card_levels(source_, drawn_.strips.hair)) {
      log_.pass("card levels", [&] {
        drawn_.levels = card_levels(source_, drawn_.strips.hair, drawn_.rig, drawn_.strips.head, lods(), findings_);
      });
    }
    if (const Done done = bake_looks(); !done) return tl::unexpected(done.error());
    make_levels();
    log_.pass("head order", [&] { drawn_.order = sort_patches(drawn_.strips.hair, drawn_.strips.head.center); });
    log_.pass("pack", [&] { pack(); });
    if (const Done done = order(scene.scene_draw); !done) return tl::unexpected(done.error());
    // After draw orders, since the threshold in use decides how much alpha the mips need.
    log_.pass("mips", [&] { keep_coverage(drawn_.textures.used, drawn_.contents); });
    // Last, since all before read colours and alphas.
    log_.pass("blocks", [&] { compress_color(recipe_, settings_.threads, drawn_.contents, findings_); });
    return std::move(drawn_);
  }

 private:
  [[nodiscard]] LodSettings lods() const { return lod_settings(recipe_, settings_.threads); }

  /// The strips' colours and their transparency.
  Done bake_looks() {
    if (!drawn_.strips.hair.mesh.colors.empty()) {
      log_.pass("vertex colors",
                [&] { keep_vertex_colors(texture_limit(recipe_), color_, drawn_.strips.hair.mesh, findings_); });
    }
    auto textures =
        log_.pass("textures", [&] { return bake_textures(color_, drawn_.strips.hair, recipe_, settings_, findings_); });
    if (!textures) return tl::unexpected(textures.error());
    drawn_.textures = std::move(*textures);
    // Cards end as their strands do.
    if (!source_.made_from_strands) log_.pass("tips", [&] { look_at_tips(); });
    return {};
  }

  void look_at_tips() const {
    AlphaTest opaque = alpha_test(color_, drawn_.textures.transparency, recipe_);
    opaque.threshold = drawn_.textures.transparency.opaque_threshold;
    (void)find_blunt_ends(drawn_.strips.hair, drawn_.strips.head, opaque, settings_.threads, findings_);
  }

  void make_levels() {
    log_.pass("lods", [&] {
      const AlphaTest alpha = alpha_test(color_, drawn_.textures.transparency, recipe_);
      if (drawn_.levels.empty())
        drawn_.levels = make_lods(drawn_.strips.hair, drawn_.rig, drawn_.strips.head, alpha, lods(), findings_);
      leave_out_levels(recipe_, drawn_.levels, findings_);
    });
  }

  /// Moves the texels out of the textures.
  void pack() {
    AssetContents& contents = drawn_.contents;
    BakedTextures& textures = drawn_.textures;
    pack_mesh(drawn_.strips.hair, drawn_.rig, drawn_.levels, drawn_.order, contents);
    contents.material = {pack_material(color_, textures, drawn_.strips.hair.mesh, recipe_)};
    contents.textures = textures.stored.records;
    contents.texels = std::move(textures.stored.texels);
    contents.reliefs = textures.relief.records;
    contents.relief_texels = std::move(textures.relief.texels);
  }

  Done order(bool is_drawn) {
    AssetContents& contents = drawn_.contents;
    if (is_drawn) {
      log_.pass("soft body", [&] { bake_normals(contents, findings_); });
      log_.pass("occlusion", [&] { bake_occlusion(recipe_, settings_.threads, contents, findings_); });
    }
    // With the threshold from before a search for orders, so that the message does not depend on the search.
    log_.pass("coverage", [&] { judge_coverage(); });
    auto figures = log_.pass("draw order", [&]() -> tl::expected<OrderFigures, ToolError> {
      if (!is_drawn) return {};
      return choose_order(recipe_, drawn_.textures.used, settings_.threads, contents, findings_);
    });
    if (!figures) return tl::unexpected(figures.error());
    drawn_.figures = *figures;
    return {};
  }

  /// Reports the coverage of mips with the present thresholds; does not change them.
  void judge_coverage() {
    AssetContents& contents = drawn_.contents;
    const auto texels = contents.texels;
    keep_coverage(drawn_.textures.used, contents);
    report_coverage(drawn_.textures.used, contents, findings_);
    contents.texels = texels;
  }

  const importer::SourceModel& source_;
  BaseColor color_;
  const DrawnRecipe& recipe_;
  const CookSettings& settings_;
  CookLog& log_;
  Findings& findings_;
  Drawn drawn_;
};

}  // namespace

tl::expected<Drawn, ToolError> draw_hair(const importer::SourceModel& source, BaseColor color, Strips strips,
                                         CookedRig rig, const DrawnRecipe& recipe, const SceneRecipe& scene,
                                         const CookSettings& settings, CookLog& log) {
  return HairDrawer(source, std::move(color), std::move(strips), std::move(rig), recipe, settings, log).draw(scene);
}

}  // namespace coif::cook
