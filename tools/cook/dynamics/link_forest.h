#pragma once

#include "cook/dynamics/shared_strips.h"
#include "write/asset_writer.h"

#include <cstdint>
#include <map>
#include <vector>

namespace coif::cook {

/// Pairs of chains, and how many depths of each are to be linked at most.
using LinkedDepths = std::map<ChainPair, std::uint32_t>;

/// How far apart linked bones may get, as shares of their distance at rest.
struct LinkRoom {
  double stretch = 0;
  double shrink = 0;
};

/// Links of chains, and what did not become one.
struct LinkForest {
  std::vector<LinkRecord> links;      ///< As the asset has them: by depth, predecessors first.
  std::vector<ChainPair> linked;      ///< Pairs that some link holds together.
  std::vector<ChainPair> roundabout;  ///< Pairs left out, since other pairs hold these chains together already.
  std::vector<LinkRecord> touching;   ///< Links left out, since both bones end at one place.
};

/// Links each pair of chains, depth by depth: a bone to the nearest one of the other chain that is as deep. Of pairs
/// that close a circle the widest is left out, unless a chain between them has ended. Each tree starts in its middle,
/// since a solver that goes through the links one by one is the more exact the fewer follow each other.
[[nodiscard]] LinkForest link_chains(const AssetContents& contents, const LinkedDepths& pairs, const LinkRoom& room);

}  // namespace coif::cook
