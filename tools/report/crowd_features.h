#pragma once

#include "report/hair_crowd.h"

#include <string>
#include <vector>

namespace coif {

/// One way in which a crowd can be run otherwise than as it was cooked.
struct CrowdFeature {
  std::string name;         ///< Short, unique: "no-colliders".
  std::string description;  ///< What is different, one line for people.
  CrowdSettings settings;
  bool touches_colliders = true;  ///< False: an asset is meant whose bones touch nothing.
  bool steps = true;              ///< False: only the poses are handed over.
};

/// All that `asset` and this processor have; the first, "as-cooked", is `usual` itself.
[[nodiscard]] std::vector<CrowdFeature> crowd_features(const Asset& asset, const CrowdSettings& usual);

}  // namespace coif
