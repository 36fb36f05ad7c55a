#include "gl/alpha_range.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {
namespace {

struct ByteRange {
  std::uint8_t lowest = 255;
  std::uint8_t highest = 0;

  [[nodiscard]] bool is_everything() const { return lowest == 0 && highest == 255; }
};

constexpr std::size_t kTexelBytes = 4;  // kSrgb8Alpha8, alpha last

void widen(ByteRange& range, std::span<const std::byte> texels) {
  for (std::size_t i = kTexelBytes - 1; i < texels.size(); i += kTexelBytes) {
    const auto alpha = std::to_integer<std::uint8_t>(texels[i]);
    if (alpha < range.lowest) range.lowest = alpha;
    if (alpha > range.highest) range.highest = alpha;
  }
}

}  // namespace

AlphaRange alpha_range_of(const Asset& asset) {
  const TextureRecord* const record = asset.texture(TextureRole::kBaseColor);
  if (record == nullptr) return {};
  if (record->format != TexelFormat::kSrgb8Alpha8) return {0, 1};
  ByteRange range;
  for (std::uint32_t mip = 0; mip < record->mip_count; ++mip) {
    std::span<const std::byte> left = asset.texels(*record, mip);
    while (!left.empty()) {
      constexpr std::size_t kSome = 4096;  // bytes between two looks at whether there is more to find
      const std::size_t some = left.size() < kSome ? left.size() : kSome;
      widen(range, left.first(some));
      if (range.is_everything()) return {0, 1};
      left = left.subspan(some);
    }
  }
  return {float(range.lowest) / 255, float(range.highest) / 255};
}

}  // namespace coif
