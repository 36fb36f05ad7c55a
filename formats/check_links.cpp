#include "chunk_checks.h"

namespace coif {
namespace {

/// The bones that links have named so far.
class NamedBones {
 public:
  [[nodiscard]] bool has(std::uint32_t bone) const { return ((words_[bone / 64] >> bone % 64) & 1u) != 0; }
  void add(std::uint32_t bone) { words_[bone / 64] |= std::uint64_t{1} << bone % 64; }

 private:
  std::uint64_t words_[kMaxBones / 64] = {};
};

/// How many simulated bones are above this one.
std::uint32_t depth_of(std::span<const BoneRecord> bones, std::uint32_t bone) {
  std::uint32_t depth = 0;
  for (std::uint32_t up = bones[bone].parent; !is_rigid(bones[up]); up = bones[up].parent) ++depth;
  return depth;
}

bool lengths_fit(const LinkRecord& link) {
  return in_range(link.longest, 1.0e-6f, kMaxCoordinate) && in_range(link.shortest, 0.0f, link.longest);
}

}  // namespace

LoadStatus check_links(const Asset& asset) {
  const auto bones = asset.bones();
  const auto links = asset.links();
  NamedBones named;
  std::uint32_t last_depth = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LinkRecord& link = links[i];
    for (const std::uint32_t bone : {link.bone, link.to}) {
      if (bone >= bones.size()) return {LoadCode::kReference, chunk::kLinks, i, bones.size(), bone};
      if (is_rigid(bones[bone])) return {LoadCode::kLinkOrder, chunk::kLinks, i};
    }
    const std::uint32_t depth = depth_of(bones, link.bone);
    const bool is_tree = depth >= last_depth && depth == depth_of(bones, link.to) && !named.has(link.bone);
    if (!is_tree || bones[link.bone].chain == bones[link.to].chain) return {LoadCode::kLinkOrder, chunk::kLinks, i};
    if (!lengths_fit(link)) return {LoadCode::kNotFinite, chunk::kLinks, i};
    last_depth = depth;
    named.add(link.bone);
    named.add(link.to);
  }
  return {};
}

}  // namespace coif
