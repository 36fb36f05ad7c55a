#include "validate/doubtful_asset.h"

namespace coif {
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
  asset.chains.push_back({4, 1, 0, 0});
}

void reach_no_collider(AssetContents& asset) {
  for (BoneRecord& bone : asset.bones) bone.colliders = 0;
}

constexpr Doubt kDoubts[] = {
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
    {"A222", [](AssetContents& asset) { asset.dynamics[3].resistance = asset.dynamics[3].stiffness = 0; }},
    {"A223", [](AssetContents& asset) { asset.dynamics[2].resistance = 1; }},
    {"A281", [](AssetContents& asset) { asset.tuning[0].asked_error = 0.001f; }},
    {"A281", [](AssetContents& asset) { asset.tuning[0].asked_cost = 1000; }},
    {"A282", [](AssetContents& asset) { asset.quality[0].rms_error = 0.05f; }},
    {"A283", [](AssetContents& asset) { asset.tuning.clear(), asset.quality.clear(); }},
    {"A284", [](AssetContents& asset) { asset.quality[1].penetration = 0.1f; }},
    {"A285", [](AssetContents& asset) { asset.quality[1].stretch = 0.02f; }},
};

}  // namespace

std::span<const Doubt> body_doubts() { return kDoubts; }

}  // namespace coif
