#pragma once

#include "base/tool_error.h"

#include <coif/asset.h>
#include <coif/triangle_order.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace coif::render {

/// Orders of triangles that tools offer: the command line's words.
enum class OrderChoice : std::uint8_t {
  kCooked,  ///< The asset's own.
  kBones,   ///< BoneOrder.
};

/// A BoneOrder and the memory it lives in.
class KeptBoneOrder {
 public:
  /// Error (kBadInput): all hair hangs on the head itself. The asset may go.
  static tl::expected<std::unique_ptr<KeptBoneOrder>, ToolError> create(const Asset& asset);

  [[nodiscard]] BoneOrder& order() { return order_; }
  /// Bytes taken from the host.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  explicit KeptBoneOrder(std::size_t bytes) : units_((bytes + sizeof(Unit) - 1) / sizeof(Unit)), bytes_(bytes) {}

  struct alignas(BoneOrder::kAlignment) Unit {
    std::byte bytes[BoneOrder::kAlignment];
  };
  std::vector<Unit> units_;
  std::size_t bytes_;
  BoneOrder order_;
};

/// RendererDesc::stream_bytes with which this asset's heads can be drawn in orders of their own, if that is possible.
[[nodiscard]] std::uint32_t stream_bytes_for(const Asset& asset);

}  // namespace coif::render
