#include "cook/rig/skeleton.h"

#include "cook/cook.h"
#include "models/small_asset.h"

#include "cook/built_models.h"

#include <coif/asset.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace coif::cook::order_bones_test {

constexpr std::uint32_t kRoot = 0;  ///< The head carries every chain here.

/// Chains below a head; `trees[c][i]` is the parent of bone i of chain c inside the chain, kNone for those below the
/// head. Bones are named "<chain>.<bone>" and each is its own node.
Skeleton skeleton_of(const std::vector<std::vector<std::uint32_t>>& trees) {
  Skeleton skeleton;
  skeleton.bones.resize(1);
  skeleton.bones[0].kind = BoneKind::kHead;
  skeleton.bones[0].name = "head";
  for (std::uint32_t c = 0; c < trees.size(); ++c) {
    const auto first = std::uint32_t(skeleton.bones.size());
    for (std::uint32_t i = 0; i < trees[c].size(); ++i) {
      SkeletonBone bone;
      bone.kind = BoneKind::kSimulated;
      bone.name = fmt::format("{}.{}", c, i);
      bone.chain = c;
      bone.parent = trees[c][i] == kNone ? kRoot : first + trees[c][i];
      skeleton.bones.push_back(bone);
    }
    skeleton.chains.push_back({first, std::uint32_t(trees[c].size()), kRoot, {}});
  }
  for (std::uint32_t b = 0; b < skeleton.bones.size(); ++b) skeleton.bone_of_node.push_back(b);
  return skeleton;
}

std::vector<std::uint32_t> random_tree(std::size_t bones, std::mt19937& random) {
  std::vector<std::uint32_t> parents = {kNone};
  while (parents.size() < bones) parents.push_back(std::uint32_t(random() % parents.size()));
  return parents;
}

/// A bone's parents inside its chain, which is what makes two chains the same to a solver.
std::vector<std::uint32_t> shape_of(const Skeleton& skeleton, const ChainRecord& chain) {
  std::vector<std::uint32_t> shape;
  for (std::uint32_t b = chain.first_bone; b < chain.first_bone + chain.bone_count; ++b) {
    const std::uint32_t parent = skeleton.bones[b].parent;
    shape.push_back(parent == chain.root ? kNone : parent - chain.first_bone);
  }
  return shape;
}

/// The most bones that are open at any place of a chain, as the format counts them.
std::size_t most_open(const Skeleton& skeleton, const ChainRecord& chain) {
  std::set<std::uint32_t> open;
  std::size_t most = 0;
  for (std::uint32_t b = chain.first_bone + chain.bone_count; b-- > chain.first_bone;) {
    if (skeleton.bones[b].parent != chain.root) open.insert(skeleton.bones[b].parent);
    most = std::max(most, open.size());
    open.erase(b);
  }
  return most;
}

TEST(OrderBones, KeepsTheTreeAndSaysWhereEachBoneWent) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Skeleton before = skeleton_of({random_tree(40, random), random_tree(7, random), random_tree(40, random)});
    Skeleton after = before;
    const std::vector<std::uint32_t> moved_to = order_bones(after);
    ASSERT_EQ(std::set<std::uint32_t>(moved_to.begin(), moved_to.end()).size(), before.bones.size());
    for (std::uint32_t b = 0; b < before.bones.size(); ++b) {
      const SkeletonBone& bone = after.bones[moved_to[b]];
      EXPECT_EQ(bone.name, before.bones[b].name);
      EXPECT_EQ(after.bone_of_node[b], moved_to[b]) << "each bone was the node of its number";
      EXPECT_EQ(bone.parent, b == 0 ? kNone : moved_to[before.bones[b].parent]);
    }
  }
}

TEST(OrderBones, ChainsFollowEachOtherAndHoldTheirBonesParentsFirst) {
  std::mt19937 random(8);
  Skeleton skeleton = skeleton_of({random_tree(9, random), random_tree(30, random), random_tree(9, random)});
  (void)order_bones(skeleton);
  std::uint32_t next = 1;
  for (std::uint32_t c = 0; c < skeleton.chains.size(); ++c) {
    EXPECT_EQ(skeleton.chains[c].first_bone, next);
    for (; next < skeleton.chains[c].first_bone + skeleton.chains[c].bone_count; ++next) {
      EXPECT_EQ(skeleton.bones[next].chain, c);
      EXPECT_LT(skeleton.bones[next].parent, next);
    }
  }
  EXPECT_EQ(next, skeleton.bones.size());
}

/// The same tree, its bones listed in another order, parents first.
std::vector<std::uint32_t> listed_otherwise(const std::vector<std::uint32_t>& parents, std::mt19937& random) {
  std::vector<std::uint32_t> place(parents.size(), kNone), ready = {0}, listed;
  while (!ready.empty()) {
    const std::size_t next = random() % ready.size();
    const std::uint32_t bone = ready[next];
    ready.erase(ready.begin() + std::ptrdiff_t(next));
    place[bone] = std::uint32_t(listed.size());
    listed.push_back(parents[bone] == kNone ? kNone : place[parents[bone]]);
    for (std::uint32_t child = 0; child < parents.size(); ++child) {
      if (parents[child] == bone) ready.push_back(child);
    }
  }
  return listed;
}

