#pragma once

#include "cook/size/up_evidence.h"
#include "import/source_model.h"

#include <array>
#include <vector>

namespace coif::cook {

struct HairRecipe;

/// A unit that a model may be in, and the logarithm of how likely that is before the model is looked at; 0 for the
/// file's own.
struct UnitPrior {
  double factor = 1;  ///< For the lengths as they were imported.
  double likelihood = 0;
};

/// First the file's own unit, or metres where it has none, then those that files are in by mistake: powers of ten of
/// it, inches and feet. A file's word counts the more the less it could be there by itself: the format's definition, a
/// unit that somebody chose, the value that every exporter writes, the output of a converter that knows no units. A
/// file without a unit may be in one of its own, that of the head that its strands grew on: the one that makes their
/// scalp a usual one, to two digits. `scalp_radius`: of these, as it was imported; 0: not known.
[[nodiscard]] std::vector<UnitPrior> unit_priors(const importer::SourceModel& model, const HairRecipe& recipe,
                                                 double scalp_radius);

/// The same for each direction of up_direction().
[[nodiscard]] std::array<double, kUps> up_priors(const importer::SourceModel& model);

}  // namespace coif::cook
