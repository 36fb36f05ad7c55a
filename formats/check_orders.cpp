#include "chunk_checks.h"

namespace coif {
namespace {

LoadStatus order_error(LoadCode code, std::size_t item, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kOrders, item, expected, found};
}

/// Spreads a triangle's number over all bits, so that sums of the results tell one set of triangles from another. Source:
/// the finaliser of SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
std::uint64_t scatter(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

/// One level's triangles `first` to `first + count` in all further orders. There is no memory for a mark per triangle: that
/// each occurs once is shown by a sum, certain against accidents. A forged list that passes draws wrong triangles, as many
/// as it should, all of them the level's.
LoadStatus check_level(const Asset& asset, std::size_t first, std::size_t count) {
  std::uint64_t expected = 0;
  for (std::size_t t = first; t < first + count; ++t) expected += scatter(t + 1);
  const auto orders = asset.orders();
  for (std::size_t start = first; start < orders.size(); start += asset.indices().size() / 3) {
    std::uint64_t found = 0;
    for (std::size_t i = start; i < start + count; ++i) {
      const std::size_t triangle = orders[i];
      if (triangle < first || triangle - first >= count) {
        return order_error(LoadCode::kReference, i, first + count, triangle);
      }
      found += scatter(triangle + 1);
    }
    if (found != expected) return order_error(LoadCode::kOrderCover, start);
  }
  return {};
}

LoadStatus check_levels(const Asset& asset) {
  if (asset.lods().empty()) return check_level(asset, 0, asset.indices().size() / 3);
  for (const LodRecord& lod : asset.lods()) {
    const auto patches = asset.patches().subspan(lod.first_patch, lod.patch_count);
    const std::size_t first = patches.front().first_index;
    const std::size_t end = std::size_t{patches.back().first_index} + patches.back().index_count;
    if (const LoadStatus status = check_level(asset, first / 3, (end - first) / 3); !status) return status;
  }
  return {};
}

LoadStatus check_views(const Asset& asset, std::size_t order_count) {
  const auto views = asset.order_views();
  if (views.size() != kViewCells) return {LoadCode::kChunkSize, chunk::kOrderViews, 0, kViewCells, views.size()};
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i] >= order_count) return {LoadCode::kReference, chunk::kOrderViews, i, order_count, views[i]};
  }
  return {};
}

}  // namespace

LoadStatus check_orders(const Asset& asset) {
  const auto orders = asset.orders();
  if (orders.empty() != asset.order_views().empty()) {
    return {LoadCode::kChunkMissing, orders.empty() ? chunk::kOrders : chunk::kOrderViews};
  }
  if (orders.empty()) return {};
  const std::size_t triangles = asset.indices().size() / 3;
  if (triangles == 0) return {LoadCode::kChunkMissing, chunk::kIndices};
  if (orders.size() % triangles != 0) return order_error(LoadCode::kChunkSize, 0, triangles, orders.size());
  const std::size_t further = orders.size() / triangles;
  if (further >= kMaxOrders) return order_error(LoadCode::kChunkSize, 0, kMaxOrders - 1, further);
  if (const LoadStatus status = check_levels(asset); !status) return status;
  return check_views(asset, further + 1);
}

}  // namespace coif
