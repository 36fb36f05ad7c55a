#pragma once

#include "visibility/order_votes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Units in the order in which they are drawn.
using UnitOrder = std::vector<std::uint32_t>;

/// What an order loses of the votes: the weights of those that it goes against.
[[nodiscard]] double votes_against(std::span<const Vote> votes, std::span<const std::uint32_t> order);

/// The units `order` has, in an order that loses no more than that one does: each unit is taken out and put back where it loses
/// least, until no move helps (insertion neighbourhood, Laguna, Marti and Campos 1999, "Intensification and diversification
/// with elite tabu search solutions for the linear ordering problem"). A sweep costs the number of votes and, for each
/// unit that moves, the number of units.
[[nodiscard]] UnitOrder improve_order(std::span<const Vote> votes, UnitOrder order);

/// Units by what votes say of each in sum: those that others want before them come late. A start for improve_order().
[[nodiscard]] UnitOrder order_by_sums(std::span<const Vote> votes, std::span<const std::uint32_t> units);

}  // namespace coif
