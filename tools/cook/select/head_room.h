#pragma once

#include "cook/select/hair_mesh.h"

#include <Eigen/Core>

#include <functional>
#include <stop_token>

namespace coif::cook {

/// An ellipsoid with semi-axes along the model's axes; metres, model space.
struct HeadEllipsoid {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d radii = Eigen::Vector3d::Ones();  ///< > 0.

  /// 1 on the surface, less inside.
  [[nodiscard]] double scaled_distance(const Eigen::Vector3d& point) const {
    return (point - center).cwiseQuotient(radii).norm();
  }
  /// Metres from the surface, negative inside; exact on spheres, else along the ray to the centre.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const {
    const double scaled = scaled_distance(point);
    return scaled > 0 ? (point - center).norm() * (1 - 1 / scaled) : -radii.minCoeff();
  }
};

/// The estimate of a head before its hair is looked at, and its uncertainty: standard deviations.
struct HeadGuess {
  HeadEllipsoid shape;
  Eigen::Vector3d center_spread;  ///< The centre's, in mean radii.
  double shape_spread = 0;        ///< For the logarithm of each radius relative to their common size.
  double size_spread = 0;         ///< For the logarithm of that size.
};

/// How unlikely a head is by all that is known of it but its hair: a sum of squared deviations.
using HeadSurprise = std::function<double(const HeadEllipsoid&)>;

/// Finds a head near `head` whose `cost` no small change of middle or radii lessens; `step`: the first change, in mean
/// radii.
[[nodiscard]] HeadEllipsoid descend(HeadEllipsoid head, const HeadSurprise& cost, double step);

/// The head on which a guess and the hair agree best. Seen from the head's middle, the innermost hair lies close to the
/// head all around. A little of it is sunk in, as roots are, which costs far more than hovering hair does; and nowhere
/// does the head come out through the outermost hair. Deterministic; bounded work for every mesh.
[[nodiscard]] HeadEllipsoid fit_head_room(const HairMesh& hair, const HeadGuess& guess,
                                          const std::stop_token& stop = {});
/// The same, beginning at `first`, where more is known of the head than a guess says.
[[nodiscard]] HeadEllipsoid fit_head_room(const HairMesh& hair, const HeadEllipsoid& first,
                                          const HeadSurprise& surprise, const std::stop_token& stop = {});

/// How much of the hair is inside a head, shares 0..1.
struct HairInside {
  double area = 0;      ///< Share of the hair's surface.
  double vertices = 0;  ///< Share of its vertices.
  double pokes = 0;     ///< Share of the directions with hair near the head in which none is outside of it.
};

[[nodiscard]] HairInside hair_inside(const HairMesh& hair, const HeadEllipsoid& head);

/// How hair lies around a head; shares 0..1 of the directions from its middle that point up, or level to the back.
struct HairCover {
  double around = 0;    ///< With hair no farther from the head than half a radius.
  double hovering = 0;  ///< Mean distance of the innermost hair in these, radii, 0..0.5.
};

[[nodiscard]] HairCover hair_cover(const HairMesh& hair, const HeadEllipsoid& head);

/// The largest factor, at most 1, on a head's size with which every share is within `most`.
[[nodiscard]] double share_with_room(const HairMesh& hair, const HeadEllipsoid& head, const HairInside& most);

}  // namespace coif::cook
