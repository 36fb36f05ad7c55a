#include "chunk_checks.h"

namespace coif {
namespace {

LoadStatus bone_error(LoadCode code, std::size_t bone, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kBones, bone, expected, found};
}

LoadStatus check_bone_place(std::span<const BoneRecord> bones, std::size_t i) {
  const BoneRecord& bone = bones[i];
  if (bone.kind > BoneKind::kSimulated) {
    return bone_error(LoadCode::kEnumerator, i, std::uint64_t(BoneKind::kSimulated), std::uint64_t(bone.kind));
  }
  if (i == 0) {
    const bool head = bone.kind == BoneKind::kHead && bone.parent == kNone;
    return head ? LoadStatus{} : bone_error(LoadCode::kBoneOrder, i);
  }
  if (bone.kind == BoneKind::kHead || bone.kind < bones[i - 1].kind) return bone_error(LoadCode::kBoneOrder, i);
  if (bone.parent >= i) return bone_error(LoadCode::kBoneOrder, i, i - 1, bone.parent);
  if (is_rigid(bone) && !is_rigid(bones[bone.parent])) return bone_error(LoadCode::kBoneOrder, i);
  return {};
}

LoadStatus check_bone_shape(const BoneRecord& bone, std::size_t i) {
  if (!all_finite(bone.joint)) return bone_error(LoadCode::kNotFinite, i);
  if (is_rigid(bone)) {
    const bool rigid = bone.length == 0.0f && all_zero(bone.rest_direction) && bone.chain == kNone;
    return rigid ? LoadStatus{} : bone_error(LoadCode::kNotFinite, i);
  }
  const bool segment = in_range(bone.length, 1.0e-6f, kMaxCoordinate) && is_unit(bone.rest_direction);
  return segment ? LoadStatus{} : bone_error(LoadCode::kNotFinite, i);
}

/// The runtime hangs a bone on its simulated parent's particle, so skinning is right only if the bone starts there at
/// rest.
bool starts_at_parent(const BoneRecord& bone, const BoneRecord& parent) {
  constexpr float kTolerance = 1.0e-4f;  // Share of the coordinates' size: joints are rounded to float one by one.
  for (int k = 0; k < 3; ++k) {
    const float end = parent.joint[k] + parent.rest_direction[k] * parent.length;
    const float size = 1.0f + parent.length + (end < 0 ? -end : end);
    if (!in_range(bone.joint[k] - end, -kTolerance * size, kTolerance * size)) return false;
  }
  return true;
}

LoadStatus check_chain(const Asset& asset, std::size_t c, std::uint32_t expected_first) {
  const ChainRecord& chain = asset.chains()[c];
  const auto bones = asset.bones();
  const auto fail = [&](LoadCode code, std::uint64_t expected = 0, std::uint64_t found = 0) {
    return LoadStatus{code, chunk::kChains, c, expected, found};
  };
  if (chain.model > ChainModel::kPassive) return fail(LoadCode::kEnumerator, 0, std::uint32_t(chain.model));
  if (chain.first_bone != expected_first) return fail(LoadCode::kChainCover, expected_first, chain.first_bone);
  if (chain.bone_count == 0 || chain.bone_count > bones.size() - chain.first_bone) return fail(LoadCode::kChainCover);
  if (chain.root >= bones.size() || !is_rigid(bones[chain.root])) return fail(LoadCode::kReference);
  for (std::uint32_t i = chain.first_bone; i < chain.first_bone + chain.bone_count; ++i) {
    const bool inside = bones[i].parent == chain.root || (bones[i].parent >= chain.first_bone && i > chain.first_bone);
    if (bones[i].chain != c || !inside) return fail(LoadCode::kChainCover, c, bones[i].chain);
  }
  return {};
}

/// The bones that are open at one place of a chain. The walk starts at the chain's end, where a bone opens at its last
/// child.
class OpenBones {
 public:
  /// Returns false where there is no room. A bone that is open already changes nothing.
  bool open(std::uint32_t bone) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (bones_[i] == bone) return true;
    }
    if (count_ == kMaxOpenBones) return false;
    bones_[count_++] = bone;
    return true;
  }

  void close(std::uint32_t bone) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (bones_[i] == bone) bones_[i] = bones_[--count_];
    }
  }

 private:
  std::uint32_t bones_[kMaxOpenBones];
  std::uint32_t count_ = 0;
};

