// Where a file is refused, which numbers the refusal shows: what was expected, and what was found.

#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace coif::evidence_test {

/// A change of small_asset() and all that open() says of it.
struct Refused {
  const char* name;
  std::function<void(AssetContents&)> change;
  LoadStatus expected;
};

void expect_all(const std::vector<Refused>& all) {
  for (const Refused& one : all) {
    AssetContents contents = small_asset();
    one.change(contents);
    const LoadStatus status = open_written(contents);
    EXPECT_EQ(int(status.code), int(one.expected.code)) << one.name;
    EXPECT_EQ(status.chunk, one.expected.chunk) << one.name;
    EXPECT_EQ(status.item, one.expected.item) << one.name;
    EXPECT_EQ(status.expected, one.expected.expected) << one.name;
    EXPECT_EQ(status.found, one.expected.found) << one.name;
  }
}

using C = LoadCode;

TEST(Evidence, OfBonesAndChains) {
  const AssetContents good = small_asset();
  const std::uint64_t bones = good.bones.size();
  expect_all({
      {"a kind that there is not",
       [](auto& a) { a.bones[3].kind = BoneKind(7); },
       {C::kEnumerator, chunk::kBones, 3, 2, 7}},
      {"its own parent", [](auto& a) { a.bones[3].parent = 3; }, {C::kBoneOrder, chunk::kBones, 3, 2, 3}},
      {"a model that there is not",
       [](auto& a) { a.chains[1].model = ChainModel(2); },
       {C::kEnumerator, chunk::kChains, 1, 0, 2}},
      {"a chain that begins too early",
       [](auto& a) { a.chains[1].first_bone = 3; },
       {C::kChainCover, chunk::kChains, 1, 4, 3}},
      {"another chain's bone", [](auto& a) { a.bones[3].chain = 1; }, {C::kChainCover, chunk::kChains, 0, 0, 1}},
      {"a link to nowhere",
       [bones](auto& a) { a.links[0].to = std::uint32_t(bones); },
       {C::kReference, chunk::kLinks, 0, bones, bones}},
  });
}

TEST(Evidence, OfWhatIsDrawn) {
  const AssetContents good = small_asset();
  const std::uint64_t texels = good.texels.size(), mips = good.textures[0].bytes, bones = good.bones.size();
  const std::uint64_t vertices = good.vertices.size();
  expect_all({
      {"texels that are too many",
       [](auto& a) { a.textures[0].bytes += 16; },
       {C::kChunkSize, chunk::kTextures, 0, mips, mips + 16}},
      {"texels behind the end",
       [](auto& a) { a.textures[0].offset = 1u << 20; },
       {C::kReference, chunk::kTextures, 0, texels, 1u << 20}},
      {"a patch that begins too late",
       [](auto& a) { a.patches[1].first_index = 4; },
       {C::kPatchCover, chunk::kPatches, 1, 3, 4}},
      {"a patch that is too long",
       [](auto& a) { a.patches[2].index_count = 9; },
       {C::kPatchCover, chunk::kPatches, 2, 3, 9}},
      {"a patch's bone", [](auto& a) { a.patches[1].bone = 99; }, {C::kReference, chunk::kPatches, 1, bones, 99}},
      {"a corner", [](auto& a) { a.indices[5] = 1000; }, {C::kReference, chunk::kIndices, 5, vertices, 1000}},
  });
}

}  // namespace coif::evidence_test
