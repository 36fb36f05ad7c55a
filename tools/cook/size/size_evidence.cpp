#include "cook/size/evidence.h"

#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

// How fast a length becomes unlikely: deviations of its logarithm. Dolls are less rare than giants.
constexpr double kSmaller = 0.72, kLarger = 0.55;
constexpr double kFloor = -9;  ///< Nothing is less likely: an outlier is one.

constexpr double kFlatHair = 0.3;  ///< Depth over width: below, hair has no head inside.
/// Range of the hair's width in radii of the head; outside it the head is not the hair's.
constexpr double kLeastOfHead = 1.4, kMostOfHead = 8;
constexpr double kRibbon = 4;           ///< A strip's length over its width, at least.
constexpr double kMostlyRibbons = 0.3;  ///< Share of the hair's surface that strips have to be.

double square(double value) { return value * value; }

double likelihood_of(const SizeEvidence& item, double factor) {
  const double length = item.metres * factor;
  double deviations = 0;
  if (length < item.low) deviations = std::log(item.low / length) / (item.spread * kSmaller);
  if (length > item.high) deviations = std::log(length / item.high) / (item.spread * kLarger);
  return std::max(-0.5 * square(deviations), kFloor);
}

/// Lengths are in the imported model's units; a length of zero gives no evidence.
class SizeMeasures {
 public:
  explicit SizeMeasures(double scale) : scale_(scale) {}
  void add(SizeEvidence item) {
    item.metres /= scale_;
    if (item.metres > 0 && std::isfinite(item.metres)) evidence_.push_back(item);
  }
  std::vector<SizeEvidence> finish() && { return std::move(evidence_); }

 private:
  double scale_;
  std::vector<SizeEvidence> evidence_;
};

void measure_head(const KnownModel& known, const HairRecipe& recipe, SizeMeasures& measures) {
  const Vector3d size = known.hair.box().sizes();
  const double narrow = std::min(size.x(), size.z()), wide = std::max(size.x(), size.z());
  const auto head_bone = find_head_bone(known.model, known.hair, recipe.head_bone);
  if (!head_bone) return;
  const HeadSign sign = first_sign_of_head(known.model, known.hair, *head_bone);
  if (!sign.is_shown && (known.on_face || narrow < kFlatHair * wide || known.model.scalp_radius > 0)) return;
  const double radius = sign.shape.radii.mean();
  const bool fits = wide > kLeastOfHead * radius && wide < kMostOfHead * radius;
  measures.add({sign.is_shown ? "the head's radius" : "the radius of the room for a head in the hair", radius, 0.075,
                0.17, (sign.is_shown ? 1.0 : 0.9) * (fits ? 1.0 : 0.5), true});
}

/// Grooms without a unit are in the units of the head that they were grown on: their roots say more than the usual
/// units.
void measure_scalp(const KnownModel& known, SizeMeasures& measures) {
  constexpr double kSure = 0.5;
  measures.add({"the radius of the scalp that roots lie on", known.model.scalp_radius, 0.075, 0.12, 1, true, kSure});
}

void measure_body(const KnownModel& known, SizeMeasures& measures) {
  const importer::SourceModel& model = known.model;
  if (moves_limbs(model)) {
    Eigen::AlignedBox3f box;
    for (const importer::SourceMesh& mesh : model.meshes) {
      for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
    }
    measures.add({"the body's height", double(box.sizes().y()), 0.8, 2.3, 1, true});
  }
  const std::uint32_t head = guess_head_node(model);
  if (head == importer::kNoIndex) return;
  const Vector3d at = model.nodes[head].model_from_node.translation();
  const auto farthest = [&](BodyPart part) {
    double distance = 0;
    for (const Vector3d& joint : joints_of(model, part)) distance = std::max(distance, (joint - at).norm());
    return distance;
  };
  if (const double feet = farthest(BodyPart::kFeet); feet > 0) {
    measures.add({"from the head's joint to the feet's", feet, 0.6, 2.0, 0.8, true});
  } else if (const double trunk = farthest(BodyPart::kTrunk); trunk > 0) {
    measures.add({"from the head's joint to the lowest of the trunk", trunk, 0.15, 0.9, 0.6, true});
  } else if (const double neck = farthest(BodyPart::kNeck); neck > 0) {
    measures.add({"from the head's joint to the neck's", neck, 0.03, 0.2, 0.5, true});
  }
}

/// The width of strips that more than half of the strips' surface exceeds; 0 where there are hardly any strips.
double width_of_strips(const HairMesh& hair) {
  struct Piece {
    double area = 0;
    Eigen::AlignedBox3f box;
  };
  DisjointSets sets(hair.positions.size());
  for (std::size_t i = 0; i < hair.triangles.size(); ++i) sets.unite(hair.triangles[i], hair.triangles[i / 3 * 3]);
  std::vector<Piece> pieces(hair.positions.size());
  double all = 0;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    Piece& piece = pieces[sets.find(hair.triangles[3 * t])];
    for (std::size_t k = 0; k < 3; ++k) piece.box.extend(hair.corner(t, k));
    const double area =
        0.5 * double((hair.corner(t, 1) - hair.corner(t, 0)).cross(hair.corner(t, 2) - hair.corner(t, 0)).norm());
    piece.area += area;
    all += area;
  }
  std::vector<std::pair<double, double>> widths;  // Widths and areas.
  double ribbons = 0;
  for (const Piece& piece : pieces) {
    if (!(piece.area > 0)) continue;
    const double length = double(piece.box.diagonal().norm());
    if (length * length < kRibbon * piece.area) continue;
    widths.emplace_back(piece.area / length, piece.area);
    ribbons += piece.area;
  }
  if (!(ribbons > kMostlyRibbons * all)) return 0;
  std::ranges::sort(widths);
  double below = 0;
  const auto middle = std::ranges::find_if(widths, [&](const auto& w) { return (below += w.second) >= ribbons / 2; });
  return middle == widths.end() ? 0 : middle->first;
}

void measure_hair(const KnownModel& known, SizeMeasures& measures) {
  const double size = known.hair.box().sizes().maxCoeff();
  if (known.on_face) {
    measures.add({"the size of the brows, lashes or beard", size, 0.025, 0.3, 0.6});
  } else {
    measures.add({"the hair's largest side", size, 0.15, 1.6, 0.6});
  }
  measures.add({"the width of a strip", width_of_strips(known.hair), 0.002, 0.1, 0.3});
}

}  // namespace

std::vector<SizeEvidence> measure_model(const KnownModel& known, const HairRecipe& recipe) {
  SizeMeasures measures(known.scale);
  if (!known.hair.triangles.empty()) {
    measure_head(known, recipe, measures);
    measure_hair(known, measures);
  }
  measure_scalp(known, measures);
  measure_body(known, measures);
  return std::move(measures).finish();
}

double size_likelihood(std::span<const SizeEvidence> evidence, double factor) {
  double hair = 0, person = 0, person_weight = 0;
  for (const SizeEvidence& item : evidence) {
    const double likelihood = item.weight * likelihood_of(item, factor);
    (item.of_person ? person : hair) += likelihood;
    if (item.of_person) person_weight += item.weight;
  }
  // A large head on a large body is one observation, not two.
  return hair + person / std::max(1.0, person_weight);
}

}  // namespace coif::cook
