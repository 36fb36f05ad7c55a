#pragma once

#include "cook/recipe/recipe.h"
#include "cook/size/up_evidence.h"
#include "import/source_model.h"

#include <array>
#include <optional>
#include <vector>

namespace coif {

/// A unit that a model may be in, and the logarithm of how likely that is before the model is looked at; 0 for the
/// file's own.
struct UnitPrior {
  double factor = 1;  ///< For the lengths as they were imported.
  double likelihood = 0;
};

/// First the file's own unit, or metres where it has none, then those that files are in by mistake: powers of ten of
/// it, inches and feet. A file's word counts the more the less it could be there by itself: the format's definition, a unit
/// that somebody chose, the value that every exporter writes, the output of a converter that knows no units.
[[nodiscard]] std::vector<UnitPrior> unit_priors(const SourceModel& model, const Recipe& recipe);

/// Of a file without a unit whose strands' roots lie on a scalp: the unit that makes it a usual one, to two digits. Few files are in a
/// unit of their own. `scalp_radius`: as it was imported; 0: not known.
[[nodiscard]] std::optional<UnitPrior> unit_by_scalp(const SourceSpace& space, double scalp_radius);

/// The same for each direction of up_direction().
[[nodiscard]] std::array<double, kUps> up_priors(const SourceModel& model);

}  // namespace coif