/// Runs after check_chain(), which proves that every parent is the root or inside the chain.
LoadStatus check_open_bones(const Asset& asset, std::size_t c) {
  const ChainRecord& chain = asset.chains()[c];
  OpenBones open;
  for (std::uint32_t i = chain.first_bone + chain.bone_count; i-- > chain.first_bone;) {
    const std::uint32_t parent = asset.bones()[i].parent;
    if (parent != chain.root && !open.open(parent)) {
      return {LoadCode::kOpenBones, chunk::kChains, c, kMaxOpenBones, kMaxOpenBones + 1};
    }
    open.close(i);
  }
  return {};
}

LoadStatus check_chains(const Asset& asset, std::uint32_t rigid_count) {
  std::uint32_t next = rigid_count;
  for (std::size_t c = 0; c < asset.chains().size(); ++c) {
    if (const LoadStatus status = check_chain(asset, c, next); !status) return status;
    if (const LoadStatus status = check_open_bones(asset, c); !status) return status;
    next += asset.chains()[c].bone_count;
  }
  if (next != asset.bones().size()) return {LoadCode::kChainCover, chunk::kChains, 0, asset.bones().size(), next};
  return {};
}

}  // namespace

LoadStatus check_names(const Asset& asset) {
  const auto names = asset.records<chunk::kNames>();
  const bool ended = names.empty() || names.back() == 0;
  return ended ? LoadStatus{} : LoadStatus{LoadCode::kName, chunk::kNames};
}

LoadStatus check_skeleton(const Asset& asset) {
  const SkeletonRecord& skeleton = asset.skeleton();
  const auto bones = asset.bones();
  const std::size_t name_bytes = asset.records<chunk::kNames>().size();
  const auto fail = [](LoadCode code, std::uint64_t expected = 0, std::uint64_t found = 0) {
    return LoadStatus{code, chunk::kSkeleton, 0, expected, found};
  };
  if ((skeleton.flags & ~kSkeletonFacesBackwards) != 0) return fail(LoadCode::kReserved);
  if (!(skeleton.air_lag >= 0.0f && skeleton.air_lag <= 1.0f)) return fail(LoadCode::kNotFinite);
  if (!all_finite(skeleton.head_joint) || !is_unit(skeleton.head_rotation)) return fail(LoadCode::kNotFinite);
  if (bones.size() > kMaxBones) return fail(LoadCode::kChunkSize, kMaxBones, bones.size());
  if (skeleton.bone_count != bones.size()) return fail(LoadCode::kChunkSize, bones.size(), skeleton.bone_count);
  if (skeleton.chain_count != asset.chains().size()) {
    return fail(LoadCode::kChunkSize, asset.chains().size(), skeleton.chain_count);
  }
  std::uint32_t rigid_count = 0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    if (const LoadStatus status = check_bone_place(bones, i); !status) return status;
    if (const LoadStatus status = check_bone_shape(bones[i], i); !status) return status;
    const bool named = bones[i].name == kNone || bones[i].name < name_bytes;
    const bool hangs = bones[i].kind == BoneKind::kSimulated && !is_rigid(bones[bones[i].parent]);
    if (hangs && !starts_at_parent(bones[i], bones[bones[i].parent])) return bone_error(LoadCode::kBoneJoint, i);
    if (!named) return bone_error(LoadCode::kReference, i, name_bytes, bones[i].name);
    rigid_count += is_rigid(bones[i]) ? 1 : 0;
  }
  const std::uint64_t simulated = bones.size() - rigid_count;
  if (skeleton.simulated_count != simulated) return fail(LoadCode::kChunkSize, simulated, skeleton.simulated_count);
  return check_chains(asset, rigid_count);
}

}  // namespace coif
