#pragma once

// What a recipe says of the body that hair keeps out of.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

/// A collider on a bone of the body, in the rest pose: a ball, a capsule where it has a tail, a tapered one where the
/// tail has a radius of its own, or a plane where it has a normal. Model space, metres, Y up.
struct RecipeBodyCollider {
  std::string bone;                             ///< As the file calls it, letters of either case.
  std::optional<std::array<double, 3>> center;  ///< None: where the bone is.
  std::optional<std::array<double, 3>> tail;
  std::optional<std::array<double, 3>> normal;  ///< To where the hair is; of any length but 0.
  std::optional<double> radius;                 ///< Of all but a plane, which has none.
  std::optional<double> tail_radius;
  bool inside = false;            ///< Hair stays inside; balls and capsules only.
  std::vector<std::string> hair;  ///< Patterns of the hair's bones that may touch it; empty: all.
};

}  // namespace coif::cook
