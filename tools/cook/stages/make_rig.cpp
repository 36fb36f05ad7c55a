#include "cook/stages/stages.h"

#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/bake_links.h"
#include "cook/dynamics/choose_model.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/rig/body_colliders.h"
#include "cook/rig/colliders.h"
#include "cook/rig/fit_chains.h"
#include "lab/rig.h"

#include <algorithm>

namespace coif::cook {
namespace {

using Done = tl::expected<void, ToolError>;

/// Stores the result of a pass.
template <typename Part>
Done keep(tl::expected<Part, ToolError> made, Part& part) {
  if (!made) return tl::unexpected(made.error());
  part = std::move(*made);
  return {};
}

class RigMaker {
 public:
  RigMaker(const importer::SourceModel& source, const Strips& strips, const RigRecipe& recipe,
           const CookSettings& settings, CookLog& log)
      : source_(source), strips_(strips), recipe_(recipe), settings_(settings), log_(log), findings_(log.findings()) {}

  tl::expected<CookedRig, ToolError> make() {
    Done done = find_bones();
    if (done) done = find_obstacles();
    if (done) done = find_motion();
    if (done) choose_model();
    if (done) done = make_computable();
    if (!done) return tl::unexpected(done.error());
    return std::move(made_);
  }

 private:
  [[nodiscard]] Skeleton& skeleton() { return made_.rig.skeleton; }

  Done find_bones() {
    Done done = log_.pass("skeleton", [&] {
      return keep(rig_of_file(source_, strips_.hair, strips_.head_bone, recipe_, findings_), made_.rig);
    });
    if (!done || !wants_fitted_chains(recipe_, skeleton())) return done;
    log_.pass("chains", [&] {
      made_.rig =
          fit_chains(source_, strips_.hair, strips_.head, skeleton(), recipe_, findings_, settings_.threads.stop);
      judge_chains(strips_.hair, strips_.head, made_.rig, findings_);
    });
    return {};
  }

  /// Colliders of the head and the body.
  Done find_obstacles() {
    log_.pass("colliders", [&] {
      settle_rig(recipe_, made_.rig, findings_);
      colliders_ = find_colliders(source_, strips_.head_bone, strips_.head, skeleton(), recipe_, findings_);
    });
    const bool is_any = !source_.colliders.empty() || !recipe_.body_colliders.empty();
    if (!is_any || skeleton().simulated_count() == 0) return {};
    return log_.pass("body", [&] {
      return keep(find_body_colliders(source_, strips_.head_bone, skeleton(), colliders_, recipe_, findings_), body_);
    });
  }

  /// The motion, limits and links of bones, from the recipe and the file.
  Done find_motion() {
    log_.pass("dynamics", [&] { bake(); });
    if (!source_.springs.empty() || !recipe_.limits.empty()) {
      const Done done = log_.pass(
          "limits", [&] { return keep(bake_limits(source_, skeleton(), recipe_, findings_), made_.contents.limits); });
      if (!done) return done;
    }
    if (skeleton().simulated_count() == 0) return {};
    return log_.pass("links", [&] {
      return keep(bake_links(source_.path, strips_.hair, made_.rig, made_.contents, recipe_, findings_),
                  made_.contents.links);
    });
  }

  void bake() {
    AssetContents& contents = made_.contents;
    const auto of_chain = chain_overrides(strips_.hair, made_.rig, findings_);
    said_ = bake_dynamics(source_, skeleton(), recipe_, of_chain, findings_);
    const std::vector<bool> tied = find_tied_chains(strips_.hair, made_.rig);
    loosen_tied_chains(skeleton(), tied, recipe_, of_chain, said_, findings_);
    contents.dynamics = said_.records;
    pack_skeleton(skeleton(), colliders_, contents);
    pack_body(skeleton(), body_, contents);
    if (strips_.head.faces_backwards) contents.skeleton.flags |= kSkeletonFacesBackwards;
    contents.skeleton.air_lag = air_lag(recipe_, said_);
  }

  void choose_model() {
    log_.pass("model", [&] {
      AssetContents& contents = made_.contents;
      const bool is_checked = recipe_.conditioning != ConditioningRule::kOff && !settings_.draft;
      model_ = is_checked ? choose_models(recipe_, said_, contents, settings_.threads, findings_)
                          : ModelChoice{models_by_rule(recipe_, said_, contents), {}};
      settle_model(recipe_, said_, model_.models, contents, findings_);
    });
  }

  Done make_computable() {
    AssetContents& contents = made_.contents;
    if (!can_be_run(contents)) return {};
    if (!model_.ill_posed.empty()) {
      log_.pass("conditioning", [&] {
        auto given = condition_chains(contents, model_.ill_posed, settings_.threads, findings_);
        contents.asked = asked_of(contents.dynamics);
        contents.dynamics = std::move(given);
      });
    }
    if (!recipe_.torsion && std::ranges::find(model_.models, ChainModel::kCascade) != model_.models.end()) {
      log_.pass("twist", [&] { contents.dynamics = choose_twist(contents, settings_.threads, findings_); });
    }
    if (settings_.draft) return {};
    return log_.pass("tuning", [&] {
      TunedSolver tuned;
      const auto name = [&](ToolError error) { return ToolError{error.kind, source_.path + ": " + error.message}; };
      const Done done = keep(tune_solver(contents, recipe_, settings_.threads, findings_).map_error(name), tuned);
      contents.tuning = tuned.tuning;
      contents.quality = std::move(tuned.quality);
      contents.motion_names = std::move(tuned.motions);
      return done;
    });
  }

  const importer::SourceModel& source_;
  const Strips& strips_;
  const RigRecipe& recipe_;
  const CookSettings& settings_;
  CookLog& log_;
  Findings& findings_;
  Colliders colliders_;
  BodyColliders body_;
  SaidMotion said_;
  ModelChoice model_;
  CookedRig made_;
};

}  // namespace

tl::expected<CookedRig, ToolError> make_rig(const importer::SourceModel& source, const Strips& strips,
                                            const RigRecipe& recipe, const CookSettings& settings, CookLog& log) {
  return RigMaker(source, strips, recipe, settings, log).make();
}

}  // namespace coif::cook
