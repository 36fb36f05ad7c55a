#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <unordered_map>

namespace coif {

/// What lies in space, by even cubes, of which only those in use take memory. Places 2^21 cubes apart share one.
template <class Held>
class Cubes {
 public:
  /// `size`: length of a side, > 0.
  explicit Cubes(float size) : size_(size) {}

  /// What the cube around a place holds; empty at first.
  [[nodiscard]] Held& at(const Eigen::Vector3f& place) { return cubes_[key(cube_of(place))]; }
  /// The same of a cube that is in use; throws std::out_of_range for others.
  [[nodiscard]] const Held& at(const Eigen::Vector3f& place) const { return cubes_.at(key(cube_of(place))); }

  /// Calls take(held) for each cube in use up to so many beside that of a place, X first and Z last.
  void for_each_around(const Eigen::Vector3f& place, std::int64_t beside, const auto& take) const {
    const Cube home = cube_of(place);
    for (std::int64_t n = 0, side = 2 * beside + 1; n < side * side * side; ++n) {
      const Cube step(n % side - beside, n / side % side - beside, n / (side * side) - beside);
      const auto found = cubes_.find(key(home + step));
      if (found != cubes_.end()) take(found->second);
    }
  }

  /// Calls take(held) for each cube in use, in any order.
  void for_each(const auto& take) {
    for (auto& [number, held] : cubes_) take(held);
  }

 private:
  using Cube = Eigen::Matrix<std::int64_t, 3, 1>;

  [[nodiscard]] Cube cube_of(const Eigen::Vector3f& place) const {
    return (place / size_).array().floor().matrix().template cast<std::int64_t>();
  }
  [[nodiscard]] static std::uint64_t key(const Cube& cube) {
    const auto bits = [](std::int64_t v) { return std::uint64_t(v) & 0x1FFFFF; };
    return bits(cube.x()) | bits(cube.y()) << 21 | bits(cube.z()) << 42;
  }

  float size_;
  std::unordered_map<std::uint64_t, Held> cubes_;
};

}  // namespace coif
