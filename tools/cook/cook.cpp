#include "cook/cook.h"

#include "base/work_limit.h"
#include "cook/cooking.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/bake_limits.h"
#include "cook/dynamics/bake_links.h"
#include "cook/dynamics/settle_model.h"
#include "cook/dynamics/tied_chains.h"
#include "cook/lods/card_levels.h"
#include "cook/lods/make_lods.h"
#include "cook/rig/fit_chains.h"
#include "cook/select/mesh_topology.h"
#include "cook/select/select_hair.h"
#include "cook/size/settle_size.h"
#include "cook/strands/odd_hair.h"
#include "cook/strands/strand_direction.h"
#include "cook/texture/alpha.h"
#include "cook/texture/patch_coverage.h"
#include "cook/texture/strand_lines.h"
#include "cook/texture/vertex_colors.h"

#include <algorithm>
#include <chrono>

namespace coif {
namespace {

using Done = tl::expected<void, ToolError>;

struct Pass {
  const char* name;  ///< In progress and report; each once.
  Done (*run)(Cooking&);
  bool (*wanted)(const Cooking&) = nullptr;  ///< Null: always.
};

template <typename Part>
Done keep(Part made, Part& part) {
  part = std::move(made);
  return {};
}

template <typename Part>
Done keep(tl::expected<Part, ToolError> made, Part& part) {
  if (!made) return tl::unexpected(made.error());
  return keep(std::move(*made), part);
}

/// What the recipe, the source or a map says of roots.
std::vector<std::string> said_roots(const Cooking& c) {
  std::vector<std::string> roots = declared_roots(c.recipe, c.source, c.hair);
  if (c.color.root_to_tip) read_root_to_tip(c.hair, *c.color.root_to_tip, roots);
  return roots;
}

StrandField find_strands(const Cooking& c, Findings& findings) {
  const StrandSettings settings{said_roots(c), c.extracted.chosen != "position",
                                depths_below(c.source, c.head_bone.node),
                                find_strand_lines(c.hair, c.color, c.settings.threads), c.settings.threads};
  return find_strand_direction(c.hair, c.head, settings, findings);
}

/// The whole cook, top to bottom. Passes are functions of what came before; what they have to say goes to the report.
const Pass kPasses[] = {
    // The hair, out of the model and with one texture. Joining textures moves texture coordinates and splits vertices, so
    // it comes before anything that numbers them.
    {"select",
     [](Cooking& c) {
       if (!c.selected) return keep(select_hair(c.source, c.recipe, c.report), c.hair.mesh);
       c.report.append(c.selected->findings);
       return keep(std::move(c.selected->mesh), c.hair.mesh);
     }},
    {"base color",
     [](Cooking& c) {
       warn_of_odd_size(c.hair.mesh, c.report);
       return keep(find_base_color(c.source, c.hair.mesh, c.recipe, c.settings, c.report), c.color);
     }},

    // Its strips, and what the recipe says of some of them alone.
    {"places",
     [](Cooking& c) { return keep(weld_places(c.hair.mesh.positions, c.recipe.patch_weld_distance), c.hair.welded); }},
    {"patches",
     [](Cooking& c) -> Done {
       c.extracted = find_patches(c.hair, c.recipe.patch_connectivity, c.report);
       warn_of_fragments(c.hair.mesh, c.extracted.patches.count, c.extracted.chosen, c.report);
       return {};
     }},
    {"overrides",
     [](Cooking& c) {
       c.listings = list_patches(c.source, c.hair);
       return choose_patches(c.source, c.recipe, c.settings.list_patches, c.hair, c.listings, c.report);
     },
     [](const Cooking& c) { return c.settings.list_patches || !c.recipe.patch_overrides.empty(); }},
    {"folds",
     [](Cooking& c) -> Done {
       (void)split_folds(c.hair, c.report);
       return {};
     },
     [](const Cooking& c) { return c.extracted.chosen != "position"; }},

    // The head that it grows on.
    {"head bone",
     [](Cooking& c) { return keep(find_head_bone(c.source, c.hair.mesh, c.recipe.head_bone), c.head_bone); }},
    {"head",
     [](Cooking& c) -> Done {
       c.head = fit_head(c.source, c.hair.mesh, c.head_bone, c.recipe, c.report);
       c.head.faces_backwards = faces_backwards(c.source, c.hair.mesh, c.head);
       if (c.head.faces_backwards)
         c.report.note("the model looks along -Z; pictures are taken from there, and chains named by it");
       if (c.head_bone.node == kNoIndex) c.head_bone.joint = c.head.center;
       return {};
     }},

    {"face hair", [](Cooking& c) { return choose_face_hair(c.source, c.recipe, c.head, c.hair, c.report); }},

    // Which way its strands run.
    {"normals",
     [](Cooking& c) -> Done {
       c.hair.complete_normals();
       return {};
     }},
    {"strands",
     [](Cooking& c) -> Done {
       Findings of_whole;
       c.hair.strands = find_strands(c, of_whole);
       if (split_partings(c.hair, c.head, said_roots(c), c.report) > 0) {
         c.hair.strands = find_strands(c, c.report);
       } else {
         c.report.append(of_whole);
       }
       return {};
     }},
    {"shells",
     [](Cooking& c) -> Done {
       split_shells(c.hair, widest_patch(c.recipe, c.head), c.report);
       return {};
     }},

    // What moves it: the file's bones or fitted ones, and what they must not enter.
    {"skeleton",
     [](Cooking& c) { return keep(rig_of_file(c.source, c.hair, c.head_bone, c.recipe, c.report), c.rig); }},
    {"chains",
     [](Cooking& c) { return keep(fit_chains(c.source, c.hair, c.head, c.rig.skeleton, c.recipe, c.report), c.rig); },
     [](const Cooking& c) { return wants_fitted_chains(c.recipe, c.rig.skeleton); }},
    {"colliders",
     [](Cooking& c) {
       settle_rig(c.recipe, c.rig, c.report);
       return keep(find_colliders(c.source, c.head_bone, c.head, c.rig.skeleton, c.recipe, c.report), c.colliders);
     }},
    {"body",
     [](Cooking& c) {
       return keep(find_body_colliders(c.source, c.head_bone, c.rig.skeleton, c.colliders, c.recipe, c.report), c.body);
     },
     [](const Cooking& c) {
       const bool is_any = !c.source.colliders.empty() || !c.recipe.body_colliders.empty();
       return is_any && c.rig.skeleton.simulated_count() > 0;
     }},

    // How it moves: each chain's equation becomes one that has a solution, and then gets the cheapest way to solve it.
    {"dynamics",
     [](Cooking& c) -> Done {
       const auto of_chain = chain_overrides(c.hair, c.rig, c.recipe, c.report);
       c.said = bake_dynamics(c.source, c.rig.skeleton, c.recipe, of_chain, c.report);
       const std::vector<bool> tied = find_tied_chains(c.hair, c.rig);
       loosen_tied_chains(c.rig.skeleton, tied, c.recipe, of_chain, c.said, c.report);
       c.contents.dynamics = c.said.records;
       pack_skeleton(c.rig.skeleton, c.colliders, c.contents);
       pack_body(c.rig.skeleton, c.body, c.contents);
       if (c.head.faces_backwards) c.contents.skeleton.flags |= kSkeletonFacesBackwards;
       c.contents.skeleton.air_lag = air_lag(c.recipe, c.said);
       return {};
     }},
    {"limits",
     [](Cooking& c) { return keep(bake_limits(c.source, c.rig.skeleton, c.recipe, c.report), c.contents.limits); },
     [](const Cooking& c) { return !c.source.springs.empty() || !c.recipe.limits.empty(); }},
    {"links",
     [](Cooking& c) {
       return keep(bake_links(c.source.path, c.hair, c.rig, c.contents, c.recipe, c.report), c.contents.links);
     },
     [](const Cooking& c) { return c.rig.skeleton.simulated_count() > 0; }},
    {"model",
     [](Cooking& c) -> Done {
       const bool is_checked = c.recipe.conditioning != "off" && !c.settings.draft;
       c.model = is_checked ? choose_models(c.recipe, c.said, c.contents, c.settings.threads, c.report)
                            : ModelChoice{models_by_rule(c.recipe, c.said, c.contents), {}};
       settle_model(c.recipe, c.said, c.model.models, c.contents, c.report);
       c.moves = can_be_run(c.contents);
       return {};
     }},
    {"conditioning",
     [](Cooking& c) {
       auto given = condition_chains(c.contents, c.model.ill_posed, c.settings.threads, c.report);
       c.contents.asked = asked_of(c.contents.dynamics);
       return keep(std::move(given), c.contents.dynamics);
     },
     [](const Cooking& c) { return c.moves && !c.model.ill_posed.empty(); }},
    {"twist",
     [](Cooking& c) { return keep(choose_twist(c.contents, c.settings.threads, c.report), c.contents.dynamics); },
     [](const Cooking& c) {
       const bool any_cascade = std::ranges::find(c.model.models, ChainModel::kCascade) != c.model.models.end();
       return c.moves && any_cascade && !c.recipe.torsion;
     }},
    {"tuning",
     [](Cooking& c) {
       const auto name = [&](ToolError error) { return ToolError{error.kind, c.source.path + ": " + error.message}; };
       return keep(tune_solver(c.contents, c.recipe, c.settings.threads, c.report).map_error(name), c.tuned);
     },
     [](const Cooking& c) { return c.moves && !c.settings.draft; }},

    // What it looks like, near and far.
    // Before textures, which keep what some triangle shows.
    {"card levels",
     [](Cooking& c) {
       const LodSettings settings = lod_settings(c.recipe, c.settings.threads);
       return keep(card_levels(c.source, c.hair, c.rig, c.head, settings, c.report), c.levels);
     },
     [](const Cooking& c) { return has_card_levels(c.source, c.hair); }},
    {"vertex colors",
     [](Cooking& c) -> Done {
       keep_vertex_colors(texture_limit(c.recipe), c.color, c.hair.mesh, c.report);
       return {};
     },
     [](const Cooking& c) { return !c.hair.mesh.colors.empty(); }},
    {"textures",
     [](Cooking& c) { return keep(bake_textures(c.color, c.hair, c.recipe, c.settings, c.report), c.textures); }},
    {"tips",
     [](Cooking& c) -> Done {
       AlphaTest opaque = alpha_test(c.color, c.textures.transparency, c.recipe);
       opaque.threshold = c.textures.transparency.opaque_threshold;
       (void)find_blunt_ends(c.hair, c.head, opaque, c.settings.threads, c.report);
       return {};
     },
     // Cards end as their strands do.
     [](const Cooking& c) { return !c.source.made_from_strands; }},
    {"lods",
     [](Cooking& c) -> Done {
       const AlphaTest alpha = alpha_test(c.color, c.textures.transparency, c.recipe);
       const LodSettings settings = lod_settings(c.recipe, c.settings.threads);
       if (c.levels.empty()) c.levels = make_lods(c.hair, c.rig, c.head, alpha, settings, c.report);
       leave_out_levels(c.recipe, c.levels, c.report);
       return {};
     }},
    {"head order", [](Cooking& c) { return keep(sort_patches(c.hair, c.head.center), c.order); }},
    {"pack",
     [](Cooking& c) -> Done {
       pack_parts(c);
       return {};
     }},
    {"occlusion",
     [](Cooking& c) -> Done {
       bake_occlusion(c.recipe, c.settings.threads, c.contents, c.report);
       return {};
     },
     [](const Cooking& c) { return c.recipe.scene_draw; }},
    // With the threshold that the hair has before a search for orders, so that what is said does not depend on that.
    {"coverage",
     [](Cooking& c) -> Done {
       judge_coverage(c);
       return {};
     }},
    {"draw order",
     [](Cooking& c) {
       return keep(choose_order(c.recipe, c.textures.used, c.settings.threads, c.contents, c.report), c.report.order);
     }},
    // Last, since the threshold in use decides how much alpha the mips need.
    {"mips",
     [](Cooking& c) -> Done {
       keep_coverage(c.textures.used, c.contents);
       return {};
     }},
    {"write", write_parts}};

/// Calls `pass` with all that comes with one.
auto run_timed(const char* name, const CookSettings& settings, CookReport& report, const auto& pass) {
  if (settings.progress) settings.progress(name);
  WorkLimit::check();
  WorkLimit::begin_part();
  const auto start = std::chrono::steady_clock::now();
  auto done = pass();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  report.passes.push_back({name, elapsed.count()});
  return done;
}

Done run(const Pass& pass, Cooking& cooking) {
  return run_timed(pass.name, cooking.settings, cooking.report, [&] { return pass.run(cooking); });
}

}  // namespace

tl::expected<CookResult, ToolError> cook(const SourceModel& source, const Recipe& recipe,
                                         const CookSettings& settings) {
  CookResult result;
  result.report.warnings = source.warnings;
  const Recipe used = settings.draft ? draft_of(recipe) : recipe;
  // Before all passes, which take the model for one in metres with Y up.
  SettledSource settled =
      run_timed("size", settings, result.report, [&] { return settle_size(source, used, result.report); });
  Cooking cooking{settled.model ? *settled.model : source, used, settings, result.report};
  cooking.selected = std::move(settled.hair);
  for (const Pass& pass : kPasses) {
    if (pass.wanted != nullptr && !pass.wanted(cooking)) continue;
    if (const Done done = run(pass, cooking); !done) return tl::unexpected(done.error());
  }
  fill_figures(cooking);
  result.report.acknowledge(used.acknowledged_warnings);
  result.inputs = inputs_of(cooking);
  result.patches = patches_of(cooking);
  result.asset = std::move(cooking.asset);
  return result;
}

}  // namespace coif
