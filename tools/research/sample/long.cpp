#include "research/sample/long.h"

#include "mannequin/head_shape.h"
#include "mannequin/solid_shapes.h"
#include "research/sample/gltf_document.h"
#include "research/sample/strips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace coif::research {
namespace {

const StrandColors kHoney{{0.300, 0.200, 0.120}, {0.560, 0.410, 0.245}, {0.730, 0.590, 0.390}};

constexpr double kTenthMillimetres = 10000.0;  // Per metre.

/// With 64 values per channel instead of 256, which nobody sees, colours pack to two thirds of the size.
StrandTexture coarsened(StrandTexture texture) {
  for (std::size_t i = 0; i < texture.rgba.size(); ++i) {
    const bool is_alpha = i % 4 == 3;
    if (!is_alpha) texture.rgba[i] = static_cast<std::uint8_t>(texture.rgba[i] / 4 * 4 + 2);
  }
  return texture;
}

/// The head turns, the foot of the neck stays with the neck's joint.
mannequin::SurfaceMesh skinned_to_head(mannequin::SurfaceMesh mesh) {
  constexpr int neck_joint = 1, head_joint = 2;
  for (const Eigen::Vector3d& p : mesh.positions) {
    const double head = mannequin::smooth_step(1.440, 1.490, p.y());
    mesh.skin.push_back(rounded_influences({{{head_joint, head}, {neck_joint, 1.0 - head}, {0, 0.0}, {0, 0.0}}}));
  }
  return mesh;
}

}  // namespace

std::vector<std::byte> make_long() {
  const std::vector<Lock> locks = make_locks();
  GltfDocument document;
  document.set_skeleton(make_long_skeleton(locks), kTenthMillimetres);
  document.set_image("strands", coarsened(make_strand_texture(kHoney)));
  document.add_mesh("hair", make_long_hair(locks), {.name = "hair", .is_hair = true});
  // Not "head": the name must not be mistaken for the joint's.
  document.add_mesh("mannequin", skinned_to_head(mannequin::make_bare_head()),
                    {.name = "head", .red = 0.56, .green = 0.46, .blue = 0.40, .roughness = 0.75});
  document.add_mesh("scalp", skinned_to_head(mannequin::make_scalp_cap()),
                    {.name = "scalp", .red = 0.10, .green = 0.06, .blue = 0.03, .roughness = 0.9});
  return document.to_glb();
}

namespace {

using Eigen::Vector3d;

constexpr int kLongRoot = 0, kLongNeck = 1, kLongHead = 2, kLongFirstScalp = 3, kFirstLock = 6;
constexpr int kJointsPerLock = kBonesPerLock + 1;  // Plus the end.

/// Scalp joint of a lock: left, back or right.
int scalp_of(const Lock& lock) {
  if (lock.course.azimuth < 125.0) return kLongFirstScalp;
  return lock.course.azimuth <= 235.0 ? kLongFirstScalp + 1 : kLongFirstScalp + 2;
}

}  // namespace

std::vector<Joint> make_long_skeleton(std::span<const Lock> locks) {
  std::vector<Joint> joints{{"root", -1, {0, 0, 0}},
                            {"neck", kLongRoot, {0, 1.450, -0.030}},
                            {"Head", kLongNeck, {0, 1.600, 0}},
                            {"scalp_left", kLongHead, {0.055, 1.670, -0.010}},
                            {"scalp_back", kLongHead, {0, 1.670, -0.080}},
                            {"scalp_right", kLongHead, {-0.055, 1.670, -0.010}}};
  for (std::size_t l = 0; l < locks.size(); ++l) {
    const std::string name = fmt::format("Lock_{:03}_", l + 1);
    const double start = chain_start(locks[l].course);
    int parent = scalp_of(locks[l]);
    for (int b = 0; b <= kBonesPerLock; ++b) {
      const double along = start + (1.0 - start) * b / kBonesPerLock;
      const Vector3d position = point_on_lock(locks[l].course, along);
      joints.push_back({name + (b < kBonesPerLock ? fmt::format("{:02}", b + 1) : "end"), parent, position});
      parent = static_cast<int>(joints.size()) - 1;
    }
  }
  return joints;
}

mannequin::SkinInfluences lock_influences(std::span<const Lock> locks, int a, int b, double share_b, double along) {
  // In the middle of a bone a point is on it alone; at the joint of two bones it is half on each.
  const double place = std::clamp(along * kBonesPerLock - 0.5, -1.0, kBonesPerLock - 1.0);
  const int upper = static_cast<int>(std::floor(place));
  const double lower_share = place - upper;
  const auto joint = [&](int lock, int bone) {
    return bone < 0 ? scalp_of(locks[static_cast<std::size_t>(lock)]) : kFirstLock + lock * kJointsPerLock + bone;
  };
  const int lower = std::min(upper + 1, kBonesPerLock - 1);
  return rounded_influences({{{joint(a, upper), (1.0 - share_b) * (1.0 - lower_share)},
                              {joint(a, lower), (1.0 - share_b) * lower_share},
                              {joint(b, upper), share_b * (1.0 - lower_share)},
                              {joint(b, lower), share_b * lower_share}}});
}

using Eigen::Vector3d;

Vector3d direction_on_curve(const Vector3d& from, const Vector3d& control, const Vector3d& to, double t) {
  return ((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to).normalized();
}

Vector3d pushed_clear(Vector3d point, double clearance, const mannequin::Field& distance,
                      const mannequin::Gradient& normal) {
  for (int i = 0; i < 6; ++i) {
    const double found = distance(point);
    if (found >= clearance) break;
    point += (clearance - found) * normal(point);
  }
  return point;
}

}  // namespace coif::research
