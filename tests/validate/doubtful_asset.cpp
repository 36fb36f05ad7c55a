#include "validate/doubtful_asset.h"

#include "formats/small_asset.h"

namespace coif {

AssetContents sound_asset() {
  AssetContents asset = small_asset();
  // Without its chain of one bone.
  asset.bones.pop_back();
  asset.bone_names.pop_back();
  asset.chains.pop_back();
  asset.dynamics.pop_back();
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

}  // namespace coif
