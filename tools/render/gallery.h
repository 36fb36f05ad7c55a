#pragma once

#include "base/tool_error.h"
#include "render/picture.h"

#include <coif/asset.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace coif::render {

/// The asset's own material, or that of the thesis's first gallery if it has none; shaded by the thesis's model in
/// either case.
[[nodiscard]] MaterialRecord thesis_material(const Asset& asset);

/// The asset's, or thesis_material() where it has none.
[[nodiscard]] inline MaterialRecord own_material(const Asset& asset) {
  return asset.material() != nullptr ? *asset.material() : thesis_material(asset);
}

/// Mean of the base texture, linear, each texel counted by its alpha; white without a texture.
[[nodiscard]] Eigen::Vector3d mean_base_color(const Asset& asset);

/// That material, dyed: the hair's texture is on average of `color` (linear).
[[nodiscard]] MaterialRecord dyed_material(const Asset& asset, const Eigen::Vector3d& color);

// Many small pictures on one.

struct SheetTile {
  std::string caption;  ///< Below the picture, broken into lines where it is wider.
  Picture picture;
};

/// Begins a new row beneath its title.
struct SheetSection {
  std::string title;
  std::vector<SheetTile> tiles;
};

/// All tiles have the first one's size; `columns` (> 0) of them make a row. ASCII only.
[[nodiscard]] Picture contact_sheet(std::span<const SheetSection> sections, std::uint32_t columns);

// The five galleries of the thesis, one of how hair swings and one of hair on a character, taken of any asset.

inline constexpr std::uint32_t kGalleries = 7;
inline constexpr std::uint32_t kGalleryColumns = 6;

struct GallerySettings {
  std::uint32_t width = 320;  ///< Width of one picture, pixels, 64..1024.
  std::uint32_t height = 320;
  std::uint32_t only = 0;               ///< One gallery, 1..kGalleries; 0: all.
  const Solver* solver = &kCoifSolver;  ///< For the first five; the sixth compares two, and the last has its own.
};

struct GalleryPicture {
  std::string caption;
  PictureSettings settings;
};

/// A row or two of pictures that are to be compared.
struct Gallery {
  std::uint32_t number = 1;  ///< In the thesis, up to 5.
  std::string title;
  std::vector<GalleryPicture> pictures;
  /// For pictures that differ only in time: the motion's name or that of one of head_looks().
  std::string motion{};
};

/// The galleries: 1 separate components, 2 shifts of the highlights, 3 their exponents, 4 colours, 5 motion, as
/// successive moments, 6 hair after the head has charged: as cooked, and by Algorithm 1, 7 features of characters: a
/// hand that moves through the hair, other sizes in the same run, a pose that the hair follows.
[[nodiscard]] std::vector<Gallery> thesis_galleries(const Asset& asset, const GallerySettings& settings);

struct GallerySheet {
  Picture sheet;  ///< draw_ms is for all pictures together.
  std::uint32_t pictures = 0;
};

/// Takes the pictures of `galleries` (not empty) in one OpenGL context and puts them on a sheet, `last` below them.
/// Calls `progress` with each caption before its picture. Errors: those of PictureMaker.
tl::expected<GallerySheet, ToolError> draw_sheet(const Asset& asset, std::span<const Gallery> galleries,
                                                 std::uint32_t columns, std::vector<SheetSection> last,
                                                 const std::function<void(const std::string&)>& progress);

/// kUsage where a picture of a sheet is not to be so large or so small.
tl::expected<void, ToolError> check_tile_size(std::uint32_t width, std::uint32_t height);

/// Takes the pictures in one OpenGL context and puts them on a sheet. Calls `progress` with each caption before its
/// picture. The same asset and driver give the same pixels. Errors: kUsage for settings out of range; those of
/// PictureMaker.
tl::expected<GallerySheet, ToolError> render_gallery(const Asset& asset, const GallerySettings& settings,
                                                     const std::function<void(const std::string&)>& progress);

/// Adds galleries of hair on a character, with kCoifSolver whatever `picture` has. The asset must outlive the
/// galleries.
void add_character_galleries(const Asset& asset, PictureSettings picture, std::vector<Gallery>& galleries);

struct LookSettings {
  std::uint32_t width = 256;  ///< Width of one picture, pixels, 64..1024.
  std::uint32_t height = 256;
  std::string title;  ///< Above all pictures.
  /// Messages of the cook, a paragraph each, below the pictures; bytes other than ASCII are replaced.
  std::vector<std::string> told;
  const importer::SourceModel* rest = nullptr;  ///< What is not hair, without its textures; null: not known.
};

/// One sheet that shows whether a cook is right: the hair from all sides with the rest of the model, its patches and
/// the direction of its strands, the colliders through the hair, moments of three motions, the base texture and its
/// alpha, and the cook's messages.
/// Errors: kUsage for a size out of range; those of PictureMaker.
tl::expected<GallerySheet, ToolError> render_look(const Asset& asset, const LookSettings& settings,
                                                  const std::function<void(const std::string&)>& progress);

/// The label of a patch.
struct PatchLabel {
  std::string text;        ///< ASCII.
  bool is_marked = false;  ///< Drawn in red.
};

struct PatchChartSettings {
  std::uint32_t width = 800;  ///< Width of one picture, pixels, 64..1024.
  std::uint32_t height = 800;
  std::string title;
};

/// Every patch of the finest level in its own colour, from six sides, with its label (one each) where it is seen and
/// there is room for it. Errors: kUsage for a size out of range; those of PictureMaker.
tl::expected<GallerySheet, ToolError> render_patch_chart(const Asset& asset, std::span<const PatchLabel> labels,
                                                         const PatchChartSettings& settings,
                                                         const std::function<void(const std::string&)>& progress);

}  // namespace coif::render
