#include "research/sample/bob.h"

#include "mannequin/head_shape.h"
#include "mannequin/portrait.h"
#include "mannequin/portrait_head.h"
#include "mannequin/solid_shapes.h"
#include "research/sample/gltf_document.h"
#include "research/sample/strips.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::research {
namespace {

mannequin::SurfaceMesh skinned(mannequin::SurfaceMesh mesh,
                               mannequin::SkinInfluences (*influences)(const Eigen::Vector3d&)) {
  for (const Eigen::Vector3d& point : mesh.positions) mesh.skin.push_back(influences(point));
  return mesh;
}

constexpr mannequin::PortraitDetail kPortraitDetail{.spacing = 2.0, .texels = 256};

/// Edge of the cells in which one vertex of the skin is enough, metres; 0: each vertex stays. Hair hides all but the
/// face, in which lids, nostrils and lips are finest.
double skin_cell(const Eigen::Vector3d& point) {
  const double aside = std::abs(point.x()), up = point.y();
  const bool is_face = point.z() > 0.030 && up > 1.482 && up < 1.645 && aside < 0.066;
  if (is_face) {
    const bool is_eye = up > 1.594 && up < 1.618 && aside > 0.010 && aside < 0.054;
    const bool is_nose_or_mouth = up > 1.527 && up < 1.570 && aside < 0.030;
    return is_eye || is_nose_or_mouth ? 0 : 0.0042;
  }
  const bool is_ear = aside > 0.066 && up > 1.550 && up < 1.630;
  if (is_ear) return 0.006;
  const bool is_at_neckline = up > 1.350 && up < 1.450;
  if (is_at_neckline) return 0.0050;
  const bool is_under_hair = point.z() < 0 && up > 1.560;
  return is_under_hair ? 0.015 : 0.010;
}

/// The same for the shirt, whose neckline is seen.
double shirt_cell(const Eigen::Vector3d& point) { return point.y() > 1.360 ? 0 : 0.024; }

/// The portrait with fewer vertices and texels than in its own file.
std::vector<mannequin::PortraitPart> small_portrait() {
  std::vector<mannequin::PortraitPart> parts = mannequin::make_portrait_parts(kPortraitDetail);
  for (mannequin::PortraitPart& part : parts) {
    if (part.name == "skin") part.mesh = mannequin::thinned(part.mesh, skin_cell);
    if (part.name == "shirt") part.mesh = mannequin::thinned(part.mesh, shirt_cell);
    if (part.name == "eyes") part.mesh = mannequin::thinned(part.mesh, [](const auto&) { return 0.0034; });
  }
  return parts;
}

/// The cap just above the portrait's skin.
mannequin::SurfaceMesh portrait_cap() {
  const auto distance = [](const Eigen::Vector3d& point) {
    return kBobHead.scale * mannequin::portrait_distance(kBobHead.unplaced(point));
  };
  const auto normal = [](const Eigen::Vector3d& point) { return mannequin::portrait_normal(kBobHead.unplaced(point)); };
  return mannequin::make_scalp_cap(distance, normal);
}

}  // namespace

std::vector<std::byte> make_bob(const BobDensity& density) {
  GltfDocument document;
  document.set_skeleton(make_bob_skeleton());
  document.set_image("strands", make_strand_texture());
  document.add_mesh("hair", skinned(make_bob_hair(density), hair_influences), {.name = "hair", .is_hair = true});
  add_portrait(small_portrait(), kBobHead, document);
  const auto cap_influences = [](const Eigen::Vector3d& point) {
    return portrait_influences(kBobHead.unplaced(point));
  };
  document.add_mesh("scalp", skinned(portrait_cap(), cap_influences),
                    {.name = "scalp", .red = 0.045, .green = 0.024, .blue = 0.013, .roughness = 0.9});
  return document.to_glb();
}

