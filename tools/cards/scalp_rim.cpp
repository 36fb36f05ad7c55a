#include "cards/scalp_patches.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace coif::cards {
namespace {

using Eigen::Vector3f;

constexpr int kCells = 3;  // per reach
/// Roots on the side of one where fewer are, of the usual number of a side. With as few as the first it is at the rim,
/// with the second it is not, with a share in between, so that what is left does not begin at a line.
constexpr float kIsRim = 0.5f, kIsNoRim = 0.8f;
constexpr float kThin = 0.5f;  // Share of the usual number around roots, as which fewer count.

struct RootCell {
  Vector3f sum = Vector3f::Zero();
  float count = 0;

  [[nodiscard]] Vector3f middle() const { return sum / count; }
};

/// Roots within reach of a place.
struct RootsAround {
  float all = 0, fewer = 0;  ///< How many, and how many on the side where fewer are.
};

/// Roots in cubes.
class RootCells {
 public:
  RootCells(std::span<const Vector3f> roots, const Vector3f& inside, float reach)
      : reach_(reach), size_(reach / float(kCells)) {
    for (const Vector3f& root : roots) {
      RootCell& cell = cells_[key(place_of(root))];
      cell.sum += root;
      ++cell.count;
    }
    for (const auto& [number, cell] : cells_) around_.emplace(number, count_around(cell.middle(), inside));
  }

  [[nodiscard]] const RootsAround& around(const Vector3f& root) const { return around_.at(key(place_of(root))); }

 private:
  using Place = Eigen::Matrix<std::int64_t, 3, 1>;

  [[nodiscard]] Place place_of(const Vector3f& at) const {
    return (at / size_).array().floor().matrix().cast<std::int64_t>();
  }

  [[nodiscard]] static std::uint64_t key(const Place& place) {
    constexpr std::int64_t kMask = (1 << 21) - 1;
    return std::uint64_t((place.x() & kMask) | ((place.y() & kMask) << 21) | ((place.z() & kMask) << 42));
  }

  /// Calls take(way, cell) for each cell whose middle is within reach.
  void for_each_around(const Vector3f& at, const auto& take) const {
    const Place place = place_of(at);
    for (std::int64_t k = 0, side = 2 * kCells + 1; k < side * side * side; ++k) {
      const Place beside(k % side - kCells, k / side % side - kCells, k / (side * side) - kCells);
      const auto found = cells_.find(key(place + beside));
      if (found == cells_.end()) continue;
      const Vector3f way = found->second.middle() - at;
      if (way.norm() < reach_) take(way, found->second);
    }
  }

  [[nodiscard]] RootsAround count_around(const Vector3f& at, const Vector3f& inside) const {
    RootsAround around;
    const Vector3f out = (at - inside).normalized();
    Vector3f to_most = Vector3f::Zero();
    for_each_around(at, [&](const Vector3f& way, const RootCell& cell) {
      around.all += cell.count;
      to_most += cell.count * (way - way.dot(out) * out);
    });
    for_each_around(at, [&](const Vector3f& way, const RootCell& cell) {
      const float side = way.dot(to_most);
      around.fewer += side < 0 ? cell.count : side > 0 ? 0.0f : 0.5f * cell.count;
    });
    return around;
  }

  float reach_, size_;
  std::unordered_map<std::uint64_t, RootCell> cells_;
  std::unordered_map<std::uint64_t, RootsAround> around_;
};

}  // namespace

std::vector<std::uint8_t> roots_at_rim(std::span<const Vector3f> roots, const Vector3f& inside, float reach) {
  std::vector<std::uint8_t> at_rim(roots.size(), 0);
  if (roots.empty() || !(reach > 0)) return at_rim;
  const RootCells cells(roots, inside, reach);
  std::vector<float> all;
  for (const Vector3f& root : roots) all.push_back(cells.around(root).all);
  const float usual = quantile(all, 0.5f);
  constexpr double kGolden = 0.6180339887;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const RootsAround& around = cells.around(roots[i]);
    const float share_at_rim =
        (kIsNoRim - 2 * around.fewer / std::max(kThin * usual, around.all)) / (kIsNoRim - kIsRim);
    const double turns = kGolden * double(i);  // Fractions of these are even between 0 and 1.
    at_rim[i] = float(turns - std::floor(turns)) < share_at_rim ? 1 : 0;
  }
  return at_rim;
}

}  // namespace coif::cards
