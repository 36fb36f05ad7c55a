#include "cards/scalp_patches.h"

#include "base/geometry.h"
#include "base/parallel_for.h"
#include "cards/cluster_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace coif::cards {
namespace {

using Eigen::Vector3f;

constexpr float kReach = 0.3f;            // Share of the scalp's radius.
constexpr float kLock = 15;               // Length of its strands in radii of its roots.
constexpr std::size_t kFewestRoots = 12;  // Per patch, on average.
/// Perpendicular strands differ as much as roots that are this many patches apart.
constexpr float kDirectionWeight = 0.5f;
constexpr float kLeastAlongSkin =
    0.3f;                        // Share of a strand's way: one that stands off the skin is laid along its neighbours.
constexpr float kStray = 0.02f;  // Share of the roots, on each side.
constexpr std::size_t kPiecesOnSkin = 8;  // Per strand.
/// Share of the scalp's radius: as far around a root others tell whether it is at the rim.
constexpr float kRim = 0.28f;

/// The first part of a strand at even steps, with the file's points that are next to them.
struct RootPart {
  std::array<Vector3f, kPiecesOnSkin + 1> points;
  std::array<std::uint32_t, kPiecesOnSkin + 1> of_groom;
};

RootPart root_part(const groom::Groom& groom, bool is_reversed, std::size_t strand, float reach) {
  const std::uint32_t first = groom.begin[strand], last = groom.begin[strand + 1] - 1;
  const auto number = [&](std::uint32_t k) { return is_reversed ? last - k : first + k; };
  RootPart part;
  std::uint32_t k = 0;
  float before = 0;  // Where the segment from point k on begins.
  for (std::size_t i = 0; i <= kPiecesOnSkin; ++i) {
    const float wanted = reach * float(i) / float(kPiecesOnSkin);
    float length = (groom.points[number(k + 1)] - groom.points[number(k)]).norm();
    while (before + length < wanted && k + 1 < last - first) {
      before += length;
      ++k;
      length = (groom.points[number(k + 1)] - groom.points[number(k)]).norm();
    }
    const float share = length > 0 ? std::clamp((wanted - before) / length, 0.0f, 1.0f) : 0.0f;
    const Vector3f &a = groom.points[number(k)], &b = groom.points[number(k + 1)];
    part.points[i] = a + share * (b - a);
    part.of_groom[i] = number(share < 0.5f ? k : k + 1);
  }
  return part;
}

/// Groups by place and direction.
std::vector<std::vector<std::uint32_t>> group_roots(const std::vector<RootPart>& parts, float reach, float apart,
                                                    std::size_t count, const platform::Threads& threads) {
  using Roots = PointClusters<8>;
  std::vector<Roots::Point> roots(parts.size(), Roots::Point{});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Vector3f& root = parts[i].points.front();
    const Vector3f way = kDirectionWeight * apart / reach * (parts[i].points.back() - root);
    std::copy_n(root.data(), 3, roots[i].begin());
    std::copy_n(way.data(), 3, roots[i].begin() + 3);
  }
  return Roots::find(roots, count, threads);
}

void set_axes(const std::vector<RootPart>& parts, const Vector3f& inside, ScalpPatch& patch) {
  const float share = 1 / float(patch.members.size());
  Vector3f way = Vector3f::Zero();
  for (const std::uint32_t i : patch.members) {
    patch.middle += share * parts[i].points.front();
    way += share * (parts[i].points.back() - parts[i].points.front());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : patch.members) {
    const Eigen::Vector3d off = (parts[i].points.front() - patch.middle).cast<double>();
    spread += off * off.transpose();
  }
  Vector3f outwards = principal_axes(spread).col(2).cast<float>();
  // Strands leave the skin, and a scalp is round.
  const Vector3f from_inside = patch.middle - inside;
  if ((from_inside.normalized() + way.normalized()).dot(outwards) < 0) outwards = -outwards;
  Vector3f along = way - way.dot(outwards) * outwards;
  if (!(along.norm() > kLeastAlongSkin * way.norm())) along = -from_inside.cross(Vector3f::UnitY()).cross(from_inside);
  along -= along.dot(outwards) * outwards;
  along = along.norm() > 0 ? along.normalized() : outwards.unitOrthogonal();
  patch.axes << along.transpose(), outwards.cross(along).transpose(), outwards.transpose();
}

