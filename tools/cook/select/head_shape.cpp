#include "base/geometry.h"
#include "base/text.h"
#include "cook/recipe/decision.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/head.h"
#include "cook/select/head_landmarks.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kSmallestRadius = 0.001;  ///< Metres: flat hair encloses nothing.

/// Hair that a head may hold at rest: sunk roots, and no more of the picture than a few of them.
constexpr HairInside kMostInside{0.03, 0.03, 0.005};
constexpr double kWorthAWord = 1.3;    ///< Times kMostInside: less is what shrinking leaves over.
constexpr double kLeastOfWhole = 0.7;  ///< A whole head's mesh that has to shrink further was none.
constexpr double kLeastOfPart = 0.8;   ///< Where joints or a face tell, hair around the skull may be modelled inside.
constexpr double kLeastOfHair = 0.4;   ///< Hair alone is less certain: strips on one side show little.

using Box = Eigen::AlignedBox3d;

/// Sphere through points by linear least squares: |p|^2 = 2 c.p + (r^2 - |c|^2). Points relative to their mean.
std::pair<Vector3d, double> fit_sphere(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / double(points.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Vector3d& p : points) {
    const Vector3d d = p - mean;
    const Eigen::Vector4d row(2 * d.x(), 2 * d.y(), 2 * d.z(), 1);
    normal += row * row.transpose();
    right += row * d.squaredNorm();
  }
  const Eigen::Vector4d solution = least_squares(normal, right);
  const Vector3d center = solution.head<3>();
  return {mean + center, std::sqrt(std::max(0.0, solution[3] + center.squaredNorm()))};
}

}  // namespace

HeadEllipsoid ellipsoid_under_top(const HairMesh& hair) {
  const Box box = hair.box();
  const double width = std::min(box.sizes().x(), box.sizes().z());
  std::vector<Vector3d> cap;
  for (const Eigen::Vector3f& p : hair.positions) {
    // Take at least the topmost vertex, even if flat hair has no width.
    if (double(p.y()) >= box.max().y() - 0.5 * width) cap.push_back(p.cast<double>());
  }
  auto [center, radius] = fit_sphere(cap);
  // A flat or ragged cap can put the sphere anywhere: keep it within the hair's own size.
  if (!(radius > 0.2 * width && radius < 0.8 * width) || !box.contains(center)) {
    radius = 0.4 * width;
    center = Vector3d(box.center().x(), box.max().y() - 0.5 * width, box.center().z());
  }
  return {center, radius * Vector3d(0.9, 1.1, 1.0)};
}

HeadEllipsoid ball_below_top(const Box& box, double width, double z) {
  constexpr double kBelowTop = 0.65, kRadius = 0.45;  // of the width
  return {{box.center().x(), box.max().y() - kBelowTop * width, z}, Vector3d::Constant(kRadius * width)};
}

