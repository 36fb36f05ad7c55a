#pragma once

#include "cook/cuts/cut_hair.h"
#include "cook/order/order_figures.h"
#include "cook/recipe/findings.h"
#include "visibility/order_search.h"

#include <cstddef>

namespace coif::cook {

/// dB that each further layer of a pixel must gain that is blended instead of drawn solid: it is shaded and written
/// once more, where a solid one hides what is behind it.
inline constexpr double kGainPerLayer = 0.5;

/// `triangles`: of the finest level before.
void note_crossings(const Crossings& crossings, std::size_t triangles, Findings& findings);
/// `usual_threshold`: what the material had.
void note_orders(const visibility::FoundOrders& found, float usual_threshold, Findings& findings);

[[nodiscard]] OrderFigures figures_of(const visibility::FoundOrders& found, const Crossings& crossings);

}  // namespace coif::cook
