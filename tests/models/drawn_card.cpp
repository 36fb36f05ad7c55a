#include "models/drawn_card.h"

#include "models/small_asset.h"

#include <coif/view_cells.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coif {
namespace {

std::int16_t snorm(float value) { return static_cast<std::int16_t>(std::lround(value * 32767)); }

void add_card(AssetContents& out, const DrawnCard& card, float u) {
  const auto first_vertex = static_cast<std::uint32_t>(out.vertices.size());
  const auto first_index = static_cast<std::uint32_t>(out.indices.size());
  for (const auto& [x, y] : {std::array{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
    VertexRecord v{};
    v.position[0] = card.center[0] + x * card.half_size;
    v.position[1] = card.center[1] + y * card.half_size;
    v.position[2] = card.center[2];
    for (std::size_t i = 0; i < 3; ++i) {
      v.normal[i] = snorm(card.normal[i]);
      v.tangent[i] = snorm(card.tangent[i]);
    }
    v.normal[3] = snorm(1);
    v.uv[0] = u;  // the same at all corners: the card's own texel, unfiltered
    v.uv[1] = 0.5f;
    out.vertices.push_back(v);
    out.skin.push_back(card.skin);
  }
  const std::array<std::uint32_t, 6> front{0, 1, 2, 0, 2, 3};
  const std::array<std::uint32_t, 6> back{0, 2, 1, 0, 3, 2};
  for (const std::uint32_t corner : card.turned ? back : front) out.indices.push_back(first_vertex + corner);
  out.patches.push_back({first_index, 6, 0, 0, std::uint32_t(out.patches.size())});
}

void add_texture(AssetContents& out, TextureRole role, TexelFormat format, std::span<const std::uint8_t> texels,
                 std::uint32_t width) {
  out.texels.resize((out.texels.size() + 15) / 16 * 16);  // textures start at multiples of 16
  const auto bytes = std::as_bytes(texels);
  out.textures.push_back({role, format, width, 1, 1, 0, out.texels.size(), bytes.size()});
  out.texels.insert(out.texels.end(), bytes.begin(), bytes.end());
}

}  // namespace

MaterialRecord plain_material() {
  MaterialRecord m{};
  std::fill_n(m.base_color, 4, 1.0f);
  std::fill_n(m.ambient, 3, 1.0f);
  m.primary_exponent = m.secondary_exponent = 100;
  m.opaque_threshold = 0.9f;
  m.discard_threshold = 0.1f;
  m.flags = kMaterialDoubleSided;
  return m;
}

AssetContents card_contents(std::span<const DrawnCard> cards, std::uint32_t bones) {
  AssetContents out;
  out.skeleton.head_rotation[3] = 1;
  out.bones = rigid_bones(bones);
  std::vector<std::uint8_t> colors;
  std::vector<std::uint8_t> shift_masks;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    add_card(out, cards[i], (static_cast<float>(i) + 0.5f) / static_cast<float>(cards.size()));
    colors.insert(colors.end(), cards[i].rgba.begin(), cards[i].rgba.end());
    shift_masks.insert(shift_masks.end(), cards[i].shift_mask.begin(), cards[i].shift_mask.end());
  }
  const auto width = static_cast<std::uint32_t>(cards.size());
  add_texture(out, TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, colors, width);
  add_texture(out, TextureRole::kShiftMask, TexelFormat::kRg8, shift_masks, width);
  out.material.push_back(plain_material());
  return out;
}

std::vector<std::uint8_t> second_from_behind() {
  std::vector<std::uint8_t> orders(kViewCells);
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
    float direction[3];
    view_cell_direction(cell, direction);
    orders[cell] = direction[2] < 0 ? 1 : 0;
  }
  return orders;
}

DrawnAsset::DrawnAsset(std::span<const std::byte> bytes) : memory_((bytes.size() + 63) / 64) {
  std::memcpy(memory_.data(), bytes.data(), bytes.size());
  const LoadStatus status = asset_.open({memory_.front().bytes, bytes.size()});
  char text[256];
  describe(status, text, sizeof text);
  EXPECT_TRUE(status) << text;
}

}  // namespace coif
