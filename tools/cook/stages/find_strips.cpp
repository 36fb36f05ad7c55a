#include "cook/stages/stages.h"

#include "cook/select/mesh_topology.h"
#include "cook/strands/choose_patches.h"
#include "cook/strands/patches.h"
#include "cook/strands/strand_direction.h"
#include "cook/texture/strand_lines.h"

namespace coif::cook {
namespace {

using Done = tl::expected<void, ToolError>;

/// Finds the patches, and the recipe's values for some of them.
Done find_all_patches(const importer::SourceModel& source, const HairRecipe& welding, const StripRecipe& recipe,
                      bool lists_patches, Strips& strips, CookLog& log) {
  HairStrips& hair = strips.hair;
  log.pass("places", [&] { hair.welded = weld_places(hair.mesh.positions, welding.patch_weld_distance); });
  log.pass("patches", [&] {
    strips.extracted = find_patches(hair, recipe.patch_connectivity, log.findings());
    warn_of_fragments(hair.mesh, strips.extracted.patches.count, strips.extracted.chosen, log.findings());
  });
  if (lists_patches || !recipe.patch_overrides.empty()) {
    const Done chosen = log.pass("overrides", [&] {
      strips.listings = list_patches(source, hair);
      return choose_patches(source, recipe, lists_patches, hair, strips.listings, log.findings());
    });
    if (!chosen) return chosen;
  }
  if (strips.extracted.chosen != Connectivity::kPosition) {
    log.pass("folds", [&] { (void)split_folds(hair, log.findings()); });
  }
  return {};
}

/// The head that the hair grows on.
Done find_head(const importer::SourceModel& source, const HairRecipe& recipe, const std::stop_token& stop,
               Strips& strips, CookLog& log) {
  const HairMesh& mesh = strips.hair.mesh;
  auto bone = log.pass("head bone", [&] { return find_head_bone(source, mesh, recipe.head_bone); });
  if (!bone) return tl::unexpected(bone.error());
  strips.head_bone = std::move(*bone);
  log.pass("head", [&] {
    strips.head = fit_head(source, mesh, strips.head_bone, recipe, log.findings(), stop);
    strips.head.faces_backwards = faces_backwards(source, mesh, strips.head, recipe, log.findings());
    if (strips.head_bone.node == importer::kNoIndex) strips.head_bone.joint = strips.head.center;
  });
  return {};
}

/// Finds the direction of the strands.
class StrandFinder {
 public:
  StrandFinder(const importer::SourceModel& source, const BaseColor& color, const StripRecipe& recipe,
               const platform::Threads& threads)
      : source_(source), color_(color), recipe_(recipe), threads_(threads) {}

  void find(Strips& strips, Findings& findings) const {
    HairStrips& hair = strips.hair;
    Findings of_whole;
    hair.strands = strands_of(strips, of_whole);
    if (split_partings(hair, strips.head, said_roots(hair), findings) > 0) {
      hair.strands = strands_of(strips, findings);
    } else {
      findings.append(of_whole);
    }
  }

 private:
  /// The roots that the recipe, the source or a map declares.
  [[nodiscard]] std::vector<std::string> said_roots(const HairStrips& hair) const {
    std::vector<std::string> roots = declared_roots(recipe_, source_, hair);
    if (color_.root_to_tip) read_root_to_tip(hair, *color_.root_to_tip, roots);
    return roots;
  }

  [[nodiscard]] StrandField strands_of(const Strips& strips, Findings& findings) const {
    const StrandSettings settings{.roots = said_roots(strips.hair),
                                  .trust_texture = strips.extracted.chosen != Connectivity::kPosition,
                                  .depth_of_node = depths_below(source_, strips.head_bone.node),
                                  .seen = find_strand_lines(strips.hair, color_, threads_),
                                  .threads = threads_};
    return find_strand_direction(strips.hair, strips.head, settings, findings);
  }

  const importer::SourceModel& source_;
  const BaseColor& color_;
  const StripRecipe& recipe_;
  platform::Threads threads_;
};

}  // namespace

tl::expected<Strips, ToolError> find_strips(const importer::SourceModel& source, HairMesh hair, const BaseColor& color,
                                            const HairRecipe& of_head, const StripRecipe& recipe,
                                            const CookSettings& settings, CookLog& log) {
  Strips strips;
  strips.hair.mesh = std::move(hair);
  Done done = find_all_patches(source, of_head, recipe, settings.list_patches, strips, log);
  if (done) done = find_head(source, of_head, settings.threads.stop, strips, log);
  if (done) {
    done = log.pass("face hair",
                    [&] { return choose_face_hair(source, recipe, strips.head, strips.hair, log.findings()); });
  }
  if (!done) return tl::unexpected(done.error());

  log.pass("normals", [&] { strips.hair.complete_normals(); });
  const StrandFinder strands(source, color, recipe, settings.threads);
  log.pass("strands", [&] { strands.find(strips, log.findings()); });
  log.pass("shells", [&] {
    split_shells(strips.hair, widest_patch(recipe, strips.head), log.findings(), settings.threads.stop);
  });
  return strips;
}

}  // namespace coif::cook
