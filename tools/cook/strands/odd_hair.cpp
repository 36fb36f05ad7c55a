#include "cook/strands/odd_hair.h"

#include "cook/recipe/strip_recipe.h"
#include "cook/strands/patches.h"

#include <fmt/format.h>

namespace coif::cook {

void warn_of_odd_size(const HairMesh& hair, Findings& findings) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& at : hair.positions) box.extend(at);
  if (is_hair_sized(largest_side(box))) return;
  findings.warn(
      "S205",
      fmt::format("the hair is {:.3g} m large; hair has 0.05 .. 3 m: set \"source.metres_per_unit\" in the recipe",
                  largest_side(box)));
}

void warn_of_fragments(const HairMesh& hair, std::size_t patches, Connectivity by, Findings& findings) {
  if (!is_shattered(hair.triangle_count(), patches)) return;
  findings.warn("S206", fmt::format("{} triangles fall into {} patches by {}; set \"patches.connectivity\" to "
                                    "\"position\" or \"index\" in the recipe",
                                    hair.triangle_count(), patches, word_of(by)));
}

}  // namespace coif::cook
