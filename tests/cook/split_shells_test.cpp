#include "cook/split_shells.h"

#include "cook/built_models.h"
#include "cook/extract_patches.h"
#include "cook/smooth_normals.h"
#include "cook/weld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace coif {
namespace {

struct Shell {
  HairMesh mesh;
  PatchSet patches;
  StrandField strands;
  ShellSplit split;
};

/// Cuts what is wider than `widest` metres; the head is a ball of 0.09 m.
Shell cut(const SourceMesh& source, double widest) {
  Shell shell;
  shell.mesh = hair_from(source);
  complete_normals(shell.mesh, weld_places(shell.mesh.positions, 0));
  const auto place = weld_places(shell.mesh.positions, 0);
  shell.patches = extract_patches(shell.mesh, place, "auto").patches;
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii = Eigen::Vector3d::Constant(0.09);
  const std::vector<float> depths{0};
  StrandSettings settings;
  settings.depth_of_node = depths;
  shell.strands = find_strand_direction(shell.mesh, place, shell.patches, head, settings);
  shell.split = split_shells(shell.mesh, place, shell.strands, widest, shell.patches);
  return shell;
}

TEST(SplitShells, ACapIsCutAlongItsStrands) {
  const Shell shell = cut(make_cap(24, 8, 6.2f), 0.07);
  EXPECT_EQ(shell.split.shells, 1u);
  EXPECT_EQ(shell.split.parts, shell.patches.count);
  EXPECT_GE(shell.patches.count, 6u) << "0.6 m around";
  EXPECT_EQ(shell.split.left, 0u);
  // The sixteen triangles of a column of quads, crown to edge, stay together.
  for (std::size_t column = 0; column < 24; ++column) {
    std::set<std::uint32_t> patches;
    for (std::size_t row = 0; row < 8; ++row) {
      patches.insert(shell.patches.patch_of[2 * (24 * row + column)]);
      patches.insert(shell.patches.patch_of[2 * (24 * row + column) + 1]);
    }
    EXPECT_EQ(patches.size(), 1u) << "column " << column;
  }
}

TEST(SplitShells, AStripIsLeftWhole) {
  const Shell shell = cut(make_strip({.rows = 12}), 0.07);
  EXPECT_EQ(shell.split.shells, 0u);
  EXPECT_EQ(shell.patches.count, 1u);
}

TEST(SplitShells, PartsAreNumberedWithoutGaps) {
  const Shell shell = cut(make_cap(24, 8, 3.1f), 0.05);
  std::set<std::uint32_t> seen(shell.patches.patch_of.begin(), shell.patches.patch_of.end());
  EXPECT_EQ(seen.size(), shell.patches.count);
  EXPECT_EQ(*seen.rbegin(), shell.patches.count - 1);
}

TEST(SplitShells, SeparatedPatchesShareNoVertexAndKeepTheirStrands) {
  Shell shell = cut(make_cap(24, 8, 6.2f), 0.07);
  const auto originals = separate_patches(shell.mesh, shell.patches);
  shell.strands.append_copies(originals);
  ASSERT_EQ(shell.strands.place.size(), shell.mesh.positions.size());
  std::vector<std::uint32_t> owner(shell.mesh.positions.size(), kNoIndex);
  for (std::size_t i = 0; i < shell.mesh.triangles.size(); ++i) {
    std::uint32_t& patch = owner[shell.mesh.triangles[i]];
    if (patch == kNoIndex) patch = shell.patches.patch_of[i / 3];
    EXPECT_EQ(patch, shell.patches.patch_of[i / 3]);
  }
  for (std::size_t i = 0; i < originals.size(); ++i) {
    const std::size_t copy = shell.mesh.positions.size() - originals.size() + i;
    EXPECT_EQ(shell.mesh.positions[copy], shell.mesh.positions[originals[i]]);
    EXPECT_EQ(shell.strands.place[copy], shell.strands.place[originals[i]]);
  }
}

}  // namespace
}  // namespace coif