TEST(OrderBones, EqualTreesGetOneShapeInWhateverOrderTheirBonesAreListed) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<std::uint32_t> tree = random_tree(14, random);
    Skeleton skeleton = skeleton_of({tree, listed_otherwise(tree, random)});
    (void)order_bones(skeleton);
    ASSERT_EQ(shape_of(skeleton, skeleton.chains[0]), shape_of(skeleton, skeleton.chains[1])) << "trial " << trial;
  }
}

TEST(OrderBones, ChainsOfEqualShapeAreNeighbours) {
  const std::vector<std::uint32_t> path = {kNone, 0, 1, 2}, fork = {kNone, 0, 0, 1}, same_fork = {kNone, 0, 0, 2};
  Skeleton skeleton = skeleton_of({path, fork, path, {kNone, 0}, same_fork, path, {kNone, 0}});
  (void)order_bones(skeleton);
  std::map<std::vector<std::uint32_t>, std::size_t> last_of_shape;
  for (std::size_t c = 0; c < skeleton.chains.size(); ++c) {
    const auto [at, is_new] = last_of_shape.try_emplace(shape_of(skeleton, skeleton.chains[c]), c);
    EXPECT_TRUE(is_new || at->second + 1 == c) << "chain " << c << " has the shape of one farther away";
    at->second = c;
  }
  EXPECT_EQ(last_of_shape.size(), 3u) << "forks that only list their children differently are one shape";
  EXPECT_EQ(skeleton.bones[skeleton.chains[0].first_bone].name, "3.0") << "few bones first";
  EXPECT_EQ(skeleton.bones[skeleton.chains[1].first_bone].name, "6.0") << "equal chains keep their order";
}

TEST(OrderBones, TreesOfOneShapeAreStoredAlikeInWhateverOrderTheirChildrenAreListed) {
  // Two subtrees of three bones, a path and a fork, in either order.
  Skeleton skeleton = skeleton_of({{kNone, 0, 1, 2, 0, 4, 4}, {kNone, 0, 1, 1, 0, 4, 5}});
  (void)order_bones(skeleton);
  EXPECT_EQ(shape_of(skeleton, skeleton.chains[0]), shape_of(skeleton, skeleton.chains[1]));
}

TEST(OrderBones, ChildrenFollowTheirBoneAndTheBiggestSubtreeComesLast) {
  // 0 has the children 1 (with 2 and 3 below) and 4 (alone), listed big one first.
  Skeleton skeleton = skeleton_of({{kNone, 0, 1, 2, 0}});
  (void)order_bones(skeleton);
  std::vector<std::string> names;
  for (std::size_t b = 1; b < skeleton.bones.size(); ++b) names.push_back(skeleton.bones[b].name);
  EXPECT_EQ(names, (std::vector<std::string>{"0.0", "0.4", "0.1", "0.2", "0.3"}));
}

TEST(OrderBones, NoTreeOfAnAssetsSizeKeepsTooManyBonesWaiting) {
  std::mt19937 random(9);
  // A heap's two subtrees are equally large at every bone, which is what keeps most bones waiting.
  std::vector<std::uint32_t> heap = {kNone};
  while (heap.size() < kMaxBones - 1) heap.push_back(std::uint32_t(heap.size() - 1) / 2);
  std::vector<std::uint32_t> path = {kNone};
  while (path.size() < kMaxBones - 1) path.push_back(std::uint32_t(path.size()) - 1);
  for (const auto& tree : {heap, path, random_tree(kMaxBones - 1, random)}) {
    Skeleton skeleton = skeleton_of({tree});
    (void)order_bones(skeleton);
    EXPECT_LE(most_open(skeleton, skeleton.chains[0]), kMaxOpenBones - 3);
  }
}

/// A wig whose first chain forks with the long branch listed first.
importer::SourceModel forked_wig() {
  importer::SourceModel model = make_wig();
  StripDesc side;
  side.root = {0.05f, 1.5f, -0.1f};
  const std::uint32_t tip = add_node(model, "side", 3, {0.05, 1.5, -0.1});
  add_node(model, "side_end", tip, {0.05, 1.2, -0.1});
  append_piece(model.meshes[0], make_strip(side), tip);
  return model;
}

TEST(OrderBones, VerticesFollowTheirBonesIntoTheAsset) {
  const auto cooked = cook(forked_wig(), default_recipe(), {});
  ASSERT_TRUE(cooked) << cooked.error().message;
  AlignedBytes file(cooked->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  std::size_t of_side = 0;
  for (std::size_t v = 0; v < asset.vertices().size(); ++v) {
    if (asset.vertices()[v].position[0] < 0.04f) continue;
    EXPECT_STREQ(asset.bone_name(asset.skin()[v].bone[0]), "side");
    ++of_side;
  }
  EXPECT_GT(of_side, 0u);
}

}  // namespace coif::cook::order_bones_test
