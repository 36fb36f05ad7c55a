#include "base/cubes.h"
#include "cards/scalp_patches.h"

#include <algorithm>
#include <cmath>

namespace coif::cards {
namespace {

using Eigen::Vector3f;

constexpr int kCubes = 3;  // per reach
/// Roots on the side of one where fewer are, of the usual number of a side. With as few as the first it is at the rim,
/// with the second it is not, with a share in between, so that what is left does not begin at a line.
constexpr float kIsRim = 0.5f, kIsNoRim = 0.8f;
constexpr float kThin = 0.5f;  // Share of the usual number around roots, as which fewer count.

/// The roots in a cube, and those within reach of their mean.
struct RootCube {
  Vector3f sum = Vector3f::Zero();
  float count = 0;
  float around = 0, fewer = 0;  ///< How many are within reach, and how many of them on the side where fewer are.

  [[nodiscard]] Vector3f middle() const { return sum / count; }
};

using RootCubes = Cubes<RootCube>;

void count_around(const RootCubes& cubes, const Vector3f& inside, float reach, RootCube& cube) {
  const Vector3f at = cube.middle(), out = (at - inside).normalized();
  const auto for_each_within_reach = [&](const auto& take) {
    cubes.for_each_around(at, kCubes, [&](const RootCube& other) {
      const Vector3f way = other.middle() - at;
      if (way.norm() < reach) take(way, other.count);
    });
  };
  Vector3f to_most = Vector3f::Zero();
  for_each_within_reach([&](const Vector3f& way, float count) {
    cube.around += count;
    to_most += count * (way - way.dot(out) * out);
  });
  for_each_within_reach([&](const Vector3f& way, float count) {
    const float side = way.dot(to_most);
    cube.fewer += side < 0 ? count : side > 0 ? 0.0f : 0.5f * count;
  });
}

RootCubes cubes_of(std::span<const Vector3f> roots, const Vector3f& inside, float reach) {
  RootCubes cubes(reach / float(kCubes));
  for (const Vector3f& root : roots) {
    RootCube& cube = cubes.at(root);
    cube.sum += root;
    ++cube.count;
  }
  cubes.for_each([&](RootCube& cube) { count_around(cubes, inside, reach, cube); });
  return cubes;
}

}  // namespace

std::vector<std::uint8_t> roots_at_rim(std::span<const Vector3f> roots, const Vector3f& inside, float reach) {
  std::vector<std::uint8_t> at_rim(roots.size(), 0);
  if (roots.empty() || !(reach > 0)) return at_rim;
  const RootCubes cubes = cubes_of(roots, inside, reach);
  std::vector<float> around;
  for (const Vector3f& root : roots) around.push_back(cubes.at(root).around);
  const float usual = quantile(around, 0.5f);
  constexpr double kGolden = 0.6180339887;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const RootCube& cube = cubes.at(roots[i]);
    const float share_at_rim = (kIsNoRim - 2 * cube.fewer / std::max(kThin * usual, cube.around)) / (kIsNoRim - kIsRim);
    const double turns = kGolden * double(i);  // Fractions of these are even between 0 and 1.
    at_rim[i] = float(turns - std::floor(turns)) < share_at_rim ? 1 : 0;
  }
  return at_rim;
}

}  // namespace coif::cards
