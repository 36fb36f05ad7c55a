#pragma once

#include "cook/collapse_patch.h"

namespace coif {

/// All patches of the hair, each ready to be made as coarse as wanted.
class SimplifiedPatches {
 public:
  SimplifiedPatches(const HairMesh& mesh, std::span<const std::uint32_t> place, const PatchSet& patches,
                    std::span<const Pose> poses, const CollapseLimits& limits, unsigned threads);

  [[nodiscard]] std::size_t count() const { return patches_.size(); }
  [[nodiscard]] std::size_t finest_triangles(std::size_t patch) const { return patches_[patch].originals.size() / 3; }
  /// After `steps` steps.
  [[nodiscard]] std::size_t triangles_left(std::size_t patch, std::size_t steps) const;
  [[nodiscard]] float error(std::size_t patch, std::size_t steps) const;
  /// Three vertices of the mesh each; after 0 steps those of the source, as they were.
  [[nodiscard]] std::vector<std::uint32_t> triangles(std::size_t patch, std::size_t steps) const;

  /// How many steps each patch takes so that those in `drawn` have `target` triangles together, or as few as there can be:
  /// everywhere up to the same error, since no patch is seen better than another. Never fewer than `at_least`.
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

}  // namespace coif
