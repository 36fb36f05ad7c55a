#include "cook/dynamics/bake_dynamics.h"

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace coif::cook::tied_chains_test {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// A bundle of strips around a chain of four bones that hangs down.
struct BundleDesc {
  Vector3d root{0, 1.6, -0.1};
  double length = 0.3, width = 0.06, thickness = 0.06;  ///< Metres; outer size of the ring that the strips stand in.
};

struct Bundles {
  HairStrips hair;
  HairRig rig;
};

constexpr std::uint32_t kBones = 4;
constexpr int kStrips = 12;

Bundles bundles_of(const std::vector<BundleDesc>& all) {
  importer::SourceMesh mesh;
  Skeleton skeleton;
  skeleton.bones.emplace_back().kind = BoneKind::kHead;
  for (const BundleDesc& bundle : all) {
    for (int i = 0; i < kStrips; ++i) {
      const double angle = 2 * std::numbers::pi * i / kStrips;
      const Vector3d at =
          bundle.root + Vector3d(bundle.width / 2 * std::cos(angle), 0, bundle.thickness / 2 * std::sin(angle));
      const importer::SourceMesh strip = make_strip(
          {.root = at.cast<float>(), .along = {0, -float(bundle.length), 0}, .across = {0.004f, 0, 0}, .rows = 8});
      if (mesh.positions.empty())
        mesh = strip;
      else
        append_piece(mesh, strip, 0);
    }
    const auto first = std::uint32_t(skeleton.bones.size()), chain = std::uint32_t(skeleton.chains.size());
    for (std::uint32_t b = 0; b < kBones; ++b) {
      SkeletonBone& bone = skeleton.bones.emplace_back();
      bone.name = "lock_" + std::to_string(chain + 1) + "_" + std::to_string(b + 1);
      bone.parent = b == 0 ? 0 : first + b - 1;
      bone.kind = BoneKind::kSimulated;
      bone.chain = chain;
      bone.start = bundle.root - Vector3d(0, bundle.length * b / kBones, 0);
      bone.tail = bundle.root - Vector3d(0, bundle.length * (b + 1) / kBones, 0);
      bone.place = double(b + 1) / kBones;
    }
    skeleton.chains.push_back({first, kBones, 0, {}});
  }
  Bundles made{strips_from(hair_from(mesh)), {std::move(skeleton), {}}};
  const std::size_t each = made.hair.mesh.positions.size() / all.size();
  for (std::size_t v = 0; v < made.hair.mesh.positions.size(); ++v) {
    const std::size_t chain = std::min(v / each, all.size() - 1);
    const double down = (all[chain].root.y() - double(made.hair.mesh.positions[v].y())) / all[chain].length;
    const auto bone = std::min<std::uint32_t>(std::uint32_t(std::max(0.0, down * kBones)), kBones - 1);
    made.rig.weights.push_back({{std::uint32_t(1 + chain * kBones) + bone, 1.0}});
  }
  return made;
}

std::vector<bool> tied(const std::vector<BundleDesc>& all) {
  const Bundles made = bundles_of(all);
  return find_tied_chains(made.hair, made.rig);
}

TEST(TiedChains, ARoundBundleAloneIsAPonyTail) {
  EXPECT_EQ(tied({{}}), std::vector<bool>{true});
  EXPECT_EQ(tied({{.length = 0.14}}), std::vector<bool>{false}) << "too short to swing";
  EXPECT_EQ(tied({{.width = 0.2, .thickness = 0.03}}), std::vector<bool>{false}) << "a sheet";
  EXPECT_EQ(tied({{.width = 0.4, .thickness = 0.4}}), std::vector<bool>{false}) << "all the hair of a head";
}

TEST(TiedChains, LocksBesideEachOtherAreLooseAndPigtailsAreNot) {
  const auto two = [](double apart, double other_length = 0.3) {
    return tied({{.root = {-apart / 2, 1.6, -0.1}}, {.root = {apart / 2, 1.6, -0.1}, .length = other_length}});
  };
  EXPECT_EQ(two(0.08), (std::vector<bool>{false, false}));
  EXPECT_EQ(two(0.3), (std::vector<bool>{true, true}));
  EXPECT_EQ(two(0.08, 0.1)[0], true) << "a fringe is no neighbour";
}

TEST(TiedChains, KeepWhatTheRecipeSays) {
  const Bundles made = bundles_of({{}});
  const auto loosened = [&](const Recipe& recipe) {
    Findings findings;
    SaidMotion motion = bake_dynamics(importer::SourceModel(), made.rig.skeleton, recipe, {}, findings);
    loosen_tied_chains(made.rig.skeleton, {true}, recipe, {}, motion, findings);
    return motion;
  };
  const SaidMotion usual = loosened(default_recipe());
  EXPECT_FLOAT_EQ(usual.records[1].friction, float(0.3 * preset_of(default_recipe()).friction));
  EXPECT_TRUE(usual.is_tied(1));
  EXPECT_FALSE(usual.is_tied(0)) << "the head";
  Recipe recipe = default_recipe();
  recipe.friction = 1.5;
  EXPECT_FLOAT_EQ(loosened(recipe).records[1].friction, 1.5f);
  EXPECT_TRUE(loosened(recipe).is_tied(1));
  recipe.damping_ratio = NumberOrCurve(0.3);
  EXPECT_FALSE(loosened(recipe).is_tied(1));
  recipe = default_recipe();
  recipe.resistance = {{0, 0.1}};
  EXPECT_FALSE(loosened(recipe).is_tied(1)) << "no preset moves it";
}

}  // namespace coif::cook::tied_chains_test
