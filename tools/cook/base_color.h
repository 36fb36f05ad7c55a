#pragma once

#include "cook/cook.h"
#include "cook/hair_mesh.h"
#include "cook/image.h"
#include "cook/texture_atlas.h"
#include "cook/texture_question.h"

namespace coif {

/// What colour and alpha the whole hair has before lighting.
struct BaseColor {
  std::optional<Image> image;                        ///< RGBA at full size; none: the factor alone.
  Eigen::Vector4f factor = Eigen::Vector4f::Ones();  ///< Multiplies the image, linear, 0..1.
  AlphaUse alpha_use = AlphaUse::kUnknown;           ///< What the file says; kUnknown for an image of the recipe.
  float alpha_cutoff = 0.5f;                         ///< For kMask.
  std::optional<AtlasLayout> atlas;                  ///< Set where surfaces of several materials share the image.
  std::vector<std::filesystem::path> files;          ///< Image files that were read.
  std::vector<TextureQuestion> questions;            ///< How they were found; none for an image of the recipe.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

/// Finds the hair's base colour: the recipe's image, else what its materials say. Surfaces with different images or
/// colours are put together in an atlas, and the texture coordinates of `hair` move into it, which may split vertices; so
/// this comes before any pass that numbers vertices. Where no atlas can be made the main material is taken for all. Error:
/// an image that the recipe names cannot be read.
tl::expected<BaseColor, ToolError> find_base_color(const SourceModel& source, HairMesh& hair, const Recipe& recipe,
                                                   const CookSettings& settings);

}  // namespace coif
