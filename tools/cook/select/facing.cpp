#include "cook/select/hair_evidence.h"
#include "cook/select/head.h"

#include <Eigen/Geometry>

#include <cmath>

namespace coif::cook {
namespace {

// Shares of the head's half sizes: the face's range from the chin to the brow, and the largest distance of hair before
// it.
constexpr double kChin = -0.7, kBrow = 0.3, kBefore = 1.8;
constexpr double kStraight = 0.7;   ///< Cosine of 45 degrees: towards the front or the back, and not the sides.
constexpr double kClearly = 3;      ///< Times as much hair on one side as on the other: that is the back of the head.
constexpr double kLeastHair = 0.3;  ///< Square metres by the square of the head's radius; with less the head is bald.

}  // namespace

bool faces_backwards(const importer::SourceModel& source, const HairMesh& hair, const FittedHead& head) {
  if (source.facing != importer::Facing::kUnknown) return source.facing == importer::Facing::kBackwards;
  if (head.forwards != 0) return head.forwards < 0;
  double front = 0, back = 0;  // square metres of hair on the side of +Z and -Z
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    const Eigen::Vector3d a = hair.corner(t, 0).cast<double>(), b = hair.corner(t, 1).cast<double>(),
                          c = hair.corner(t, 2).cast<double>();
    const Eigen::Vector3d from = ((a + b + c) / 3 - head.center).cwiseQuotient(head.radii);
    const double across = std::hypot(from.x(), from.z());
    if (from.y() < kChin || from.y() > kBrow || across > kBefore) continue;
    if (std::abs(from.z()) < kStraight * across) continue;
    (from.z() > 0 ? front : back) += 0.5 * (b - a).cross(c - a).norm();
  }
  const double least = kLeastHair * head.radii.x() * head.radii.z();
  if (hair_is_called(source, hair, is_called_beard, is_called_beard)) return back > front;
  return front > least && front > kClearly * back;
}

}  // namespace coif::cook
