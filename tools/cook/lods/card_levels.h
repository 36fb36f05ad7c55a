#pragma once

#include "cook/lods/detail_level.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"
#include "import/source_model.h"

#include <vector>

namespace coif::cook {

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