namespace {

using Eigen::Vector3d;

constexpr int kRoot = 0, kNeck = 1, kHead = 2, kFirstScalp = 3;
constexpr int kJointsPerChain = 5;  // scalp, three bones, end
constexpr std::array<const char*, 3> kChainNames{"left", "back", "right"};
constexpr std::array<double, 3> kChainAzimuths{90.0, 180.0, -90.0};
// Model Y of the joints of every chain: the hair leaves the skull at the level of the ears.
constexpr std::array<double, 4> kJointHeights{1.605, 1.550, 1.495, 1.440};
// Model Y at which a point belongs to one joint alone: the scalp, then the middle of each bone.
constexpr std::array<double, 4> kBoneMiddles{1.645, 1.5775, 1.5225, 1.4675};

/// A point inside the hair's volume: where chain joints sit.
Vector3d chain_point(double azimuth, double height) {
  HairCourse course;
  course.azimuth = azimuth;
  course.parting = azimuth == 180.0 ? 1.0 : 0.55;
  course.lift = 0.014;
  course.tip_height = kJointHeights.back();
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (point_on_hair(course, middle).y() > height ? low : high) = middle;
  }
  return point_on_hair(course, high);
}

struct ChainShare {
  int chain_a, chain_b;
  double weight_b;
};

ChainShare nearest_chains(const Vector3d& point) {
  constexpr int kLeft = 0, kBack = 1, kRight = 2;
  const double azimuth = azimuth_of(point);
  const int side = azimuth > 0 ? kLeft : kRight;
  const int other = azimuth > 0 ? kRight : kLeft;
  // The two sides meet across the face; behind the ears each side fades into the back.
  if (std::abs(azimuth) < 40.0) return {side, other, 0.5 * mannequin::smooth_step(40.0, 0.0, std::abs(azimuth))};
  return {side, kBack, mannequin::smooth_step(100.0, 165.0, std::abs(azimuth))};
}

/// Counted in joints from the scalp joint: 1.25 is a quarter joint 2, the rest joint 1.
double position_along_chain(double height) {
  double level = 0.0;
  for (std::size_t i = 0; i + 1 < kBoneMiddles.size(); ++i)
    level += mannequin::smooth_step(kBoneMiddles[i], kBoneMiddles[i + 1], height);
  return level;
}

}  // namespace

std::vector<Joint> make_bob_skeleton() {
  std::vector<Joint> joints{
      {"root", -1, {0, 0, 0}}, {"neck", kRoot, {0, 1.450, -0.030}}, {"Head", kNeck, {0, 1.600, 0}}};
  for (std::size_t chain = 0; chain < kChainNames.size(); ++chain) {
    const std::string name = kChainNames[chain];
    Vector3d scalp = chain_point(kChainAzimuths[chain], kJointHeights[0]);
    scalp.x() *= 0.75;
    scalp.y() = 1.670;
    scalp.z() *= 0.75;
    int parent = static_cast<int>(joints.size());
    joints.push_back({"scalp_" + name, kHead, scalp});
    const char* const suffixes[] = {"_1", "_2", "_3", "_3_end"};
    for (std::size_t i = 0; i < kJointHeights.size(); ++i) {
      joints.push_back({"hair_" + name + suffixes[i], parent, chain_point(kChainAzimuths[chain], kJointHeights[i])});
      parent = static_cast<int>(joints.size()) - 1;
    }
  }
  return joints;
}

mannequin::SkinInfluences hair_influences(const Vector3d& point) {
  const ChainShare share = nearest_chains(point);
  const double level = position_along_chain(point.y());
  const int upper = std::min(static_cast<int>(level), 2);
  const double lower_weight = level - upper;
  const int a = kFirstScalp + share.chain_a * kJointsPerChain + upper;
  const int b = kFirstScalp + share.chain_b * kJointsPerChain + upper;
  const double weight_b = share.weight_b, weight_a = 1.0 - weight_b;
  return rounded_influences({{{a, weight_a * (1.0 - lower_weight)},
                              {a + 1, weight_a * lower_weight},
                              {b, weight_b * (1.0 - lower_weight)},
                              {b + 1, weight_b * lower_weight}}});
}

}  // namespace coif::research