namespace {

/// Hair is combed to one side more often than faces look there.
HeadGuess guess_by_hair(const HairMesh& hair) {
  HeadGuess guess{ellipsoid_under_top(hair), {0.15, 0.4, 0.4}, 0.12, 0.5};
  guess.shape.radii = guess.shape.radii.cwiseMax(kSmallestRadius);
  return guess;
}

/// The head behind a full beard, which is as wide as the jaw and runs from the ears round the chin. Nothing where it is
/// not as deep as that, as a moustache.
std::optional<HeadEllipsoid> head_behind_beard(const HairMesh& hair, double& forwards) {
  // In semi-axes of the head, of beards of two makers, which agree within a tenth.
  constexpr double kWidth = 1.03, kTop = -0.28, kFront = 1.06, kLeastDepth = 0.45;
  constexpr double kFlatness = 0.887, kDepth = 0.98;
  const Box box = hair.box();
  if (!(box.sizes().z() > kLeastDepth * box.sizes().x())) return std::nullopt;
  double high = 0, low = 0, of_high = 0, of_low = 0;
  for (const Eigen::Vector3f& p : hair.positions) {
    const bool is_high = double(p.y()) > box.center().y();
    (is_high ? high : low) += double(p.z());
    (is_high ? of_high : of_low) += 1;
  }
  if (forwards == 0) forwards = low / std::max(of_low, 1.0) < high / std::max(of_high, 1.0) ? -1 : 1;
  HeadEllipsoid head;
  const double width = box.sizes().x() / 2 / kWidth, height = width / kFlatness, depth = kDepth * height;
  head.radii = {width, height, depth};
  const double front = forwards < 0 ? box.min().z() : box.max().z();
  head.center = {box.center().x(), box.max().y() - kTop * height, front - forwards * kFront * depth};
  return head;
}

/// Shrinks it, to `least` of its size at the utmost, until hardly any hair is inside. Returns the factor.
double make_room(const HairMesh& hair, double least, FittedHead& head, Findings& findings) {
  const double share = share_with_room(hair, head, kMostInside);
  const double factor = std::clamp(share * 0.999, least, 1.0);
  head.radii *= factor;
  head.radii = head.radii.cwiseMax(kSmallestRadius);
  const HairInside inside = hair_inside(hair, head);
  const double most = kWorthAWord * kMostInside.area;
  if (inside.area <= most && inside.vertices <= std::max(most, 1.0 / double(hair.positions.size()))) return factor;
  findings.warn(
      "C111",
      fmt::format("{:.0f} % of the hair's surface is inside the head, even where that is made {:.0f} % as large as it "
                  "looks; if it is not the head, set \"head.center\" and \"head.radii\" in the recipe",
                  100 * std::max(inside.area, inside.vertices), 100 * least));
  return factor;
}

}  // namespace

HeadSign first_sign_of_head(const importer::SourceModel& source, const HairMesh& hair, const HeadBone& head_bone) {
  const HeadLandmarks landmarks = find_landmarks(source, hair, head_bone);
  if (landmarks.show_size()) return {likeliest_head(landmarks), true};
  return {ellipsoid_under_top(hair), false};
}

namespace {

// By fit_decisions.py: where joints show the head it is seldom wrong; where only hair does, its first guess and the
// hair may disagree, hair may hover, or leave the crown bare.
constexpr std::array kHeadWeights{FeatureWeight{"joint", 1.47},     FeatureWeight{"mesh", -0.93},
                                  FeatureWeight{"moved", -1.96},    FeatureWeight{"moved alone", -0.86},
                                  FeatureWeight{"hovering", -0.98}, FeatureWeight{"bare", -1.16},
                                  FeatureWeight{"rival", -1.35},    FeatureWeight{"shrunk", -0.43}};
constexpr Logistic kHead{3.41, kHeadWeights};

/// The head as it was before the hair was looked at, as it was with it, and how much it shrank.
struct HeadFit {
  HeadEllipsoid first, fitted;
  double share = 1;
  bool has_rival = false;  ///< Hair may lie on a larger head as well.
};

/// The room under the hair's top, or a clearly larger one below, on which a bun or a crest stands, that hair covers
/// well and closely.
HeadFit fit_by_hair(const HairMesh& hair, const std::stop_token& stop) {
  constexpr double kLarger = 1.28, kNotThatLarge = 5;
  constexpr double kSome = 0.4, kWell = 0.75, kClosely = 0.15;  // of its upper half, and of its radii
  const HeadGuess under_top = guess_by_hair(hair);
  HeadFit best{under_top.shape, fit_head_room(hair, under_top, stop)};
  const Box box = hair.box();
  for (const double width : {box.sizes().x(), box.sizes().z()}) {
    HeadGuess lower = under_top;
    lower.shape = ball_below_top(box, width, under_top.shape.center.z());
    lower.shape.radii = lower.shape.radii.cwiseProduct(Vector3d(0.9, 1.1, 1.0)).cwiseMax(kSmallestRadius);
    const HeadEllipsoid fitted = fit_head_room(hair, lower, stop);
    const HairCover other = hair_cover(hair, fitted);
    const double larger = fitted.radii.mean() / best.fitted.radii.mean();
    if (!(larger > kLarger && larger < kNotThatLarge)) continue;
    best.has_rival = best.has_rival || other.around > kSome;
    if (other.around > kWell && other.hovering < kClosely) best = {lower.shape, fitted, 1, true};
  }
  return best;
}

Features features_of(const HairMesh& hair, const HeadLandmarks& marks, const HeadFit& fit) {
  const HairCover cover = hair_cover(hair, fit.fitted);
  const double grown = std::log(fit.fitted.radii.mean() / fit.first.radii.mean());
  const double moved = (fit.fitted.center - fit.first.center).norm() / fit.first.radii.mean() + std::abs(grown);
  const bool alone = !marks.joint && !marks.mesh;
  return {{"joint", marks.joint ? 1 : 0},
          {"mesh", marks.mesh ? 1 : 0},
          {"moved", std::min(1.0, moved)},
          {"moved alone", alone ? std::min(1.0, moved) : 0},
          {"hovering", alone ? 2 * cover.hovering : 0},
          {"bare", alone ? 1 - cover.around : 0},
          {"rival", fit.has_rival ? 1 : 0},
          {"shrunk", std::min(1.0, 3 * (1 - fit.share))}};
}

std::string place_text(const HeadEllipsoid& head) {
  return fmt::format("centre ({:.3f}, {:.3f}, {:.3f}) m, radii ({:.3f}, {:.3f}, {:.3f}) m", head.center.x(),
                     head.center.y(), head.center.z(), head.radii.x(), head.radii.y(), head.radii.z());
}

}  // namespace

