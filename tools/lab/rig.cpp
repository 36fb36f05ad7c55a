#include "lab/rig.h"

#include "lab/reference_model.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace coif::lab {
namespace {

RigBone bone_of(const BoneRecord& bone, const DynamicsRecord& dynamics, std::uint32_t rigid_count) {
  RigBone out;
  out.parent = bone.parent < rigid_count ? -1 : int(bone.parent - rigid_count);
  out.joint = Eigen::Map<const Eigen::Vector3f>(bone.joint).cast<double>();
  out.rest_direction = Eigen::Map<const Eigen::Vector3f>(bone.rest_direction).cast<double>().normalized();
  out.length = bone.length;
  out.resistance = dynamics.resistance;
  out.stiffness = dynamics.stiffness;
  out.damping = dynamics.damping;
  out.friction = dynamics.friction;
  out.gravity_scale = dynamics.gravity_scale;
  out.authoring_rate = dynamics.authoring_rate;
  out.hit_radius = dynamics.hit_radius;
  out.torsion = dynamics.torsion;
  out.angle_limit = dynamics.angle_limit;
  out.parent_share = dynamics.parent_share;
  if (dynamics.lean[0] != 0 || dynamics.lean[1] != 0) {
    float pull[3];
    pull_direction(bone.rest_direction, dynamics.lean, pull);
    out.leaning = Eigen::Map<const Eigen::Vector3f>(pull).cast<double>().normalized();
  }
  out.colliders = bone.colliders;
  return out;
}

std::optional<AskedRecord> changed_from(const AskedRecord& asked, const DynamicsRecord& given) {
  const bool is_same =
      asked.friction == given.friction && asked.damping == given.damping && asked.parent_share == given.parent_share;
  return is_same ? std::nullopt : std::optional(asked);
}

void find_tips(const Asset& asset, Rig& rig) {
  std::vector<bool> has_child(rig.bones.size());
  std::vector<double> length(rig.bones.size());
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const int parent = rig.bones[i].parent;
    if (parent >= 0) has_child[std::size_t(parent)] = true;
    length[i] = rig.bones[i].length + (parent >= 0 ? length[std::size_t(parent)] : 0.0);
  }
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    if (has_child[i]) continue;
    rig.tips.push_back(std::uint32_t(i));
    rig.tip_length.push_back(length[i]);
    rig.tip_chain.push_back(asset.bones()[rig.rigid_count + i].chain);
  }
}

}  // namespace

Rig rig_of(const Asset& asset) {
  Rig rig;
  rig.rigid_count = asset.skeleton().bone_count - asset.skeleton().simulated_count;
  for (std::size_t i = rig.rigid_count; i < asset.bones().size(); ++i) {
    rig.bones.push_back(bone_of(asset.bones()[i], asset.dynamics()[i], rig.rigid_count));
    rig.bones.back().air_follow = 1 - double(asset.skeleton().air_lag);
    rig.bones.back().model = asset.chains()[asset.bones()[i].chain].model;
    if (!asset.limits().empty()) rig.bones.back().limit = asset.limits()[i];
    if (!asset.asked().empty()) rig.bones.back().asked = changed_from(asset.asked()[i], asset.dynamics()[i]);
  }
  rig.colliders.assign(asset.colliders().begin(), asset.colliders().end());
  for (const LinkRecord& link : asset.links()) {
    rig.links.push_back(
        {link.bone - rig.rigid_count, link.to - rig.rigid_count, double(link.shortest), double(link.longest)});
  }
  find_tips(asset, rig);
  return rig;
}

std::vector<Eigen::Vector3d> resting_ends(const Rig& rig) {
  std::vector<Eigen::Vector3d> ends;
  for (const RigBone& bone : rig.bones) {
    const Eigen::Vector3d start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    ends.push_back(start + bone.length * bone.rest_direction);
  }
  return ends;
}

