#include "validate/doubtful_asset.h"

namespace coif {
namespace {

void remove_mesh(AssetContents& asset) {
  asset.vertices.clear();
  asset.skin.clear();
  asset.indices.clear();
  asset.patches.clear();
  asset.lods.clear();
  asset.lod_bones.clear();
  asset.orders.clear();
  asset.order_views.clear();
}

/// Both patches of the finest level become one, whose triangles share no place.
void join_patches(AssetContents& asset) {
  asset.patches[0].index_count = 6;
  asset.patches.erase(asset.patches.begin() + 1);
  for (std::uint32_t place = 0; place < 2; ++place) asset.patches[place].file_place = place;
  asset.lods[0].patch_count = 1;
  asset.lods[1].first_patch = 1;
}

/// Nine patches of one triangle.
void shatter(AssetContents& asset) {
  asset.lods.clear();
  asset.lod_bones.clear();
  asset.orders.clear();
  asset.order_views.clear();
  asset.patches.clear();
  asset.indices.clear();
  for (std::uint32_t place = 0; place < 9; ++place) {
    asset.patches.push_back({3 * place, 3, 0.1f, 2, place});
    for (std::uint32_t k = 0; k < 3; ++k) asset.indices.push_back(k);
  }
}

void set_texture(AssetContents& asset, std::uint32_t width, std::uint32_t mips, std::uint64_t bytes) {
  asset.textures[0].width = width;
  asset.textures[0].mip_count = mips;
  asset.textures[0].bytes = bytes;
  asset.texels.resize(bytes);
}

/// 32 x 32 texels, solid; in smaller mips hardly there.
void fade_mips(AssetContents& asset) {
  asset.textures[0].height = 32;
  set_texture(asset, 32, 6, 4 * (1024 + 256 + 64 + 16 + 4 + 1));
  std::ranges::fill(asset.texels, std::byte{255});
  std::fill(asset.texels.begin() + 4 * 1024, asset.texels.end(), std::byte{40});
}

void blend_nothing(AssetContents& asset) { asset.material[0].discard_threshold = asset.material[0].opaque_threshold; }

constexpr Doubt kDoubts[] = {
    {"A201", remove_mesh},
    {"A204", [](AssetContents& asset) { asset.textures.clear(), asset.texels.clear(); }},
    {"A231", [](AssetContents& asset) { std::copy_n(asset.vertices[0].position, 3, asset.vertices[1].position); }},
    {"A232",
     [](AssetContents& asset) {
       asset.vertices.push_back(asset.vertices.back());
       asset.skin.push_back(asset.skin.back());
     }},
    {"A233",
     [](AssetContents& asset) {
       for (std::size_t i = 0; i < 3; ++i) asset.vertices[i].normal[2] *= -1;
     }},
    {"A234",
     [](AssetContents& asset) {
       for (VertexRecord& vertex : asset.vertices) vertex.position[0] *= 100;
     }},
    {"A235",
     [](AssetContents& asset) {
       asset.lods[0].patch_count = 1;
       asset.lods[1] = {1, 2, asset.lods[1].screen_size, asset.lods[1].error};
       asset.orders.clear();
       asset.order_views.clear();
     }},
    {"A241", join_patches},
    {"A242", [](AssetContents& asset) { asset.vertices[2].position[0] = 1; }},
    {"A243", shatter},
    {"A251", blend_nothing},
    {"A252", blend_nothing},
    {"A253", [](AssetContents& asset) { std::ranges::fill(asset.order_views, std::uint8_t{1}); }},
    {"A261",
     [](AssetContents& asset) {
       for (SkinRecord& skin : asset.skin) skin.bone[0] = 0;
     }},
    {"A262", [](AssetContents& asset) { asset.vertices[8].position[0] = 1; }},
    {"A271", [](AssetContents& asset) { set_texture(asset, 3, 2, 4 * (3 * 2 + 1)); }},
    {"A272", [](AssetContents& asset) { set_texture(asset, 4, 1, 4 * 4 * 2); }},
    {"A273", [](AssetContents& asset) { std::ranges::fill(asset.texels, std::byte{255}); }},
    {"A274",
     [](AssetContents& asset) {
       std::ranges::fill(asset.texels, std::byte{0});
       asset.material[0].discard_threshold = 0.02f;
     }},
    {"A277", fade_mips},
    {"A275",
     [](AssetContents& asset) {
       for (VertexRecord& vertex : asset.vertices) vertex.uv[0] *= 15'000, vertex.uv[1] *= 15'000;
     }},
    {"A276",
     [](AssetContents& asset) {
       for (std::size_t i = 0; i < 3; ++i) asset.vertices[i].uv[0] = asset.vertices[i].uv[1] = 0.5f;
     }},
};

}  // namespace

std::span<const Doubt> surface_doubts() { return kDoubts; }

}  // namespace coif