void set_skin(const std::vector<RootPart>& parts, ScalpPatch& patch) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  std::vector<float> xs, ys;
  for (const std::uint32_t i : patch.members) {
    const Vector3f at = patch.local(parts[i].points.front());
    xs.push_back(at.x());
    ys.push_back(at.y());
    const Eigen::Vector4d row(1, double(at.x()), double(at.y()), double(at.head<2>().squaredNorm()));
    normal += row * row.transpose();
    right += row * double(at.z());
  }
  patch.skin = least_squares(normal, right).cast<float>();
  double off = 0;
  for (const std::uint32_t i : patch.members) {
    const Vector3f at = patch.local(parts[i].points.front());
    off += std::pow(double(at.z() - patch.height(at.x(), at.y())), 2) / double(patch.members.size());
  }
  patch.off_skin = float(std::sqrt(off));
  patch.low = {quantile(xs, kStray), quantile(ys, kStray)};
  patch.high = {quantile(xs, 1 - kStray), quantile(ys, 1 - kStray)};
}

/// Lays each piece along the skin, with its own length.
void lay_down(const ScalpPatch& patch, RootPart& part) {
  const Vector3f root = patch.local(part.points.front());
  const Vector3f outwards = patch.normal(root.x(), root.y()), along = patch.axes.row(0).transpose();
  Vector3f before = part.points.front();
  for (std::size_t k = 1; k < part.points.size(); ++k) {
    const Vector3f way = part.points[k] - before;
    before = part.points[k];
    Vector3f flat = way - way.dot(outwards) * outwards;
    if (flat.norm() < kLeastAlongSkin * way.norm()) flat += way.norm() * along;
    part.points[k] = part.points[k - 1] + (flat.norm() > 0 ? (way.norm() * flat.normalized()).eval() : flat);
  }
}

std::vector<std::uint8_t> rim_of(const std::vector<RootPart>& parts, const Vector3f& inside, float radius) {
  std::vector<Vector3f> roots;
  for (const RootPart& part : parts) roots.push_back(part.points.front());
  return roots_at_rim(roots, inside, kRim * radius);
}

groom::Groom groom_of(const groom::Groom& groom, const std::vector<RootPart>& parts) {
  groom::Groom strands;
  strands.path = groom.path;
  strands.groups = groom.groups;
  strands.root_first = true;
  strands.begin.assign(1, 0);
  for (const RootPart& part : parts) {
    strands.points.insert(strands.points.end(), part.points.begin(), part.points.end());
    strands.begin.push_back(std::uint32_t(strands.points.size()));
    for (const std::uint32_t p : part.of_groom) {
      if (!groom.widths.empty()) strands.widths.push_back(groom.widths[p]);
      if (!groom.colors.empty()) strands.colors.push_back(groom.colors[p]);
    }
  }
  return strands;
}

}  // namespace

Vector3f ScalpPatch::normal(float x, float y) const {
  const Vector3f up(-skin[1] - 2 * skin[3] * x, -skin[2] - 2 * skin[3] * y, 1);
  return axes.transpose() * up.normalized();
}

Scalp find_scalp(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed, const EvenStrands& strands,
                 std::size_t count, const platform::Threads& threads) {
  Scalp scalp;
  count = std::min(count, strands.count() / kFewestRoots);
  if (count == 0) return scalp;
  const Eigen::AlignedBox3f box = box_of_roots(strands);
  scalp.radius = 0.5f * box.sizes().maxCoeff();
  scalp.reach = kReach * scalp.radius;
  const float length = std::accumulate(strands.lengths.begin(), strands.lengths.end(), 0.0f) / float(strands.count());
  if (!(length < kLock * scalp.radius)) return scalp;

  std::vector<RootPart> parts(strands.count());
  parallel_for(parts.size(), threads,
               [&](std::size_t i) { parts[i] = root_part(groom, is_reversed[i] != 0, i, scalp.reach); });
  const float apart = scalp.radius * std::sqrt(2 * std::numbers::pi_v<float> / float(count));  // on half a sphere
  const auto groups = group_roots(parts, scalp.reach, apart, count, threads);
  scalp.patches.resize(groups.size());
  parallel_for(groups.size(), threads, [&](std::size_t g) {
    ScalpPatch& patch = scalp.patches[g];
    patch.members = groups[g];
    set_axes(parts, box.center(), patch);
    set_skin(parts, patch);
    for (const std::uint32_t i : patch.members) lay_down(patch, parts[i]);
  });
  scalp.at_rim = rim_of(parts, box.center(), scalp.radius);
  scalp.strands = groom_of(groom, parts);
  return scalp;
}

}  // namespace coif::cards
