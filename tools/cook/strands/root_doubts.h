#pragma once

#include "cook/recipe/decision.h"
#include "cook/strands/strand_evidence.h"

namespace coif::cook {

/// What was found of one patch.
struct FoundRoot {
  float area = 0;
  float belief = 0;      ///< That its low end is the root, -1..1.
  float evidence = 0;    ///< RootEvidence::sum().
  float mirrored = 0;    ///< mirror_agreement() of a shell; 0 for other patches.
  bool is_told = false;  ///< By the recipe.
};

/// `tangents`, per vertex, from root to tip.
[[nodiscard]] RootDoubts doubts_of(const HairMesh& mesh, std::span<const PatchView> views,
                                   std::span<const FoundRoot> found, const PatchCompany& company,
                                   std::span<const Eigen::Vector3f> tangents, const FittedHead& head);

/// The decision about the roots of all patches but those that the recipe told.
[[nodiscard]] Decision decision_of(const RootDoubts& doubts, std::size_t told, std::size_t patches);

}  // namespace coif::cook
