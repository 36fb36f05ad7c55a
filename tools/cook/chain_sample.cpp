#include "cook/chain_sample.h"

namespace coif {
namespace {

/// Copies one bone and says where it went, so that its children find it.
void keep_bone(const AssetContents& from, std::uint32_t bone, std::uint32_t chain, std::vector<std::uint32_t>& moved_to,
               AssetContents& to) {
  BoneRecord record = from.bones[bone];
  if (record.parent != kNone) record.parent = moved_to[record.parent];
  record.chain = chain;
  record.name = kNone;
  moved_to[bone] = std::uint32_t(to.bones.size());
  to.bones.push_back(record);
  to.dynamics.push_back(from.dynamics[bone]);
}

}  // namespace

AssetContents chains_alone(const AssetContents& contents, std::span<const std::uint32_t> chains) {
  AssetContents part;
  part.skeleton = contents.skeleton;
  part.colliders = contents.colliders;
  std::vector<std::uint32_t> moved_to(contents.bones.size(), kNone);
  for (std::uint32_t b = 0; b < contents.bones.size(); ++b) {
    if (contents.bones[b].kind != BoneKind::kSimulated) keep_bone(contents, b, kNone, moved_to, part);
  }
  for (const std::uint32_t chain : chains) {
    ChainRecord record = contents.chains[chain];
    const std::uint32_t first = record.first_bone, end = first + record.bone_count;
    record.first_bone = std::uint32_t(part.bones.size());
    record.root = moved_to[record.root];
    for (std::uint32_t b = first; b < end; ++b) {
      keep_bone(contents, b, std::uint32_t(part.chains.size()), moved_to, part);
    }
    part.chains.push_back(record);
  }
  return part;
}

}  // namespace coif
