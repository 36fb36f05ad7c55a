#include "cook/dynamics/bake_dynamics.h"

#include "base/text.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kShortestTied = 0.15;  ///< Metres. Shorter hair hardly swings.
constexpr double kWidestTied = 0.6;     ///< Share of the length.
constexpr double kRoundTied = 0.45;     ///< Thickness over width.
constexpr double kMostlyOwn = 0.5;      ///< Share of a triangle's weight.
constexpr double kBesideGap = 0.25;     ///< Share of the sum of both widths.
constexpr double kLongBeside = 0.5;     ///< Share of the length: shorter chains, a fringe, do not count as neighbours.
constexpr double kLowerHalf = 0.5;

/// Area, and first and second moments of where hair is about a bone's start, across the bone.
struct CrossSection {
  double area = 0;
  Vector3d first = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const Vector3d& offset, double weight) {
    area += weight;
    first += weight * offset;
    second += weight * offset * offset.transpose();
  }
};

/// Two standard deviations along the longer and the shorter axis, metres.
struct BundleSize {
  double width = 0, thickness = 0;
};

/// `section` is flat across the bone, so its three variances are two and a zero.
BundleSize size_of(const CrossSection& section) {
  const Vector3d mean = section.first / section.area;
  const Eigen::Matrix3d spread = section.second / section.area - mean * mean.transpose();
  const double half = spread.trace() / 2;
  const double product = (spread.trace() * spread.trace() - (spread * spread).trace()) / 2;
  const double apart = std::sqrt(std::max(0.0, half * half - product));
  return {2 * std::sqrt(std::max(0.0, half + apart)), 2 * std::sqrt(std::max(0.0, half - apart))};
}

/// The bone with the largest share of a triangle, and its share; bone 0 for hair that follows the head.
BoneWeight heaviest_bone(const HairMesh& mesh, const SkinWeights& weights, std::size_t triangle) {
  std::vector<BoneWeight> sum;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const BoneWeight& weight : weights[mesh.triangles[3 * triangle + k]]) {
      add_weight(sum, weight.bone, weight.weight / 3);
    }
  }
  const auto most = std::ranges::max_element(sum, {}, &BoneWeight::weight);
  return most != sum.end() ? *most : BoneWeight{};
}

std::vector<CrossSection> cross_sections(const HairStrips& hair, const HairRig& rig) {
  std::vector<CrossSection> sections(rig.skeleton.bones.size());
  for (std::size_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    const BoneWeight most = heaviest_bone(hair.mesh, rig.weights, t);
    const SkeletonBone& bone = rig.skeleton.bones[most.bone];
    if (!(most.weight >= kMostlyOwn) || bone.kind != BoneKind::kSimulated) continue;
    const double area = double(doubled_area(hair.mesh, 3 * t)) / 2;
    const Vector3d along = (bone.tail - bone.start).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d offset = hair.mesh.positions[hair.mesh.triangles[3 * t + k]].cast<double>() - bone.start;
      sections[most.bone].add(offset - along * along.dot(offset), area / 3);
    }
  }
  return sections;
}

struct Bundle {
  double length = 0;            ///< Metres along the chain; for a branched one to its farthest tip.
  BundleSize size;              ///< Mean by area.
  std::vector<Vector3d> lower;  ///< Middles and tails of the bones of the lower half.

  [[nodiscard]] bool is_compact() const {
    return length >= kShortestTied && size.width <= kWidestTied * length && size.thickness >= kRoundTied * size.width;
  }
};

Bundle bundle_of(const Skeleton& skeleton, const ChainRecord& chain, std::span<const CrossSection> sections) {
  Bundle bundle;
  std::vector<double> reached(chain.bone_count);
  double area = 0;
  for (std::uint32_t i = 0; i < chain.bone_count; ++i) {
    const SkeletonBone& bone = skeleton.bones[chain.first_bone + i];
    reached[i] = bone.length() + (bone.parent >= chain.first_bone ? reached[bone.parent - chain.first_bone] : 0);
    bundle.length = std::max(bundle.length, reached[i]);
    if (bone.place > kLowerHalf) {
      bundle.lower.push_back((bone.start + bone.tail) / 2);
      bundle.lower.push_back(bone.tail);
    }
    const CrossSection& section = sections[chain.first_bone + i];
    if (!(section.area > 0)) continue;
    const BundleSize size = size_of(section);
    bundle.size.width += section.area * size.width;
    bundle.size.thickness += section.area * size.thickness;
    area += section.area;
  }
  if (area > 0) bundle.size = {bundle.size.width / area, bundle.size.thickness / area};
  return bundle;
}

double nearest(const Bundle& a, const Bundle& b) {
  double least = std::numeric_limits<double>::max();
  for (const Vector3d& p : a.lower) {
    for (const Vector3d& q : b.lower) least = std::min(least, (p - q).norm());
  }
  return least;
}

bool hang_side_by_side(const Bundle& bundle, const Bundle& other) {
  if (other.length < kLongBeside * bundle.length) return false;
  return nearest(bundle, other) < (1 + kBesideGap) * (bundle.size.width + other.size.width);
}

}  // namespace

std::vector<bool> find_tied_chains(const HairStrips& hair, const HairRig& rig) {
  const std::vector<CrossSection> sections = cross_sections(hair, rig);
  std::vector<Bundle> bundles;
  for (const ChainRecord& chain : rig.skeleton.chains) bundles.push_back(bundle_of(rig.skeleton, chain, sections));
  std::vector<bool> tied;
  for (const Bundle& bundle : bundles) {
    const auto is_neighbour = [&](const Bundle& other) {
      return &other != &bundle && hang_side_by_side(bundle, other);
    };
    tied.push_back(bundle.is_compact() && std::ranges::none_of(bundles, is_neighbour));
  }
  return tied;
}

void loosen_tied_chains(const Skeleton& skeleton, const std::vector<bool>& tied, const RigRecipe& recipe,
                        std::span<const PatchOverride> of_chain, SaidMotion& motion, Findings& findings) {
  motion.tied.assign(motion.records.size(), false);
  std::vector<std::string> names;
  for (std::size_t c = 0; c < tied.size(); ++c) {
    if (!tied[c]) continue;
    const PatchOverride* const own = c < of_chain.size() ? &of_chain[c] : nullptr;
    const bool says_friction = recipe.friction || (own != nullptr && own->friction);
    const bool says_damping =
        recipe.damping_ratio || recipe.liveliness || (own != nullptr && (own->damping_ratio || own->liveliness));
    const ChainRecord& chain = skeleton.chains[c];
    bool is_any = false;
    for (std::uint32_t b = chain.first_bone; b < chain.first_bone + chain.bone_count; ++b) {
      if (motion.sources[b] != MotionSource::kPreset) continue;
      if (!says_friction) motion.records[b].friction = float(friction_of(*motion.presets[b], true));
      motion.tied[b] = !says_damping;
      is_any = is_any || !says_friction || !says_damping;
    }
    if (is_any) names.push_back(skeleton.bones[chain.first_bone].name);
  }
  if (names.empty()) return;
  findings.note(fmt::format("{} {} tied hair, which air and neighbours hold back less: {}",
                            counted(names.size(), "chain", "chains"), names.size() == 1 ? "is" : "are",
                            fmt::join(names, ", ")));
}

}  // namespace coif::cook
