#include "chunk_checks.h"

namespace coif {
namespace {

LoadStatus order_error(LoadCode code, std::size_t item, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kOrders, item, expected, found};
}

/// Spreads a patch's number over all bits, so that sums of the results tell one set of patches from another. Source:
/// the finaliser of SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
std::uint64_t scatter(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

/// What two lists of the same patches have in common, in whatever order.
struct Drawn {
  std::uint64_t patches = 0;  ///< Sum of scatter().
  std::uint64_t indices = 0;  ///< The room that an uploader needs for them.

  void add(const Asset& asset, std::uint32_t patch) {
    patches += scatter(patch + std::uint64_t{1});
    indices += asset.patches()[patch].index_count;
  }
};

/// One level's range of positions in all further orders. A list without the memory for a mark per patch: a permutation is
/// proved by its sum, which is certain against accidents, and that no list is longer than the level by counting.
LoadStatus check_level(const Asset& asset, std::uint32_t first, std::uint32_t count) {
  Drawn level;
  for (std::uint32_t p = first; p < first + count; ++p) level.add(asset, p);
  const auto orders = asset.orders();
  for (std::size_t start = first; start < orders.size(); start += asset.patches().size()) {
    Drawn drawn;
    for (std::size_t i = start; i < start + count; ++i) {
      const std::uint32_t patch = orders[i];
      if (patch < first || patch - first >= count) return order_error(LoadCode::kReference, i, first + count, patch);
      drawn.add(asset, patch);
    }
    if (drawn.indices != level.indices) return order_error(LoadCode::kOrderCover, start, level.indices, drawn.indices);
    if (drawn.patches != level.patches) return order_error(LoadCode::kOrderCover, start);
  }
  return {};
}

LoadStatus check_views(const Asset& asset) {
  const auto views = asset.order_views();
  if (views.size() != kViewCells) return {LoadCode::kChunkSize, chunk::kOrderViews, 0, kViewCells, views.size()};
  const std::size_t count = 1 + asset.orders().size() / asset.patches().size();
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i] >= count) return {LoadCode::kReference, chunk::kOrderViews, i, count, views[i]};
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
  const std::size_t patches = asset.patches().size();
  if (patches == 0) return {LoadCode::kChunkMissing, chunk::kPatches};
  if (orders.size() % patches != 0) return order_error(LoadCode::kChunkSize, 0, patches, orders.size());
  if (orders.size() / patches >= kMaxOrders) {
    return order_error(LoadCode::kChunkSize, 0, kMaxOrders - 1, orders.size() / patches);
  }
  if (asset.lods().empty()) {
    if (const LoadStatus status = check_level(asset, 0, std::uint32_t(patches)); !status) return status;
  }
  for (const LodRecord& lod : asset.lods()) {
    if (const LoadStatus status = check_level(asset, lod.first_patch, lod.patch_count); !status) return status;
  }
  return check_views(asset);
}

}  // namespace coif
