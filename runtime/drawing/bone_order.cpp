#include <coif/triangle_order.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coif {
namespace {

constexpr std::uint32_t kCorners = 3, kInfluences = 4;

std::size_t aligned(std::size_t bytes) {
  return (bytes + BoneOrder::kAlignment - 1) / BoneOrder::kAlignment * BoneOrder::kAlignment;
}

/// Bytes per index on the GPU, as DrawnHair::index_bytes.
std::uint32_t bytes_of_index(const Asset& asset) { return asset.vertices().size() <= 0xFFFF ? 2 : 4; }

bool has_skinned_mesh(const Asset& asset) {
  return asset.is_open() && !asset.indices().empty() && !asset.skin().empty() && !asset.bones().empty();
}

std::size_t most_groups(const Asset& asset) {
  std::size_t most = 0;
  for (std::uint32_t lod = 0; lod < asset.lod_count(); ++lod) {
    most += std::min(asset.bones().size(), asset.lod_indices(lod).size() / kCorners);
  }
  return most;
}

/// The bone that moves a triangle's three corners most; among equals the one met first.
std::uint32_t leading_bone(std::span<const SkinRecord> skin, const std::uint32_t* corners) {
  std::uint32_t leading = 0;
  int most = -1;
  for (std::uint32_t i = 0; i < kCorners * kInfluences; ++i) {
    const std::uint32_t bone = skin[corners[i / kInfluences]].bone[i % kInfluences];
    int weight = 0;
    for (std::uint32_t k = 0; k < kCorners * kInfluences; ++k) {
      const SkinRecord& corner = skin[corners[k / kInfluences]];
      if (corner.bone[k % kInfluences] == bone) weight += corner.weight[k % kInfluences];
    }
    if (weight > most) leading = bone, most = weight;
  }
  return leading;
}

Vec3 moved(const Mat34& matrix, const Vec3& p) {
  const auto row = [&](const float(&m)[4]) { return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3]; };
  return {row(matrix.m[0]), row(matrix.m[1]), row(matrix.m[2])};
}

/// From the world to head space. Computed in double, because a head may be far from the world's origin.
Vec3 in_head_space(const HeadPose& head, const Vec3& eye) {
  const double v[3] = {eye.x - head.position[0], eye.y - head.position[1], eye.z - head.position[2]};
  // Rotation by the conjugate: v + 2 w (v x q) + 2 q x (q x v), for a quaternion that is nearly unit.
  const double q[3] = {head.rotation.x, head.rotation.y, head.rotation.z}, w = head.rotation.w;
  const double c[3] = {v[1] * q[2] - v[2] * q[1], v[2] * q[0] - v[0] * q[2], v[0] * q[1] - v[1] * q[0]};
  const double d[3] = {c[1] * q[2] - c[2] * q[1], c[2] * q[0] - c[0] * q[2], c[0] * q[1] - c[1] * q[0]};
  const auto at = [&](int i) { return static_cast<float>((v[i] + 2 * (w * c[i] + d[i])) / double(head.scale)); };
  return {at(0), at(1), at(2)};
}

float square_distance(const Vec3& a, const Vec3& b) {
  const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  const float square = x * x + y * y + z * z;
  return square >= 0 ? square : 0;  // A palette with a NaN draws nonsense, but can be sorted.
}

}  // namespace

/// Divides an asset's triangles among its bones.
struct BoneOrder::Builder {
  const Asset& asset;
  BoneOrder& order;
  /// One for each bone: first the number of its triangles' indices, then the place of its next triangle.
  std::uint32_t* counts;

  void add_level(std::uint32_t lod, std::uint32_t first_group) {
    const std::size_t first_index = asset.lod_patches(lod).front().first_index;
    const std::size_t begin = first_index / kCorners, end = begin + asset.lod_indices(lod).size() / kCorners;
    std::fill(counts, counts + asset.bones().size(), 0u);
    for (std::size_t triangle = begin; triangle < end; ++triangle) counts[bone_of(triangle)] += kCorners;
    Level& level = order.levels_[lod];
    level = {first_group, 0};
    auto next = static_cast<std::uint32_t>(first_index);
    for (std::uint32_t bone = 0; bone < asset.bones().size(); ++bone) {
      if (counts[bone] == 0) continue;
      order.groups_[level.first + level.count++] = {{}, bone, next, counts[bone]};
      next += counts[bone];
    }
    for (std::uint32_t number = 0; number < asset.order_count(); ++number) add_order(level, number, begin, end);
    for (Group& group : std::span(order.groups_ + level.first, level.count)) group.middle = middle_of(group);
  }

