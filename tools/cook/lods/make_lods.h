#pragma once

#include "cook/lods/collapse_patch.h"
#include "cook/lods/detail_level.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/select/head.h"
#include "cook/select/triangle_distance.h"
#include "cook/strands/hair_strips.h"
#include "cook/texture/patch_coverage.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <vector>

namespace coif::cook {

/// Chooses patches to leave out of a coarser level: hidden ones, tiny ones, and those that lie on others.
class PatchDropper {
 public:
  /// Left-out hair lies within `reach` (metres) of hair that stays. Keeps references.
  PatchDropper(const HairStrips& hair, const AlphaTest& alpha, double reach, const platform::Threads& threads);

  /// Drops patches of `drawn` until `excess` triangles are gone or nothing more may go: the least seen for their
  /// `triangles` first, and none that leaves holes. `triangles[p]`: how many patch p has at this level. Returns the
  /// triangles that are gone.
  std::size_t drop(std::size_t excess, std::span<const std::size_t> triangles, std::vector<bool>& drawn);

  /// Share of the pixels of all views that had hair and have none any more.
  [[nodiscard]] double bared() const;

 private:
  [[nodiscard]] bool may_go(std::uint32_t patch, std::vector<bool>& drawn) const;

  const HairMesh& mesh_;
  PatchCoverage views_;
  TriangleGrid grid_;
  std::vector<std::vector<std::uint32_t>> vertices_;  ///< Of each patch.
  double reach_;
  std::size_t bared_ = 0;  ///< Pixels.
};

/// All patches of the hair, each ready to be made as coarse as wanted.
class SimplifiedPatches {
 public:
  SimplifiedPatches(const HairStrips& hair, std::span<const Pose> poses, const CollapseLimits& limits,
                    const platform::Threads& threads);

  [[nodiscard]] std::size_t count() const { return patches_.size(); }
  [[nodiscard]] std::size_t finest_triangles(std::size_t patch) const { return patches_[patch].originals.size() / 3; }
  /// After `steps` steps.
  [[nodiscard]] std::size_t triangles_left(std::size_t patch, std::size_t steps) const;
  [[nodiscard]] float error(std::size_t patch, std::size_t steps) const;
  /// Three vertices of the mesh each; after 0 steps those of the source, as they were.
  [[nodiscard]] std::vector<std::uint32_t> triangles(std::size_t patch, std::size_t steps) const;

  /// How many steps each patch takes so that those in `drawn` have `target` triangles together, or as few as there can
  /// be: everywhere up to the same error, since no patch is seen better than another. Never fewer than `at_least`.
  [[nodiscard]] std::vector<std::size_t> steps_for(std::size_t target, const std::vector<bool>& drawn,
                                                   std::vector<std::size_t> at_least) const;

 private:
  struct Patch {
    PatchSurface surface;
    CollapseSequence sequence;
    std::vector<std::uint32_t> originals;
  };
  std::vector<Patch> patches_;
};

/// The finest level and coarser ones, until there are as many as wanted or one would save little. Each has, as far as
/// its error stays below the limit, `ratio` times the triangles of the one before: first patches are simplified,
/// everywhere up to the same error; where that is not enough patches that hardly show are dropped.
[[nodiscard]] std::vector<DetailLevel> make_lods(const HairStrips& hair, const HairRig& rig, const FittedHead& head,
                                                 const AlphaTest& alpha, const LodSettings& settings,
                                                 Findings& findings);

/// True where the source has coarser cards that stand for just this hair: it is the cards' mesh, and nothing was left
/// out of it.
[[nodiscard]] bool has_card_levels(const importer::SourceModel& source, const HairStrips& hair);

/// The finest level and coarser ones that were made from the same strands, as far as both the source and the settings
/// go. Their cards become patches of the hair that no other level draws. They move as the finest level's cards around
/// them do: a vertex has the weights of the nearest vertices there, by how near they are.
///
/// A level's `error` is how far any of its vertices is from the finest level's cards, or one of these from its own;
/// each card lies somewhere among its strands, so that this says little of how it looks. `shown_error` is the root of
/// the mean square of that.
[[nodiscard]] std::vector<DetailLevel> card_levels(const importer::SourceModel& source, HairStrips& hair, HairRig& rig,
                                                   const FittedHead& head, const LodSettings& settings,
                                                   Findings& findings);

}  // namespace coif::cook
