#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/texture/image.h"
#include "cook/texture/relief.h"
#include "cook/texture/source_images.h"
#include "cook/texture/texture_atlas.h"

#include <list>

namespace coif::cook {

struct DrawnRecipe;

/// The look of a part of the hair: materials with equal values are one look.
struct SurfaceLook {
  std::string name;                ///< The first material's; for messages.
  const Image* image = nullptr;    ///< Null: the factor alone.
  bool lacks_image = false;        ///< The material names an image that cannot be read, so its factor says little.
  const Image* normals = nullptr;  ///< A normal or bump map; null: none.
  NormalMapUse normal_use;
  const Image* strands = nullptr;  ///< SourceMaterial::strand_texture; null: none.
  importer::TextureWrap wrap[2] = {importer::TextureWrap::kRepeat, importer::TextureWrap::kRepeat};  ///< Along U and V.
  Eigen::Vector4f factor = Eigen::Vector4f::Ones();
  importer::AlphaUse alpha_use = importer::AlphaUse::kUnknown;
  float alpha_cutoff = 0.5f;
};

struct SurfaceLooks {
  std::list<Image> made;           ///< Images that looks show and no file has.
  std::vector<SurfaceLook> looks;  ///< At least one, in the order of the hair's triangles.
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t main = 0;  ///< The look with most triangles.
};

/// Linear, 0..1.
[[nodiscard]] Eigen::Vector4f color_factor(const importer::SourceMaterial& material);

/// The source's maps that are looked for. Maps that the recipe replaces are not reported as missing.
struct WantedMaps {
  bool normals = true;
  bool opacity = true;
};

/// The looks of the hair's triangles; their images belong to `images`. If the file names no image for any part of the
/// hair and is not glTF (where that would be on purpose), an image beside the source may be used.
[[nodiscard]] SurfaceLooks find_looks(const importer::SourceModel& source, SourceImages& images, const HairMesh& hair,
                                      const WantedMaps& wanted);

/// True for glTF: a file without a texture or a colour means white, where other formats' exporters leave things out.
[[nodiscard]] bool says_what_it_lacks(const importer::SourceModel& source);

/// The common use of alpha in one image for several looks.
struct JointAlpha {
  importer::AlphaUse use = importer::AlphaUse::kUnknown;
  float cutoff = 0.5f;
  bool cut_masks = false;  ///< Alpha of masked looks becomes 0 or 1 by their own cutoff.
};

[[nodiscard]] JointAlpha join_alpha(std::span<const SurfaceLook> looks);

/// Mean colour of the look's image where that is more solid than not, times its factor, linear.
[[nodiscard]] Eigen::Vector3f mean_color(const SurfaceLook& look);

/// The look's image times its factor, with alpha as `joint` wants it; one texel where the look has no image.
[[nodiscard]] Image paint(const SurfaceLook& look, const JointAlpha& joint);

/// Colour and alpha of the whole hair before lighting.
struct BaseColor {
  std::optional<Image> image;                        ///< RGBA at full size; none: the factor alone.
  Eigen::Vector4f factor = Eigen::Vector4f::Ones();  ///< Multiplies the image, linear, 0..1.
  /// From the file; kUnknown for an image of the recipe.
  importer::AlphaUse alpha_use = importer::AlphaUse::kUnknown;
  float alpha_cutoff = 0.5f;                 ///< For kMask.
  std::optional<std::uint32_t> max_size;     ///< Texels: a larger image is reduced to this; none: the recipe's.
  std::optional<AtlasLayout> atlas;          ///< Set where surfaces of several materials share the image.
  std::optional<Image> normals;              ///< Two channels, as NormalMap has them; none: the surface's own.
  std::optional<Image> strands;              ///< RGBA, SourceMaterial::strand_texture.
  bool is_of_vertex_colors = false;          ///< `image` is make_color_squares(): coordinates are colours, not places.
  std::optional<Image> strand_ids;           ///< As `strands`; from the recipe only red is known.
  std::optional<Image> root_to_tip;          ///< One channel, in the coordinates of `image`: place along a strand.
  std::vector<std::filesystem::path> files;  ///< Image files beside the source that were read.
  std::vector<std::filesystem::path> recipe_files;  ///< Image files of the recipe that were read.
  std::vector<TextureQuestion> questions;           ///< How the files were found; empty for an image of the recipe.
};

/// Finds the hair's base colour: the recipe's image, else that of its materials. Surfaces with different images or
/// colours are put together in an atlas, and the texture coordinates of `hair` move into it, which may split vertices;
/// so this comes before any pass that numbers vertices. Where no atlas can be made, the main material is used for all,
/// with a warning. Error: an image of the recipe cannot be read.
tl::expected<BaseColor, ToolError> find_base_color(const importer::SourceModel& source, HairMesh& hair,
                                                   const DrawnRecipe& recipe, const CookSettings& settings,
                                                   Findings& findings);

/// Cooked textures repeat. Adapts hair whose textures would look different on one that repeats, in the cheapest way
/// that works:
///
/// - Where no triangle crosses a border of the image, coordinates are clamped or folded into it.
/// - A mirrored image that is crossed is stored with its mirror image beside it.
/// - A clamped image that is crossed becomes a tile that reaches as far as the coordinates do. Then `clamped` of the
/// look
///   stays TextureWrap::kClamp, and it must be drawn in an atlas. All other looks are kRepeat afterwards.
///
/// Coordinates beyond a tile's range are moved into it, with a warning.
void settle_wraps(SurfaceLooks& looks, HairMesh& hair, Findings& findings);

}  // namespace coif::cook