FittedHead fit_head(const importer::SourceModel& source, const HairMesh& hair, const HeadBone& head_bone,
                    const HairRecipe& recipe, Findings& findings, const std::stop_token& stop) {
  FittedHead head;
  head.shape = recipe.head_shape;
  const HeadLandmarks landmarks = find_landmarks(source, hair, head_bone);
  head.forwards = landmarks.forwards;
  double least = 1;
  HeadFit fit;
  if (recipe.head_center && recipe.head_radii) {
    head.center = Vector3d(recipe.head_center->data());
    head.radii = Vector3d(recipe.head_radii->data()).cwiseMax(kSmallestRadius);
    head.origin = "the recipe";
    head.declared = true;
  } else {
    if (landmarks.show_size()) {
      head.origin = landmarks.text();
      fit.first = likeliest_head(landmarks);
      const auto by_landmarks = [&](const HeadEllipsoid& h) { return surprise(h, landmarks); };
      fit.fitted = fit_head_room(hair, fit.first, by_landmarks, stop);
    } else if (const auto behind = is_beard(source, hair) ? head_behind_beard(hair, head.forwards) : std::nullopt) {
      head.origin = "the width and the place of the beard";
      fit.first = fit.fitted = *behind;
    } else {
      head.origin = "the inside of the hair";
      fit = fit_by_hair(hair, stop);
    }
    static_cast<HeadEllipsoid&>(head) = fit.fitted;
    least = landmarks.has_whole_mesh() ? kLeastOfWhole : landmarks.show_size() ? kLeastOfPart : kLeastOfHair;
  }
  if (head.shape == HeadShape::kSphere) head.radii.setConstant(head.radii.mean());
  if (!head.declared) {
    fit.share = make_room(hair, least, head, findings);
    Decision decision{"head",
                      place_text(head),
                      head.origin,
                      1,
                      "\"head.center\" and \"head.radii\"",
                      features_of(hair, landmarks, fit)};
    decision.probability = kHead.probability(decision.features);
    findings.decide(std::move(decision));
  }
  const HairInside inside = hair_inside(hair, head);
  findings.note(fmt::format("head: {}{:.1f} % of the hair's surface and {:.1f} % of its vertices inside; moved by '{}'",
                            head.declared ? head.origin + ", " + place_text(head) + "; " : "", 100 * inside.area,
                            100 * inside.vertices, head_bone.name));
  return head;
}

}  // namespace coif::cook
