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

  /// Drops patches of `drawn` until `excess` triangles are gone or nothing more may go: first the least visible per
  /// triangle, and none that leaves holes. `triangles[p]`: number of patch p's triangles at this level. Returns how
  /// many triangles are gone.
  std::size_t drop(std::size_t excess, std::span<const std::size_t> triangles, std::vector<bool>& drawn);

  /// Share of the pixels of all views that had hair and no longer have any.
  [[nodiscard]] double bared() const;

 private:
  [[nodiscard]] bool may_go(std::uint32_t patch, std::vector<bool>& drawn) const;

  const HairMesh& mesh_;
  PatchCoverage views_;
  TriangleGrid grid_;
  std::vector<std::vector<std::uint32_t>> vertices_;  ///< The vertices of each patch.
  double reach_;
  std::size_t bared_ = 0;  ///< Pixels.
};

/// All patches of the hair, prepared for any coarseness.
class SimplifiedPatches {
 public:
  SimplifiedPatches(const HairStrips& hair, std::span<const Pose> poses, const CollapseLimits& limits,
                    const platform::Threads& threads);

  [[nodiscard]] std::size_t count() const { return patches_.size(); }
  [[nodiscard]] std::size_t finest_triangles(std::size_t patch) const { return patches_[patch].originals.size() / 3; }
  /// After `steps` steps.
  [[nodiscard]] std::size_t triangles_left(std::size_t patch, std::size_t steps) const;
  [[nodiscard]] float error(std::size_t patch, std::size_t steps) const;
  /// Three vertices of the mesh per triangle; after 0 steps the source's own triangles.
  [[nodiscard]] std::vector<std::uint32_t> triangles(std::size_t patch, std::size_t steps) const;

  /// The number of steps for each patch with which those in `drawn` have `target` triangles together, or as few as
  /// possible: all patches get the same error, since none is seen better than another. Never fewer than `at_least`.
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

/// The finest level and coarser ones, until there are as many as wanted or one would save little. Each has `ratio`
/// times the triangles of the one before, as far as its error stays below the limit. First patches are simplified, all
/// up to the same error; where that does not suffice, patches that are hardly visible are dropped.
[[nodiscard]] std::vector<DetailLevel> make_lods(const HairStrips& hair, const HairRig& rig, const FittedHead& head,
                                                 const AlphaTest& alpha, const LodSettings& settings,
                                                 Findings& findings);

/// True where the source has coarser cards for just this hair: it is the cards' mesh, and nothing was left out of it.
[[nodiscard]] bool has_card_levels(const importer::SourceModel& source, const HairStrips& hair);

/// The finest level and coarser ones that were made from the same strands, as many as source and settings have. Their
/// cards become patches of the hair that no other level draws. They move like the finest level's cards around them: a
/// vertex has the weights of the nearest vertices there, weighted by distance.
///
/// A level's `error` is the largest distance of its vertices from the finest level's cards, or of these from its own.
/// Each card lies somewhere among its strands, so this says little about its looks; `shown_error` is the root mean
/// square of these distances.
[[nodiscard]] std::vector<DetailLevel> card_levels(const importer::SourceModel& source, HairStrips& hair, HairRig& rig,
                                                   const FittedHead& head, const LodSettings& settings,
                                                   Findings& findings);

}  // namespace coif::cook
