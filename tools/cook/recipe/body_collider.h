#pragma once

// The recipe's colliders on the body, which hair keeps out of.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

/// A collider on a bone of the body, in the rest pose: a ball; with a tail a capsule, tapered where the tail has a
/// radius of its own; with a normal a plane. Model space, metres, Y up.
struct RecipeBodyCollider {
  std::string bone;                             ///< Its name in the file, ignoring case.
  std::optional<std::array<double, 3>> center;  ///< None: where the bone is.
  std::optional<std::array<double, 3>> tail;
  std::optional<std::array<double, 3>> normal;  ///< Points to the side of the hair; any length but 0.
  std::optional<double> radius;                 ///< For all shapes but a plane.
  std::optional<double> tail_radius;
  bool inside = false;            ///< Hair stays inside; balls and capsules only.
  std::vector<std::string> hair;  ///< Patterns of the hair's bones that may touch it; empty: all.
};

}  // namespace coif::cook
