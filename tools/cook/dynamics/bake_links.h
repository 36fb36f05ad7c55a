#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {

/// Two chains, the one with the lower index first.
using ChainPair = std::pair<std::uint32_t, std::uint32_t>;

/// The hair that a pair of chains carries together.
struct SharedHair {
  std::uint32_t strips = 0;
  std::uint32_t depths = 0;  ///< Down to which bones strips are between the two: 1 the first of either chain alone.
};

/// Strips that hang on two chains at once, so that they are torn when these drift apart.
struct SharedStrips {
  std::map<ChainPair, SharedHair> pairs;
  std::uint32_t count = 0;  ///< Strips that hang on some pair.
};

/// Finds strips that hang on two chains, by the skin's weights. A strip is a patch before cuts, since pieces still
/// touch. It hangs on two chains where both carry a good part of it, and a good part of the weaker one's is in
/// triangles that follow both. So neither rounded weights, nor roots that blend into the neighbour, nor two tails that
/// grow out of one cap count as a sheet.
[[nodiscard]] SharedStrips find_shared_strips(const HairStrips& hair, const HairRig& rig);

/// Pairs of chains, and the largest number of depths to link for each.
using LinkedDepths = std::map<ChainPair, std::uint32_t>;

/// The range of distances of linked bones, as shares of their distance at rest.
struct LinkRoom {
  double stretch = 0;
  double shrink = 0;
};

/// The links of chains, and the pairs that were left out.
struct LinkForest {
  std::vector<LinkRecord> links;      ///< In the asset's order: by depth, predecessors first.
  std::vector<ChainPair> linked;      ///< Pairs that some link holds together.
  std::vector<ChainPair> roundabout;  ///< Pairs left out, since other pairs hold these chains together already.
  std::vector<LinkRecord> touching;   ///< Links left out, since both bones end at one place.
};

/// Links each pair of chains, depth by depth: a bone to the nearest one of equal depth in the other chain. Of pairs
/// that close a circle the widest is left out, unless a chain between them has ended. Each tree starts in its middle: a
/// solver that goes through the links one by one is more exact if fewer follow each other.
[[nodiscard]] LinkForest link_chains(const AssetContents& contents, const LinkedDepths& pairs, const LinkRoom& room);

struct RigRecipe;

/// The links between bones of neighbouring chains, by the recipe's words about the bones packed in `contents`. Empty
/// where the recipe has none; then a note mentions strips that hang on two chains. Error (kBadInput): the recipe names
/// bones that do not exist or do not move, or two of one chain, or more pairs than anybody can mean. `source` is the
/// file's name.
[[nodiscard]] tl::expected<std::vector<LinkRecord>, ToolError> bake_links(const std::string& source,
                                                                          const HairStrips& hair, const HairRig& rig,
                                                                          const AssetContents& contents,
                                                                          const RigRecipe& recipe, Findings& findings);

}  // namespace coif::cook
