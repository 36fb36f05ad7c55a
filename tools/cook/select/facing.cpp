#include "cook/recipe/decision.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/head.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace coif::cook {
namespace {

// Shares of the head's half sizes: the face's range from the chin to the brow, and the largest distance of hair before
// it.
constexpr double kChin = -0.7, kBrow = 0.3, kBefore = 1.8;
constexpr double kStraight = 0.7;   ///< Cosine of 45 degrees: towards the front or the back, and not the sides.
constexpr double kClearly = 3;      ///< Times as much hair on one side as on the other: that is the back of the head.
constexpr double kLeastHair = 0.3;  ///< Square metres by the square of the head's radius; with less the head is bald.

/// Square metres of hair on the side of +Z and of -Z, at the height of a face.
struct HairBySide {
  double front = 0, back = 0;
};

HairBySide hair_by_side(const HairMesh& hair, const HeadEllipsoid& head) {
  HairBySide sides;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    const Eigen::Vector3d a = hair.corner(t, 0).cast<double>(), b = hair.corner(t, 1).cast<double>(),
                          c = hair.corner(t, 2).cast<double>();
    const Eigen::Vector3d from = ((a + b + c) / 3 - head.center).cwiseQuotient(head.radii);
    const double across = std::hypot(from.x(), from.z());
    if (from.y() < kChin || from.y() > kBrow || across > kBefore) continue;
    if (std::abs(from.z()) < kStraight * across) continue;
    (from.z() > 0 ? sides.front : sides.back) += 0.5 * (b - a).cross(c - a).norm();
  }
  return sides;
}

// By fit_decisions.py: where the crown is bare, hair may be a beard at the front as well as a tail at the back.
constexpr std::array kFacingWeights{FeatureWeight{"joints", 1.12}, FeatureWeight{"behind", 1.31},
                                    FeatureWeight{"beard", 1.25}, FeatureWeight{"bald", -3.87}};
constexpr Logistic kFacing{2.68, kFacingWeights};

/// On which side of the head meshes that are called eyes lie: 1, -1, or 0 where there are none.
double side_of_eyes(const importer::SourceModel& source, const FittedHead& head) {
  Eigen::AlignedBox3d eyes;
  for (const importer::SourceMesh& mesh : source.meshes) {
    if (!either_is_called(source, mesh, is_called_eyeball)) continue;
    for (const Eigen::Vector3f& p : mesh.positions) eyes.extend(p.cast<double>());
  }
  const double at = eyes.isEmpty() ? 0 : (eyes.center().z() - head.center.z()) / head.radii.z();
  return std::abs(at) > 0.3 ? std::copysign(1.0, at) : 0;
}

}  // namespace

bool faces_backwards(const importer::SourceModel& source, const HairMesh& hair, const FittedHead& head,
                     const HairRecipe& recipe, Findings& findings) {
  if (recipe.head_faces != Faces::kAuto) return recipe.head_faces == Faces::kMinusZ;
  if (source.facing != importer::Facing::kUnknown) return source.facing == importer::Facing::kBackwards;
  const HairBySide sides = hair_by_side(hair, head);
  const double least = kLeastHair * head.radii.x() * head.radii.z();
  const bool beard = is_beard(source, hair);
  const double forwards = head.forwards != 0 ? head.forwards : side_of_eyes(source, head);
  bool backwards = forwards < 0;
  if (forwards == 0)
    backwards = beard ? sides.back > sides.front : sides.front > least && sides.front > kClearly * sides.back;

  // Hair hangs at the back of the head, beards at its front.
  const double lead = std::log((sides.back + 0.1 * least) / (sides.front + 0.1 * least)) / std::log(10.0);
  const double behind = std::clamp((backwards != beard ? -1 : 1) * lead, -1.0, 1.0);
  const bool by_joints = forwards != 0;
  Decision facing{"facing", backwards ? "-Z" : "+Z", {}, 1, "\"head.faces\": \"+Z\" or \"-Z\"", {}};
  facing.reason = head.forwards != 0 ? (beard ? "a beard runs back to the ears" : "joints of eyes or toes show it")
                  : by_joints        ? "meshes of eyes show it"
                                     : fmt::format("{:.0f} % of what hangs at a face's height is {}",
                                                   100 * (backwards != beard ? sides.front : sides.back) /
                                                       std::max(sides.front + sides.back, 1.0e-9),
                                            beard ? "before it" : "behind it");
  facing.features = {{"joints", by_joints ? 1 : 0},
                     {"behind", behind},
                     {"beard", beard ? 1 : 0},
                     {"bald", by_joints ? 0 : 1 - hair_cover(hair, head).around}};
  facing.probability = kFacing.probability(facing.features);
  findings.decide(std::move(facing));
  return backwards;
}

}  // namespace coif::cook
