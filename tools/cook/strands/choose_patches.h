#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif::cook {

struct StripRecipe;

/// The facts about one patch that a user needs to address it.
struct PatchListing {
  std::uint32_t number = 0;
  std::string mesh, material;  ///< Names in the source.
  std::uint32_t island = 0;    ///< Patches that show the same part of the texture have the same number.
  std::size_t triangles = 0;
  /// Its bounding box: metres, model space.
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), size = Eigen::Vector3d::Zero();
  std::vector<std::uint32_t> overrides;  ///< The recipe's overrides that select it.
  bool kept = true;
  // Known once it has strands and bones.
  std::string
      root;  ///< The side of the texture where its roots are, as in a recipe; "": it has no texture coordinates.
  bool is_unsure = false;  ///< It is not certain which end is its root.
  std::string chain;       ///< The chain that carries most of it, by its first bone; "": the head.
};

/// Lists every patch of hair whose patches were just found, by its number.
[[nodiscard]] std::vector<PatchListing> list_patches(const importer::SourceModel& source, const HairStrips& hair);

/// Finds the patches that the recipe's overrides select, writes them to `hair` and `listings`, and leaves out patches
/// that the recipe does not keep. Errors (kBadInput): an override selects nothing, or nothing is kept. With
/// `only_lists` the first is a warning, since users mend such a recipe by the list.
tl::expected<void, ToolError> choose_patches(const importer::SourceModel& source, const StripRecipe& recipe,
                                             bool only_lists, HairStrips& hair, std::vector<PatchListing>& listings,
                                             Findings& findings);

/// Sets `root` of each listing: the side of the texture at which strands start.
void list_roots(const HairStrips& hair, std::vector<PatchListing>& listings);

/// Patches that are hair of the face, ascending.
struct FaceHair {
  std::vector<std::uint32_t> brows;  ///< Also lashes.
  std::vector<std::uint32_t> beard;  ///< Also moustaches.
};

/// Finds them by the names of mesh and material. Brows also by their place: low patches before the face at the height
/// of the eyes, at most half as wide as the face and much wider than high, close to it, as a mirrored pair. A fringe
/// differs: it reaches up to the hair.
[[nodiscard]] FaceHair find_face_hair(const importer::SourceModel& source, const HairStrips& hair,
                                      const FittedHead& head);

/// Notes them, and leaves out those that the recipe does not keep (hair.brows, hair.beard). Error (kBadInput): nothing
/// else is left.
tl::expected<void, ToolError> choose_face_hair(const importer::SourceModel& source, const StripRecipe& recipe,
                                               const FittedHead& head, HairStrips& hair, Findings& findings);

}  // namespace coif::cook
