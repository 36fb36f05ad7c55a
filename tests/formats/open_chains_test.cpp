// How many bones of a chain may wait for their children.

#include "formats/refusal.h"

#include <vector>

namespace coif {
namespace {

constexpr std::uint32_t kRoot = 0xFFFF;  ///< As a parent: the rigid bone that carries the chain.

/// small_asset() without mesh and with one chain: bone i of it hangs from bone parents[i] of it.
AssetContents with_chain(const std::vector<std::uint32_t>& parents) {
  const AssetContents whole = small_asset();
  AssetContents contents;
  contents.skeleton = whole.skeleton;
  contents.bones = {whole.bones[0], whole.bones[1]};
  for (const std::uint32_t parent : parents) {
    BoneRecord bone = whole.bones[2];
    bone.colliders = 0;
    if (parent != kRoot) {
      bone.parent = 2 + parent;
      const BoneRecord& above = contents.bones[bone.parent];
      bone.joint[1] = above.joint[1] - above.length;
    }
    contents.bones.push_back(bone);
  }
  contents.chains = {{2, std::uint32_t(parents.size()), 1, 0}};
  contents.dynamics.assign(contents.bones.size(), whole.dynamics[2]);
  return contents;
}

/// A comb: a stem of `stem` bones, each but the last with a tooth. Teeth come after the whole stem, from its tip upwards
/// or from its root downwards.
std::vector<std::uint32_t> comb(std::uint32_t stem, bool tip_first) {
  std::vector<std::uint32_t> parents = {kRoot};
  for (std::uint32_t b = 1; b < stem; ++b) parents.push_back(b - 1);
  for (std::uint32_t b = 0; b + 1 < stem; ++b) parents.push_back(tip_first ? stem - 2 - b : b);
  return parents;
}

/// The same comb depth first, teeth before the rest of the stem.
std::vector<std::uint32_t> comb_with_stem_last(std::uint32_t stem) {
  std::vector<std::uint32_t> parents = {kRoot};
  for (std::uint32_t b = 1, above = 0; b < stem; ++b) {
    parents.push_back(above);
    parents.push_back(above);
    above = std::uint32_t(parents.size()) - 1;
  }
  return parents;
}

TEST(OpenChains, SixteenBonesMayWaitForTheirChildrenAndNoMore) {
  for (const bool tip_first : {true, false}) {
    EXPECT_EQ(open_written(with_chain(comb(kMaxOpenBones + 1, tip_first))).code, LoadCode::kOk);
    const LoadStatus status = open_written(with_chain(comb(kMaxOpenBones + 2, tip_first)));
    EXPECT_EQ(status.code, LoadCode::kOpenBones);
    EXPECT_EQ(status.chunk, chunk::kChains);
    EXPECT_EQ(status.expected, kMaxOpenBones);
  }
}

TEST(OpenChains, ABoneThatOpensWhereAnotherClosesCountsBesideIt) {
  // The stem's tip gets a child of its own: at the tip, all of the stem before it and the tip are open.
  std::vector<std::uint32_t> parents = comb(kMaxOpenBones, true);
  parents.insert(parents.begin() + kMaxOpenBones, kMaxOpenBones - 1);
  EXPECT_EQ(open_written(with_chain(parents)).code, LoadCode::kOk);
  parents = comb(kMaxOpenBones + 1, true);
  parents.insert(parents.begin() + kMaxOpenBones + 1, kMaxOpenBones);
  EXPECT_EQ(open_written(with_chain(parents)).code, LoadCode::kOpenBones);
}

TEST(OpenChains, LongAndWideChainsAreFineDepthFirst) {
  std::vector<std::uint32_t> path = {kRoot};
  for (std::uint32_t b = 1; b < 1000; ++b) path.push_back(b - 1);
  EXPECT_EQ(open_written(with_chain(path)).code, LoadCode::kOk);
  EXPECT_EQ(open_written(with_chain(comb_with_stem_last(1000))).code, LoadCode::kOk);
  std::vector<std::uint32_t> broom(1000, 0);
  broom[0] = kRoot;
  EXPECT_EQ(open_written(with_chain(broom)).code, LoadCode::kOk) << "one bone with many children is one bone";
  EXPECT_EQ(open_written(with_chain(std::vector<std::uint32_t>(1000, kRoot))).code, LoadCode::kOk);
}

}  // namespace
}  // namespace coif
