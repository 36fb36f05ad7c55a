#pragma once

#include "base/tool_error.h"
#include "cook/cuts/cut_hair.h"
#include "cook/recipe/findings.h"
#include "cook/strands/hair_strips.h"
#include "cook/texture/image.h"
#include "platform/stop.h"
#include "visibility/order_search.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cook {

/// Expected quality of the orders of choose_order(); all 0 where nothing is blended or searched.
struct OrderFigures {
  std::uint32_t orders = 0;     ///< The one for all directions included.
  double psnr = 0;              ///< Expected PSNR of pictures, dB, over all pixels together.
  double median = 0;            ///< The median over the views at rest.
  double worst = 0;             ///< The worst of these views.
  double moving = 0;            ///< Over the views in motion.
  std::uint32_t crossings = 0;  ///< Pairs of triangles of which neither is before the other all over some picture.
  std::uint32_t cuts = 0;       ///< Lines that triangles were cut along.
  std::uint32_t added = 0;      ///< Triangles.
  double cut_gain = 0;          ///< Expected of the cuts, dB.
};

/// dB that each further layer of a pixel must gain to be blended instead of drawn solid: it is shaded and written once
/// more, where a solid one hides everything behind it.
inline constexpr double kGainPerLayer = 0.5;

/// `triangles`: number of the finest level's before the cuts.
void note_crossings(const Crossings& crossings, std::size_t triangles, Findings& findings);
/// `usual_threshold`: the material's.
void note_orders(const visibility::FoundOrders& found, float usual_threshold, Findings& findings);

[[nodiscard]] OrderFigures figures_of(const visibility::FoundOrders& found, const Crossings& crossings);

struct DrawnRecipe;

struct PatchOrder {
  std::vector<std::uint32_t> patch;  ///< Draw position -> patch, inner ones first.
  std::vector<double> distance;      ///< Per draw position, metres, ascending.
  /// Per draw position: which of the patches it is in the file, by their first triangles.
  std::vector<std::uint32_t> file_place;
};

/// The thesis's order (5.3.1): by the distance of the patch's middle, weighted by area, from the head's centre. Equal
/// distances keep the order of the file.
[[nodiscard]] PatchOrder sort_patches(const HairStrips& hair, const Eigen::Vector3d& head_center);

/// Sorts the patches of every level of detail by the order found for the finest one, with their triangles; writes the
/// orders by direction, and into the material how to draw them. A coarser level's patches go to the places of the
/// finest level's patches with the same place in the file; in orders of triangles, to the mean place of these.
void apply_orders(const visibility::FoundOrders& found, AssetContents& contents);

/// Looks for the orders in which the packed hair is best drawn (search_orders()), at rest and in motion. Writes them,
/// and the opaque threshold where the recipe leaves it open. As far as the search can tell, the pictures are never
/// worse than by distance from the head, which is kept where nothing is blended. Mips must still have their own alpha:
/// each threshold is tried with those that keep_coverage() would make for it with `used`. Before that, cuts triangles
/// of the finest level where they cross (cook/cuts), as far as "order.cut_budget" allows. Notes the choice, with
/// figures. Errors: kBadInput for hair that the runtime cannot simulate.
tl::expected<OrderFigures, ToolError> choose_order(const DrawnRecipe& recipe, std::span<const Image> used,
                                                   const platform::Threads& threads, AssetContents& contents,
                                                   Findings& findings);

/// With ShadingModel::kVolume: turns the vertices' normals into those of the hair as one soft body, hair and head as
/// they fill space, blurred over some six cells of a grid, and says so in the material's flags. Light then runs on from
/// card to card.
void bake_normals(AssetContents& contents, Findings& findings);

/// Writes into each vertex the share of ambient light that reaches it in the rest pose (VertexRecord::normal[3]): the
/// mean over the 96 directions of view_cells.h, each as wide as its cell, of the light that the hair before the vertex
/// lets through, 0 where a collider of the head is before it. Two-sided hair is lit from both sides; one-sided hair
/// only from above its surface. A card does not shade itself. Uses alpha as painted, so it comes before
/// keep_coverage(). Recipe: "occlusion.strength". Notes mean and minimum.
///
/// Source of the idea: Zhukov, Iones, Kronin 1998, "An ambient light illumination model".
void bake_occlusion(const DrawnRecipe& recipe, const platform::Threads& threads, AssetContents& contents,
                    Findings& findings);

}  // namespace coif::cook
