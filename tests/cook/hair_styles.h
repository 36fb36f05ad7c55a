#pragma once
// Made-up hairstyles of which it is known where every strip has its root: strips along strands that are grown from a
// scalp.

#include "cook/texture/image.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

struct StyledHair {
  std::string family;                   ///< What kind of style it is.
  importer::SourceModel source;         ///< One mesh, in model space, metres; no head, no bones.
  std::vector<Eigen::Vector3f> growth;  ///< Per vertex: the way from root to tip.
  std::optional<Image> image;           ///< Strands that are thin towards their tips, or none.
};

/// The style number `seed`: loose, with a fringe or a parting, combed back into one tail or two, in spikes or in curls;
/// of few strips or of many, on one picture or on an atlas, roots at whichever side, or without texture coordinates.
/// One seed always gives the same style.
[[nodiscard]] StyledHair make_style(std::uint32_t seed);

}  // namespace coif::cook