  /// Adds the level's triangles, bone by bone. They have the places from `begin` to `end` in each of the asset's
  /// orders.
  void add_order(const Level& level, std::uint32_t number, std::size_t begin, std::size_t end) {
    const std::size_t triangles = asset.indices().size() / kCorners;
    const std::size_t copy = number * asset.indices().size();
    for (const Group& group : std::span(order.groups_ + level.first, level.count)) counts[group.bone] = group.first;
    for (std::size_t place = begin; place < end; ++place) {
      const std::size_t triangle = number == 0 ? place : asset.orders()[(number - 1) * triangles + place];
      std::uint32_t& to = counts[bone_of(triangle)];
      for (std::uint32_t k = 0; k < kCorners; ++k) put(copy + to++, asset.indices()[kCorners * triangle + k]);
    }
  }

  [[nodiscard]] std::uint32_t bone_of(std::size_t triangle) const {
    return leading_bone(asset.skin(), &asset.indices()[kCorners * triangle]);
  }

  void put(std::size_t place, std::uint32_t index) const {
    std::byte* const to = order.indices_ + place * order.index_bytes_;
    const auto narrow = static_cast<std::uint16_t>(index);
    order.index_bytes_ == sizeof narrow ? std::memcpy(to, &narrow, sizeof narrow)
                                        : std::memcpy(to, &index, sizeof index);
  }

  [[nodiscard]] std::uint32_t get(std::uint32_t place) const {
    std::uint32_t index = 0;  // Assets are little-endian.
    std::memcpy(&index, order.indices_ + std::size_t{place} * order.index_bytes_, order.index_bytes_);
    return index;
  }

  [[nodiscard]] Vec3 middle_of(const Group& group) const {
    double sum[3] = {};
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      for (int k = 0; k < 3; ++k) sum[k] += asset.vertices()[get(i)].position[k];
    }
    const auto mean = [&](int k) { return static_cast<float>(sum[k] / group.count); };
    return {mean(0), mean(1), mean(2)};
  }
};

std::size_t BoneOrder::memory_bytes(const Asset& asset) {
  if (!has_skinned_mesh(asset)) return 0;
  return aligned(most_groups(asset) * sizeof(Group)) + aligned(asset.bones().size() * sizeof(Key)) +
         asset.indices().size() * asset.order_count() * bytes_of_index(asset);
}

Status BoneOrder::create(const Asset& asset, std::span<std::byte> memory) {
  if (!has_skinned_mesh(asset)) return Status::kAssetLacksData;
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(memory.data()) % kAlignment == 0;
  if (memory.size() < memory_bytes(asset) || !is_aligned) return Status::kMemoryTooSmall;
  groups_ = reinterpret_cast<Group*>(memory.data());
  std::byte* const keys = memory.data() + aligned(most_groups(asset) * sizeof(Group));
  keys_ = reinterpret_cast<Key*>(keys);
  indices_ = keys + aligned(asset.bones().size() * sizeof(Key));
  index_bytes_ = bytes_of_index(asset);
  bone_count_ = static_cast<std::uint32_t>(asset.bones().size());
  indices_of_order_ = static_cast<std::uint32_t>(asset.indices().size());
  Builder builder{asset, *this, reinterpret_cast<std::uint32_t*>(keys)};
  std::fill(std::begin(order_of_view_), std::end(order_of_view_), std::uint8_t{0});
  std::copy(asset.order_views().begin(), asset.order_views().end(), order_of_view_);
  std::uint32_t groups = 0;
  for (std::uint32_t lod = 0; lod < kMaxLods; ++lod) {
    levels_[lod] = {};
    if (lod >= asset.lod_count()) continue;
    builder.add_level(lod, groups);
    groups += levels_[lod].count;
  }
  write_ = write_far_to_near;
  return Status::kOk;
}

// Where bones are equally far, the one with the lower number is drawn first, so that pictures are the same on every
// machine.
void BoneOrder::write_far_to_near(TriangleOrder& of, const HairInstance& head, const Vec3& eye, std::byte* out) {
  BoneOrder& order = static_cast<BoneOrder&>(of);
  const Level& level = order.levels_[head.lod];
  const Group* const groups = order.groups_ + level.first;
  const Vec3 from = in_head_space(head.head, eye);
  for (std::uint32_t g = 0; g < level.count; ++g) {
    order.keys_[g] = {square_distance(moved(head.palette[groups[g].bone], groups[g].middle), from), g};
  }
  std::sort(order.keys_, order.keys_ + level.count, [](const Key& a, const Key& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.group < b.group;
  });
  const std::uint32_t number = order.order_of_view_[view_cell({from.x, from.y, from.z})];
  const std::byte* const indices = order.indices_ + std::size_t{number} * order.indices_of_order_ * order.index_bytes_;
  for (std::uint32_t g = 0; g < level.count; ++g) {
    const Group& group = groups[order.keys_[g].group];
    const std::size_t bytes = std::size_t{group.count} * order.index_bytes_;
    std::memcpy(out, indices + std::size_t{group.first} * order.index_bytes_, bytes);
    out += bytes;
  }
}

}  // namespace coif
