#pragma once

#include "import/source_model.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif {

/// Total skin weight of the hair on each node of the source.
using NodeWeights = std::vector<double>;

/// The head bone: the node called `pattern`, or without one the node called head that carries, with all nodes below it,
/// most of the hair's weight; failing that the lowest node above all of the hair. kNoIndex where the hair follows no
/// node. Error (kBadInput): nothing is called `pattern`.
tl::expected<std::uint32_t, ToolError> find_head_bone(const SourceModel& source, const NodeWeights& weights,
                                                      const std::string& pattern);

/// Weight on a node and everything below it.
[[nodiscard]] NodeWeights weights_below(const SourceModel& source, const NodeWeights& weights);

}  // namespace coif
