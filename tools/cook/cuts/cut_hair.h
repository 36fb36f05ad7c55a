#pragma once

#include "cook/cuts/seen_crossings.h"
#include "cook/cuts/split_mesh.h"
#include "visibility/order_search.h"
#include "visibility/rest_votes.h"
#include "write/asset_writer.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace coif::cook {

/// Hair whose triangles are cut where they cross, and the reasons.
struct CutHair {
  AssetContents contents;
  visibility::FoundOrders orders;  ///< The orders of the whole triangles, with each triangle's pieces in its place.
  std::size_t cuts = 0;            ///< Lines that triangles were cut along.
  std::size_t added = 0;           ///< Triangles.
  double gain = 0;                 ///< Expected, dB.
};

/// The effect of crossing triangles on pictures, and the cuts.
struct Crossings {
  std::size_t pairs = 0;        ///< Triangles of which neither is before the other all over some picture.
  double share = 0;             ///< Share of the pictures' loss in these orders that no order could avoid.
  std::optional<CutHair> cut;   ///< None where cutting would gain too little.
  visibility::RestVotes votes;  ///< The votes of the views that were looked at; filled if nothing is cut.
};

/// Cuts the hair of `contents` where that gains most for the triangles that it adds: at most as many as the budget
/// allows, and not where the gain is too small. `hair` is drawn in the orders by direction and by the rule of `drawn`.
/// Looks at the hair at rest with the lines, views and threads of `settings`. `share_of_order`: share of the pictures'
/// squared error that comes from wrong order; called only where it matters. Coarser levels stay as they are.
[[nodiscard]] Crossings cut_where_crossing(const AssetContents& contents, const visibility::HairSurface& hair,
                                           std::span<const Eigen::Vector3f> positions,
                                           const visibility::FoundOrders& drawn, std::size_t most_added,
                                           const visibility::SampleSettings& settings,
                                           const std::function<double()>& share_of_order);

struct CutSettings {
  std::size_t most_added = 0;  ///< Triangles.
  /// Metres: no edge is cut nearer to its ends, since views have to see each piece to place it.
  float shortest_edge = 0;
  double least_gain = 0;  ///< Weight of samples that each triangle added must put right.
};

struct CutResult {
  std::size_t cuts = 0;   ///< Lines that triangles were cut along.
  std::size_t added = 0;  ///< Triangles.
  double gained = 0;      ///< Part of SeenCrossings::unavoidable that the cuts made avoidable.
};

/// Cuts triangles in two or three where they cross others in pictures. The cuts with the largest gain per added
/// triangle come first: along the other triangle's plane, or only from a corner to where that plane meets an edge,
/// which adds half as many. Samples use the mesh's triangle numbers. Equal samples give equal results.
CutResult cut_crossings(const SeenCrossings& crossings, const CutSettings& settings, SplitMesh& mesh);

}  // namespace coif::cook
