#include "base/cubes.h"
#include "grow/random.h"
#include "grow/strand_paths.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

/// The middles so far, by cubes of their roots.
class Middles {
 public:
  Middles(const StrandPaths& paths, float size, const ClumpMiddles& within)
      : paths_(paths), size_(size), within_(within), cubes_(size) {}

  void add(std::uint32_t strand) { cubes_.at(root_of(strand)).push_back(strand); }

  /// The nearest one of the strand's clump; the strand itself where none is within the size.
  [[nodiscard]] std::uint32_t nearest(std::uint32_t strand) const {
    float least = size_ * size_;
    std::uint32_t best = strand;
    cubes_.for_each_around(root_of(strand), 1, [&](const std::vector<std::uint32_t>& middles) {
      for (const std::uint32_t middle : middles) {
        if (!within_.empty() && within_[middle] != within_[strand]) continue;
        const float apart = squared_distance(strand, middle);
        if (apart < least) {
          least = apart;
          best = middle;
        }
      }
    });
    return best;
  }

 private:
  /// Squared distance of the roots, plus, with less weight, those of the middles and of the tips: hair that a shoulder
  /// parts is not a clump.
  [[nodiscard]] float squared_distance(std::uint32_t a, std::uint32_t b) const {
    const auto first = paths_.strand(a), second = paths_.strand(b);
    const std::size_t half = paths_.stations / 2;
    return (first[0] - second[0]).squaredNorm() + 0.2f * (first[half] - second[half]).squaredNorm() +
           0.06f * (first.back() - second.back()).squaredNorm();
  }

  [[nodiscard]] const Vector3f& root_of(std::uint32_t strand) const { return paths_.strand(strand)[0]; }

  const StrandPaths& paths_;
  float size_;
  const ClumpMiddles& within_;
  Cubes<std::vector<std::uint32_t>> cubes_;
};

}  // namespace

ClumpMiddles find_clumps(const StrandPaths& paths, std::span<const Root> roots, float size, std::uint32_t seed,
                         const ClumpMiddles& within) {
  const Dice dice(seed, Purpose::kClump);
  std::vector<std::uint32_t> order(paths.count());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(dice.unit(i), i); });
  Middles middles(paths, size, within);
  // The middles of larger clumps are middles of smaller ones, too, so that these keep to them.
  for (std::uint32_t i = 0; i < within.size(); ++i) {
    if (within[i] == i && !roots[i].is_wisp) middles.add(i);
  }
  ClumpMiddles found(paths.count());
  for (const std::uint32_t i : order) {
    if (!roots[i].is_wisp && middles.nearest(i) == i && (within.empty() || within[i] != i)) middles.add(i);
  }
  for (const std::uint32_t i : order) found[i] = roots[i].is_wisp ? i : middles.nearest(i);
  return found;
}

}  // namespace coif::grow
