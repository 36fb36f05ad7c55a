#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::grow {

/// Triangles of a body, which may have holes, overlaps and parts within others: how far a point is from them, and on
/// which side.
class BodySurface {
 public:
  /// `triangles`: three indices of `positions` each, counter-clockwise seen from outside; one at least.
  BodySurface(std::vector<Eigen::Vector3f> positions, std::vector<std::uint32_t> triangles);

  /// Metres to the nearest triangle; `most` if none is nearer.
  [[nodiscard]] float distance(const Eigen::Vector3f& point, float most) const;

  /// The nearest triangle and how far it is, sooner found where `guess` is one near it.
  struct Nearest {
    std::uint32_t triangle = 0;
    float distance = 0;
  };
  [[nodiscard]] Nearest nearest(const Eigen::Vector3f& point, std::uint32_t guess) const;

  /// By the generalized winding number (Jacobson, Kavan and Sorkine-Hornung 2013), with dipoles for far triangles
  /// (Barill et al. 2018).
  [[nodiscard]] bool is_inside(const Eigen::Vector3f& point) const;

  [[nodiscard]] const Eigen::AlignedBox3f& box() const { return nodes_.front().box; }
  [[nodiscard]] const std::vector<Eigen::Vector3f>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<std::uint32_t>& triangles() const { return triangles_; }

 private:
  /// A node in a tree of boxes, children after each other; its triangles begin at `first`.
  struct Node {
    Eigen::AlignedBox3f box;
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();  ///< Mean of the triangles, weighted by area.
    Eigen::Vector3f area = Eigen::Vector3f::Zero();    ///< Sum of the triangles' areas as vectors.
    float radius = 0;                                  ///< About the middle.
    std::uint32_t first = 0, count = 0;
    std::uint32_t children = 0;  ///< The first of two; 0: a leaf.
  };

  void build(std::uint32_t node);
  [[nodiscard]] float squared_distance_to(const Eigen::Vector3f& point, std::size_t triangle) const;
  /// The nearest triangle below the square root of `least`, which is updated; kNone where there is none.
  std::uint32_t search(const Eigen::Vector3f& point, float& least) const;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  [[nodiscard]] const Eigen::Vector3f& corner(std::size_t triangle, std::size_t k) const {
    return positions_[triangles_[3 * triangle + k]];
  }

  std::vector<Eigen::Vector3f> positions_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace coif::grow
