#include "report/order/drawn_way.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace coif::report {
namespace {

constexpr std::size_t kTexelAlignment = 16;  // Alignment of each texture in the format.

template <typename Record>
std::vector<Record> copy(std::span<const Record> records) {
  return {records.begin(), records.end()};
}

/// Patches by a key, equal ones in stored order.
template <typename Key>
AssetContents sorted_by(AssetContents contents, Key key) {
  std::vector<PatchRecord> patches = contents.patches;
  std::ranges::stable_sort(patches, {}, key);
  std::vector<std::uint32_t> indices;
  for (PatchRecord& patch : patches) {
    const auto first = contents.indices.begin() + patch.first_index;
    patch.first_index = std::uint32_t(indices.size());
    indices.insert(indices.end(), first, first + patch.index_count);
  }
  contents.patches = std::move(patches);
  contents.indices = std::move(indices);
  return in_stored_order(std::move(contents));
}

std::vector<std::string> bone_names(const Asset& asset) {
  std::vector<std::string> names;
  for (std::uint32_t bone = 0; bone < asset.bones().size(); ++bone) names.emplace_back(asset.bone_name(bone));
  return names;
}

/// Orders are of triangles, the finest level's first.
void copy_orders(const Asset& asset, AssetContents& contents) {
  const std::size_t all = asset.indices().size() / 3, kept = contents.indices.size() / 3;
  for (std::size_t begin = 0; begin < asset.orders().size(); begin += all) {
    const auto order = asset.orders().subspan(begin, kept);
    contents.orders.insert(contents.orders.end(), order.begin(), order.end());
  }
  contents.order_views = copy(asset.order_views());
}

void copy_textures(const Asset& asset, std::span<const TextureRecord> from, std::vector<TextureRecord>& records,
                   std::vector<std::byte>& texels) {
  for (TextureRecord texture : from) {
    texels.resize((texels.size() + kTexelAlignment - 1) / kTexelAlignment * kTexelAlignment);
    const std::uint64_t offset = texels.size();
    for (std::uint32_t mip = 0; mip < texture.mip_count; ++mip) {
      const auto bytes = asset.texels(texture, mip);
      texels.insert(texels.end(), bytes.begin(), bytes.end());
    }
    texture.offset = offset;
    texture.bytes = texels.size() - offset;
    records.push_back(texture);
  }
}

/// Copies everything that drawing needs besides the patches.
void copy_appearance(const Asset& asset, AssetContents& contents) {
  contents.vertices = copy(asset.vertices());
  contents.skin = copy(asset.skin());
  if (asset.material() != nullptr) contents.material = {*asset.material()};
  copy_textures(asset, asset.textures(), contents.textures, contents.texels);
  copy_textures(asset, asset.reliefs(), contents.reliefs, contents.relief_texels);
}

struct Unit {
  Eigen::Vector3f corners = Eigen::Vector3f::Zero();  ///< Sum.
  float count = 0;
};

}  // namespace

AssetContents finest_level(const Asset& asset) {
  AssetContents contents;
  contents.skeleton = asset.skeleton();
  contents.bones = copy(asset.bones());
  contents.bone_names = bone_names(asset);
  contents.chains = copy(asset.chains());
  contents.dynamics = copy(asset.dynamics());
  contents.links = copy(asset.links());
  contents.colliders = copy(asset.colliders());
  contents.patches = copy(asset.lod_patches(0));
  contents.indices = copy(asset.lod_indices(0));
  copy_orders(asset, contents);
  copy_appearance(asset, contents);
  return contents;
}

void set_faces(AssetContents& contents, bool together) {
  for (MaterialRecord& material : contents.material) {
    material.flags = together ? material.flags | kMaterialFacesTogether : material.flags & ~kMaterialFacesTogether;
  }
}

AssetContents in_file_order(AssetContents finest) {
  set_faces(finest, false);
  return sorted_by(std::move(finest), &PatchRecord::file_place);
}

AssetContents in_head_order(AssetContents finest) {
  set_faces(finest, false);
  return sorted_by(std::move(finest), &PatchRecord::head_distance);
}

AssetContents in_stored_order(AssetContents finest) {
  finest.orders.clear();
  finest.order_views.clear();
  return finest;
}

std::vector<std::uint32_t> far_to_near(std::span<const std::uint32_t> indices,
                                       std::span<const std::uint32_t> unit_of_triangle,
                                       std::span<const Eigen::Vector3f> positions, const Eigen::Vector3f& eye) {
  std::vector<Unit> units(unit_of_triangle.empty() ? 0 : 1 + std::ranges::max(unit_of_triangle));
  for (std::size_t t = 0; t < unit_of_triangle.size(); ++t) {
    Unit& unit = units[unit_of_triangle[t]];
    unit.corners += positions[indices[3 * t]] + positions[indices[3 * t + 1]] + positions[indices[3 * t + 2]];
    unit.count += 3;
  }
  std::vector<float> distance(units.size(), 0);
  for (std::size_t u = 0; u < units.size(); ++u) {
    if (units[u].count > 0) distance[u] = (units[u].corners / units[u].count - eye).squaredNorm();
  }
  std::vector<std::uint32_t> order(unit_of_triangle.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t unit_a = unit_of_triangle[a], unit_b = unit_of_triangle[b];
    return distance[unit_a] != distance[unit_b] ? distance[unit_a] > distance[unit_b] : unit_a < unit_b;
  });
  std::vector<std::uint32_t> sorted;
  sorted.reserve(indices.size());
  for (const std::uint32_t t : order) sorted.insert(sorted.end(), &indices[3 * t], &indices[3 * t] + 3);
  return sorted;
}

std::vector<std::uint32_t> each_triangle(const AssetContents& finest) {
  std::vector<std::uint32_t> own(finest.indices.size() / 3);
  std::iota(own.begin(), own.end(), 0u);
  return own;
}

AssetContents sorted_by_unit(AssetContents finest, std::span<const std::uint32_t> unit_of_triangle,
                             std::span<const Eigen::Vector3f> positions, const Eigen::Vector3f& eye) {
  finest.indices = far_to_near(finest.indices, unit_of_triangle, positions, eye);
  PatchRecord all = finest.patches.front();
  all.first_index = 0;
  all.index_count = std::uint32_t(finest.indices.size());
  finest.patches = {all};
  return in_stored_order(std::move(finest));
}

}  // namespace coif::report
