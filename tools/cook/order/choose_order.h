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

/// What choose_order() made; all 0 where nothing is blended or looked for.
struct OrderFigures {
  std::uint32_t orders = 0;     ///< The one for all directions included.
  double psnr = 0;              ///< Expected of pictures, dB: of all pixels together,
  double median = 0;            ///< over the views at rest,
  double worst = 0;             ///< of the worst of these,
  double moving = 0;            ///< and over those in motion.
  std::uint32_t crossings = 0;  ///< Pairs of triangles of which neither is before the other all over some picture.
  std::uint32_t cuts = 0;       ///< Lines that triangles were cut along.
  std::uint32_t added = 0;      ///< Triangles.
  double cut_gain = 0;          ///< Expected of the cuts, dB.
};

/// dB that each further layer of a pixel must gain that is blended instead of drawn solid: it is shaded and written
/// once more, where a solid one hides what is behind it.
inline constexpr double kGainPerLayer = 0.5;

/// `triangles`: of the finest level before.
void note_crossings(const Crossings& crossings, std::size_t triangles, Findings& findings);
/// `usual_threshold`: what the material had.
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

/// Puts the patches of every level of detail into the order found for the finest one, and their triangles with them;
/// writes the orders by direction, and in the material how they are to be drawn. Patches of coarser levels go where
/// those of the finest with the same place in the file are; in orders of triangles, where these are on average.
void apply_orders(const visibility::FoundOrders& found, AssetContents& contents);

/// Looks for the orders in which the packed hair is best drawn (search_orders()), at rest and in motion, and writes
/// them, and the opaque threshold where the recipe leaves it open. What is drawn is never worse, as far as the search
/// can tell, than by distance from the head, which is kept where nothing is blended. Mips must have their own alpha
/// yet: each threshold is tried with those that keep_coverage() would make for it with `used`. Before that, cuts
/// triangles of the finest level where they cross (cook/cuts), as far as "order.cut_budget" allows. Notes what was
/// chosen, with figures. Errors: kBadInput for hair that the runtime cannot simulate.
tl::expected<OrderFigures, ToolError> choose_order(const DrawnRecipe& recipe, std::span<const Image> used,
                                                   const platform::Threads& threads, AssetContents& contents,
                                                   Findings& findings);

/// Writes into each vertex which share of the light from everywhere reaches it in the rest pose
/// (VertexRecord::normal[3]): over the 96 directions of view_cells.h, each as wide as its cell, the mean of what the
/// hair before the vertex lets through, 0 where a collider of the head is before it. Hair seen from both sides is lit
/// from both; hair with an outside only by what is above its surface. A card does not shade itself. Alpha counts as
/// painted, so this comes before keep_coverage(). Recipe: "occlusion.strength". Notes the mean and the least.
///
/// Source of the idea: Zhukov, Iones, Kronin 1998, "An ambient light illumination model".
void bake_occlusion(const DrawnRecipe& recipe, const platform::Threads& threads, AssetContents& contents,
                    Findings& findings);

}  // namespace coif::cook
