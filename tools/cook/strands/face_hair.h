#pragma once

#include "base/tool_error.h"
#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"

#include <vector>

namespace coif::cook {

struct StripRecipe;

/// Patches that are hair of the face, ascending.
struct FaceHair {
  std::vector<std::uint32_t> brows;  ///< And lashes.
  std::vector<std::uint32_t> beard;  ///< And moustaches.
};

/// By the names of mesh and material; brows also by their place: low patches before the face at the height of the eyes,
/// no wider than half of it and much wider than high, that lie close to it, as a pair that mirrors itself. A fringe
/// reaches up to the hair.
[[nodiscard]] FaceHair find_face_hair(const importer::SourceModel& source, const HairStrips& hair,
                                      const FittedHead& head);

/// Notes what there is, and leaves out what the recipe does not keep (hair.brows, hair.beard). Error (kBadInput):
/// nothing else is left.
tl::expected<void, ToolError> choose_face_hair(const importer::SourceModel& source, const StripRecipe& recipe,
                                               const FittedHead& head, HairStrips& hair, Findings& findings);

}  // namespace coif::cook
