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

/// One patch as it is told to whoever wants to say something of it alone.
struct PatchListing {
  std::uint32_t number = 0;
  std::string mesh, material;  ///< Names in the source.
  std::uint32_t island = 0;    ///< Patches that show the same part of the texture have the same number.
  std::size_t triangles = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(),
                  size = Eigen::Vector3d::Zero();  ///< Of its box, metres, model space.
  std::vector<std::uint32_t> overrides;            ///< Of the recipe, that select it.
  bool kept = true;
  // Known once it has strands and bones.
  std::string
      root;  ///< The side of the texture where its roots are, as in a recipe; "": it has no texture coordinates.
  bool is_unsure = false;  ///< Which end its root is.
  std::string chain;       ///< That carries most of it, by its first bone; "": the head.
};

/// Of hair whose patches were just found: every patch, by its number.
[[nodiscard]] std::vector<PatchListing> list_patches(const importer::SourceModel& source, const HairStrips& hair);

/// Finds out which patches the recipe's overrides select, writes that to `hair` and `listings`, and leaves out what the
/// recipe does not keep. Errors (kBadInput): an override selects nothing, or nothing is kept. With `only_lists` the
/// first is a warning, since it is by the list that such a recipe is mended.
tl::expected<void, ToolError> choose_patches(const importer::SourceModel& source, const StripRecipe& recipe,
                                             bool only_lists, HairStrips& hair, std::vector<PatchListing>& listings,
                                             Findings& findings);

/// Fills in `root` of each listing: on which side of the texture strands start.
void list_roots(const HairStrips& hair, std::vector<PatchListing>& listings);

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
