#include "render/kept_order.h"

#include <coif/renderer.h>

#include <algorithm>
#include <span>
#include <string>

namespace coif::render {

tl::expected<std::unique_ptr<KeptBoneOrder>, ToolError> KeptBoneOrder::create(const Asset& asset) {
  std::unique_ptr<KeptBoneOrder> kept(new KeptBoneOrder(BoneOrder::memory_bytes(asset)));
  const Status status = kept->order_.create(asset, std::as_writable_bytes(std::span(kept->units_)));
  if (status == Status::kOk) return kept;
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, std::string("its bones cannot be sorted: ") + describe(status)});
}

std::uint32_t stream_bytes_for(const Asset& asset) {
  constexpr std::uint64_t kBeside = 512u << 10, kParts = 4, kMost = 256u << 20;  // see RendererDesc
  const std::uint64_t head = asset.indices().size_bytes() + kBeside;
  return std::uint32_t(std::clamp<std::uint64_t>(kParts * head, RendererDesc{}.stream_bytes, kMost));
}

}  // namespace coif::render
