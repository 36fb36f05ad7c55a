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

/// Hair whose triangles are cut where they cross, and what led to it.
struct CutHair {
  AssetContents contents;
  visibility::FoundOrders orders;  ///< Those of the whole triangles, pieces one after the other where the whole was.
  std::size_t cuts = 0;            ///< Lines that triangles were cut along.
  std::size_t added = 0;           ///< Triangles.
  double gain = 0;                 ///< Expected, dB.
};

/// What crossing triangles cost the pictures, and the cure.
struct Crossings {
  std::size_t pairs = 0;        ///< Triangles of which neither is before the other all over some picture.
  double share = 0;             ///< Part of what pictures in these orders lose that no order could help.
  std::optional<CutHair> cut;   ///< None where cutting would gain too little.
  visibility::RestVotes votes;  ///< Votes about what was looked at, where nothing is cut.
};

/// Cuts the hair of `contents`, drawn as `hair` is in the orders by direction and by the rule of `drawn`, where this
/// puts most right for the triangles that it adds: at most so many, and not where that gains too little. Looks at the
/// hair at rest along as many lines, from as many sides and with as many threads as `settings` say. `share_of_order`:
/// how much of the pictures' squared error is of wrong order; asked only where it matters. Coarser levels stay as they
/// are.
[[nodiscard]] Crossings cut_where_crossing(const AssetContents& contents, const visibility::HairSurface& hair,
                                           std::span<const Eigen::Vector3f> positions,
                                           const visibility::FoundOrders& drawn, std::size_t most_added,
                                           const visibility::SampleSettings& settings,
                                           const std::function<double()>& share_of_order);

struct CutSettings {
  std::size_t most_added = 0;  ///< Triangles.
  float shortest_edge =
      0;  ///< Metres: no edge is cut nearer to its ends, since views have to see each piece to place it.
  double least_gain = 0;  ///< Weight of samples that each triangle added must put right.
};

struct CutResult {
  std::size_t cuts = 0;   ///< Lines that triangles were cut along.
  std::size_t added = 0;  ///< Triangles.
  double gained = 0;      ///< Of SeenCrossings::unavoidable: what is so no longer.
};

/// Cuts triangles in two or three where they cross others as far as pictures show it, the cuts first that put most
/// right for each triangle they add: along the other one's plane, or only from a corner to where that plane meets an
/// edge, which adds half as many. The numbers of triangles in the samples are those of the mesh. The same for the same
/// samples.
CutResult cut_crossings(const SeenCrossings& crossings, const CutSettings& settings, SplitMesh& mesh);

}  // namespace coif::cook
