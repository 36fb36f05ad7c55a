#include "validate/asset_checks.h"

#include <fmt/format.h>

#include <cstddef>

namespace coif {
namespace {

void find_unused_orders(const Asset& asset, Issues& issues) {
  std::vector<bool> used(asset.order_count(), false);
  for (const std::uint8_t order : asset.order_views()) used[order] = true;
  // Order 0 is that of the triangles themselves and costs nothing.
  for (std::size_t i = 1; i < used.size(); ++i) {
    if (!used[i]) issues.push_back(make_issue("A253", "no direction uses it", fmt::format("draw order {}", i)));
  }
}

}  // namespace

void check_orders(const Asset& asset, Issues& issues) {
  if (asset.orders().empty()) return;
  find_unused_orders(asset, issues);
  if (asset.material() == nullptr || blends(*asset.material())) return;
  issues.push_back(make_issue(
      "A251", fmt::format("nothing is blended; {} bytes of orders have no effect", asset.orders().size_bytes()),
      "chunk ORDR"));
}

}  // namespace coif
