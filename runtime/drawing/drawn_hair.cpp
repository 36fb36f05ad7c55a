#include <coif/drawing.h>
#include <coif/texel_blocks.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

// The thesis's Gallery 1, in a brown; for assets without a material of their own.
constexpr MaterialRecord kGalleryMaterial = {
    .base_color = {1.0f, 1.0f, 1.0f, 1.0f},
    .ambient = {0.1f, 0.1f, 0.1f},
    .opaque_threshold = 0.85f,
    .primary_color = {0.5f, 0.5f, 0.5f},
    .primary_exponent = 150.0f,
    .secondary_color = {0.5f, 0.4f, 0.3f},
    .secondary_exponent = 30.0f,
    .primary_shift = 0.7f,
    .secondary_shift = 0.5f,
    .discard_threshold = 0.02f,
    .flags = kMaterialDoubleSided,
    .shading = ShadingModel::kThesis,
    .tilt = 0.05f,
    .roughness = 0.14f,
    .scatter = 0.8f,
    .light_cut = 0.0f,
    .glow = 0.0f,
    .root_shade = 0.0f,
    .variation = 0.0f,
};

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

/// Ends where there is no more to find.
void widen_by_blocks(ByteRange& range, const Asset& asset, const TextureRecord& record) {
  std::byte rgba[kTexelBytes * kBlockTexels];
  for (std::uint32_t mip = 0; mip < record.mip_count; ++mip) {
    const std::span<const std::byte> blocks = asset.texels(record, mip);
    for (std::size_t at = 0; at < blocks.size() && !range.is_everything(); at += kColorBlockBytes) {
      decode_color_block(&blocks[at], rgba);
      widen(range, rgba);
    }
  }
}

constexpr float kSlack = 1.02f;  // Solvers hold lengths to a part in ten thousand; hosts with their own may not.

float distance(const float (&a)[3], const float (&b)[3]) {
  const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return std::sqrt(x * x + y * y + z * z);
}

/// Furthest that the start of `bone` may be from `center`.
float reach_of_joint(std::span<const BoneRecord> bones, std::uint32_t bone, const float (&center)[3]) {
  float length = 0;
  while (bones[bone].kind == BoneKind::kSimulated) {
    const std::uint32_t parent = bones[bone].parent;
    length += distance(bones[bone].joint, bones[parent].joint);
    bone = parent;
  }
  return length + distance(bones[bone].joint, center);
}

/// Furthest that a vertex may be from `center`.
float reach_of_vertex(const Asset& asset, std::size_t v, const float (&center)[3]) {
  const VertexRecord& vertex = asset.vertices()[v];
  if (asset.skin().empty()) return distance(vertex.position, center);
  float reach = 0;
  const SkinRecord& skin = asset.skin()[v];
  for (int k = 0; k < 4; ++k) {
    if (skin.weight[k] == 0) continue;
    const BoneRecord& bone = asset.bones()[skin.bone[k]];
    const float own = bone.kind == BoneKind::kSimulated
                          ? reach_of_joint(asset.bones(), skin.bone[k], center) + distance(vertex.position, bone.joint)
                          : distance(vertex.position, center);
    if (own > reach) reach = own;
  }
  return reach;
}

void find_middle(std::span<const VertexRecord> vertices, float (&middle)[3]) {
  for (int i = 0; i < 3; ++i) {
    float low = vertices.front().position[i], high = low;
    for (const VertexRecord& vertex : vertices) {
      if (vertex.position[i] < low) low = vertex.position[i];
      if (vertex.position[i] > high) high = vertex.position[i];
    }
    middle[i] = 0.5f * (low + high);
  }
}

/// Every vertex has all its weight on its first bone.
bool needs_one_bone(std::span<const SkinRecord> skin) {
  for (const SkinRecord& vertex : skin) {
    if (vertex.weight[0] != 255) return false;
  }
  return true;
}

Skinning skinning_of(const Asset& asset) {
  if (asset.skin().empty()) return Skinning::kRigid;
  return needs_one_bone(asset.skin()) ? Skinning::kOneBone : Skinning::kFourBones;
}

template <typename Index>
void write_orders(const Asset& asset, std::byte* out) {
  Index* next = reinterpret_cast<Index*>(out);
  const auto write = [&](std::span<const std::uint32_t> indices) {
    for (const std::uint32_t index : indices) *next++ = static_cast<Index>(index);
  };
  write(asset.indices());
  for (const std::uint32_t triangle : asset.orders()) write(asset.indices().subspan(3 * std::size_t{triangle}, 3));
}

}  // namespace

AlphaRange alpha_range_of(const Asset& asset) {
  const TextureRecord* const record = asset.texture(TextureRole::kBaseColor);
  if (record == nullptr) return {};
  ByteRange range;
  if (record->format == TexelFormat::kSrgb8Alpha8Etc2) {
    widen_by_blocks(range, asset, *record);
    return {float(range.lowest) / 255, float(range.highest) / 255};
  }
  if (record->format != TexelFormat::kSrgb8Alpha8) return {0, 1};
  for (std::uint32_t mip = 0; mip < record->mip_count; ++mip) {
    std::span<const std::byte> left = asset.texels(*record, mip);
    while (!left.empty()) {
      constexpr std::size_t kSome = 4096;  // Bytes between two looks at whether there is more to find.
      const std::size_t some = left.size() < kSome ? left.size() : kSome;
      widen(range, left.first(some));
      if (range.is_everything()) return {0, 1};
      left = left.subspan(some);
    }
  }
  return {float(range.lowest) / 255, float(range.highest) / 255};
}

Reach reach_of(const Asset& asset) {
  Reach reach{};
  find_middle(asset.vertices(), reach.center);
  for (std::size_t v = 0; v < asset.vertices().size(); ++v) {
    const float own = reach_of_vertex(asset, v, reach.center);
    if (own > reach.radius) reach.radius = own;
  }
  reach.radius *= kSlack;
  return reach;
}

DrawnHair drawn_hair_of(const Asset& asset) {
  DrawnHair hair;
  hair.material = asset.material() != nullptr ? *asset.material() : kGalleryMaterial;
  hair.bone_count = static_cast<std::uint32_t>(asset.bones().size());
  hair.skinning = skinning_of(asset);
  hair.alpha = alpha_range_of(asset);
  hair.lod_count = asset.lod_count();
  for (std::uint32_t lod = 0; lod < hair.lod_count; ++lod) {
    const auto count = static_cast<std::uint32_t>(asset.lod_indices(lod).size());
    hair.lods[lod] = {asset.lod_patches(lod).front().first_index, count};
  }
  hair.index_bytes = asset.vertices().size() <= 0xFFFF ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  hair.order_count = asset.order_count();
  hair.indices_of_order = static_cast<std::uint32_t>(asset.indices().size());
  std::copy(asset.order_views().begin(), asset.order_views().end(), hair.order_of_view);
  hair.reach = reach_of(asset);
  return hair;
}

void write_draw_orders(const Asset& asset, const DrawnHair& hair, std::span<std::byte> out) {
  if (out.size() != asset.indices().size() * asset.order_count() * hair.index_bytes) return;
  if (hair.index_bytes == sizeof(std::uint16_t)) {
    write_orders<std::uint16_t>(asset, out.data());
  } else {
    write_orders<std::uint32_t>(asset, out.data());
  }
}

}  // namespace coif
