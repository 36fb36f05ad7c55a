#pragma once

#include "cook/select/hair_evidence.h"
#include "cook/select/head_room.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace coif::cook {

/// A head as the centre of a view in all directions, in its own radii.
struct HeadView {
  HeadEllipsoid head;
  double forwards = 1;          ///< 1: it looks along +Z, -1: along -Z.
  bool shows_forwards = false;  ///< Its joints say so.

  [[nodiscard]] Eigen::Vector3d in_axes(const Eigen::Vector3f& p) const {
    const Eigen::Vector3d at = (p.cast<double>() - head.center).cwiseQuotient(head.radii);
    return {forwards * at.x(), at.y(), forwards * at.z()};
  }
};

/// The head by its joints; where these do not show its size, by the largest piece that follows the bone `node` alone
/// and reaches down to its joint. None without a head bone.
[[nodiscard]] std::optional<HeadView> view_of_head(const importer::SourceModel& source, std::uint32_t node,
                                                   double weld_distance);

/// What one part of a model covers of a head: shares of the directions in which it is outermost, 0..1.
struct Coverage {
  double crown = 0;
  double face = 0;
  double middle_of_face = 0;  ///< Between brows and mouth, where only skin is, or a mask.
};

/// Which part is outermost in each of some hundred directions from the middle of a head.
class Outermost {
 public:
  Outermost();

  /// Adds a triangle of a part by its corners in HeadView::in_axes(). What is seen nearer or farther than a head with
  /// its hair reaches does not count.
  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, std::uint32_t part);

  /// One entry per part, of `count`.
  [[nodiscard]] std::vector<Coverage> shares(std::size_t count) const;

 private:
  std::vector<Eigen::Vector3d> directions_;
  std::vector<double> far_;
  std::vector<std::uint32_t> part_;
};

/// How wide the face is open in what surrounds the top of a model, all of which may be hair: the widest part of the
/// circle around the head, 0..1, in which nothing is seen at the height of a face. A head closes it, and hair over it.
[[nodiscard]] double open_face(const importer::SourceModel& source);

}  // namespace coif::cook
