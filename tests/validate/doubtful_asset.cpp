#include "validate/doubtful_asset.h"

#include "models/small_asset.h"

namespace coif::validate {

AssetContents sound_asset() {
  AssetContents asset = small_asset();
  // Without its chain of one bone.
  asset.bones.pop_back();
  asset.bone_names.pop_back();
  asset.chains.pop_back();
  asset.dynamics.pop_back();
  asset.asked.clear();
  clear_group("body", asset);
  clear_group("limits", asset);
  clear_group("links", asset);
  asset.lod_bones.pop_back();
  for (SkinRecord& skin : asset.skin) skin.bone[0] = std::min<std::uint16_t>(skin.bone[0], 3);
  for (PatchRecord& patch : asset.patches) patch.bone = std::min(patch.bone, 3u);
  // Bones amid the patches, which start at x = 0 and lie at z = 0.1.
  for (std::size_t i = 1; i < asset.bones.size(); ++i) asset.bones[i].joint[0] = asset.bones[i].joint[2] = 0.1f;
  // One collider, above all hair.
  asset.colliders.resize(1);
  asset.colliders[0].center[1] = 0.3f;
  for (BoneRecord& bone : asset.bones) bone.colliders = bone.kind == BoneKind::kSimulated ? 1 : 0;
  // One texture, with all of its mips.
  asset.textures.pop_back();
  asset.texels.resize(asset.textures[0].bytes);
  return asset;
}

std::set<std::string> codes_of(const AssetContents& contents) {
  AlignedBytes file(write_asset(contents));
  Asset asset;
  const LoadStatus status = asset.open(file.bytes());
  char text[256];
  describe(status, text, sizeof text);
  EXPECT_TRUE(bool(status)) << text;
  return status ? codes_of(find_asset_issues(asset)) : std::set<std::string>{};
}

namespace {

/// Appends a bone to the only chain.
void grow(AssetContents& asset, float length) {
  BoneRecord bone = asset.bones.back();
  bone.parent = std::uint32_t(asset.bones.size() - 1);
  bone.joint[1] -= asset.bones.back().length;
  bone.length = length;
  asset.bones.push_back(bone);
  asset.bone_names.push_back("tip");
  asset.dynamics.push_back(asset.dynamics.back());
  asset.lod_bones.push_back(1);
  ++asset.chains[0].bone_count;
}

void make_rigid(AssetContents& asset) {
  asset.bones.resize(2);
  asset.bone_names.resize(2);
  for (SkinRecord& skin : asset.skin) skin.bone[0] = 0;
  for (PatchRecord& patch : asset.patches) patch.bone = 0;
  asset.chains.clear();
  asset.dynamics.clear();
  asset.tuning.clear();
  asset.quality.clear();
  asset.lod_bones = {0, 0};
}

void add_stub(AssetContents& asset) {
  BoneRecord bone = asset.bones[2];
  bone.parent = 0;
  bone.chain = 1;
  bone.joint[1] = 0;
  asset.bones.push_back(bone);
  asset.bone_names.push_back("stub");
  asset.dynamics.push_back(asset.dynamics.back());
  asset.lod_bones.push_back(1);
  asset.chains.push_back({4, 1, 0, {}});
}

void reach_no_collider(AssetContents& asset) {
  for (BoneRecord& bone : asset.bones) bone.colliders = 0;
}

/// A ball on the chest that no bone may touch.
void hang_idle_ball(AssetContents& asset) {
  const AssetContents whole = small_asset();
  asset.body_bone_names = {"Chest"};
  asset.body_bones = {whole.body_bones[1]};
  asset.body_colliders = {whole.body_colliders[0]};
  asset.body_sets.assign(asset.bones.size(), 0);
}

/// A second chain beside the first, held closer to it than it was modelled.
void link_too_short(AssetContents& asset) {
  add_stub(asset);
  asset.bones[4].joint[0] += 0.1f;
  asset.links = {{4, 2, 0.01f, 0.05f}};
}

constexpr Doubt kBodyDoubts[] = {
    {"A202", make_rigid},
    {"A203", [](AssetContents& asset) { reach_no_collider(asset), asset.colliders.clear(); }},
    {"A205", [](AssetContents& asset) { std::copy_n(asset.bones[3].joint, 3, asset.colliders[0].center); }},
    {"A207",
     [](AssetContents& asset) {
       for (SkinRecord& skin : asset.skin) skin.bone[0] = 2;
     }},
    {"A211", add_stub},
    {"A212", [](AssetContents& asset) { asset.bones[3].length = 0.0005f; }},
    {"A213", [](AssetContents& asset) { grow(asset, 0.1f), grow(asset, 0.1f), grow(asset, 0.6f); }},
    {"A221", reach_no_collider},
    {"A221", hang_idle_ball},
    {"A222", [](AssetContents& asset) { asset.dynamics[3].resistance = asset.dynamics[3].stiffness = 0; }},
    {"A223", [](AssetContents& asset) { asset.dynamics[2].resistance = 1; }},
    {"A224", link_too_short},
    {"A281", [](AssetContents& asset) { asset.tuning[0].asked_error = 0.001f; }},
    {"A281", [](AssetContents& asset) { asset.tuning[0].asked_cost = 1000; }},
    {"A282", [](AssetContents& asset) { asset.quality[0].rms_error = 0.05f; }},
    {"A283", [](AssetContents& asset) { clear_group("tuning", asset); }},
    {"A291",
     [](AssetContents& asset) {
       asset.provenance.resize(1);
       asset.provenance.back().flags = kProvenanceDraft;
     }},
    {"A284", [](AssetContents& asset) { asset.quality[1].penetration = 0.1f; }},
    {"A285", [](AssetContents& asset) { asset.quality[1].stretch = 0.02f; }},
};

}  // namespace

std::span<const Doubt> body_doubts() { return kBodyDoubts; }

namespace {

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
  clear_group("lods", asset);
  clear_group("orders", asset);
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

constexpr Doubt kSurfaceDoubts[] = {
    {"A201", [](AssetContents& asset) { clear_group("mesh", asset); }},
    {"A204", [](AssetContents& asset) { clear_group("textures", asset); }},
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
       clear_group("orders", asset);
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

std::span<const Doubt> surface_doubts() { return kSurfaceDoubts; }

}  // namespace coif::validate