std::vector<int> depths_of(std::span<const RigBone> bones) {
  std::vector<int> depths;
  for (const RigBone& bone : bones) depths.push_back(bone.parent < 0 ? 0 : depths[std::size_t(bone.parent)] + 1);
  return depths;
}

std::vector<RigLink> links_among(const Rig& rig, std::span<const int> place) {
  std::vector<RigLink> links;
  for (const RigLink& link : rig.links) {
    if (place[link.bone] < 0) continue;
    links.push_back({std::uint32_t(place[link.bone]), std::uint32_t(place[link.to]), link.shortest, link.longest});
  }
  return links;
}

Rig in_model(Rig rig, ChainModel model) {
  for (RigBone& bone : rig.bones) bone.model = model;
  return rig;
}

Rig as_asked(Rig rig) {
  for (RigBone& bone : rig.bones) {
    if (!bone.asked) continue;
    bone.friction = bone.asked->friction;
    bone.damping = bone.asked->damping;
    bone.parent_share = bone.asked->parent_share;
  }
  return rig;
}

namespace {

/// Every n-th tree, for the smallest n that keeps within `most_bones`.
std::vector<std::uint32_t> chosen_bones(const Rig& rig, std::size_t most_bones) {
  const std::vector<std::vector<std::uint32_t>> trees = trees_of(rig);
  std::vector<std::uint32_t> bones;
  for (std::size_t stride = 1; stride <= trees.size(); ++stride) {
    bones.clear();
    for (std::size_t i = 0; i < trees.size(); i += stride) {
      bones.insert(bones.end(), trees[i].begin(), trees[i].end());
    }
    if (bones.size() <= most_bones) break;
  }
  std::sort(bones.begin(), bones.end());
  return bones;
}

}  // namespace

RigSample sample_of(const Rig& rig, std::size_t most_bones) {
  RigSample sample;
  sample.bones = chosen_bones(rig, most_bones);
  sample.rig.colliders = rig.colliders;
  sample.rig.rigid_count = rig.rigid_count;
  std::vector<int> place(rig.bones.size(), -1);
  for (std::size_t i = 0; i < sample.bones.size(); ++i) {
    RigBone bone = rig.bones[sample.bones[i]];
    if (bone.parent >= 0) bone.parent = place[std::size_t(bone.parent)];
    place[sample.bones[i]] = int(i);
    sample.rig.bones.push_back(bone);
  }
  sample.rig.links = links_among(rig, place);
  for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
    if (place[rig.tips[tip]] < 0) continue;
    sample.rig.tips.push_back(std::uint32_t(place[rig.tips[tip]]));
    sample.rig.tip_length.push_back(rig.tip_length[tip]);
    sample.rig.tip_chain.push_back(rig.tip_chain[tip]);
  }
  return sample;
}

AssetContents moving_part(const Asset& asset) {
  AssetContents contents;
  contents.skeleton = asset.skeleton();
  contents.bones.assign(asset.bones().begin(), asset.bones().end());
  for (BoneRecord& bone : contents.bones) bone.name = kNone;
  contents.chains.assign(asset.chains().begin(), asset.chains().end());
  contents.dynamics.assign(asset.dynamics().begin(), asset.dynamics().end());
  return contents;
}

AssetContents untouched_part(const Asset& asset) {
  AssetContents contents = moving_part(asset);
  for (BoneRecord& bone : contents.bones) bone.colliders = 0;
  return contents;
}

namespace {

constexpr std::size_t kAlignment = 64;  ///< The largest alignment that Asset::open() needs.

}  // namespace

OpenedAsset::OpenedAsset(std::span<const std::byte> file, const OpenOptions& options) {
  const std::size_t size = (file.size() + kAlignment - 1) / kAlignment * kAlignment;
  bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(kAlignment, size)));
  if (!bytes_) throw std::bad_alloc();
  std::memcpy(bytes_.get(), file.data(), file.size());
  status_ = asset_.open({bytes_.get(), file.size()}, options);
}

void OpenedAsset::FreeMemory::operator()(std::byte* bytes) const { std::free(bytes); }

}  // namespace coif::lab
