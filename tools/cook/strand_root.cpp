#include "cook/strand_root.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr float kEnd = 0.25f;  ///< Share of the patch at each end that is looked at.

struct End {
  double distance = 0, depth = 0, height = 0;
  double count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& p, const FittedHead& head, double depth_here) {
    distance += head.distance(p);
    depth += depth_here;
    height += p.y();
    sum += p;
    squares += p.cwiseAbs2();
    count += 1;
  }

  void finish() {
    const double n = std::max(count, 1.0);
    distance /= n;
    depth /= n;
    height /= n;
    sum /= n;
    squares /= n;
  }

  /// Root mean square distance from the end's middle.
  [[nodiscard]] double spread() const { return std::sqrt(std::max(0.0, (squares - sum.cwiseAbs2()).sum())); }
};

float depth_of(const HairMesh& mesh, std::uint32_t v, std::span<const float> depth_of_node) {
  float depth = 0;
  for (const SourceInfluence& influence : mesh.influences_of(v)) {
    depth += influence.weight * depth_of_node[influence.node];
  }
  return depth;
}

float limited(double value) { return float(std::clamp(value, -1.0, 1.0)); }

}  // namespace

RootEvidence weigh_ends(const HairMesh& mesh, const PatchView& patch, const StrandAxis& axis, const FittedHead& head,
                        std::span<const float> depth_of_node) {
  End low, high;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const float at = axis.coordinate[i];
    if (at > kEnd && at < 1 - kEnd) continue;
    const std::uint32_t v = patch.vertices[i];
    (at <= kEnd ? low : high).add(mesh.positions[v].cast<double>(), head, double(depth_of(mesh, v, depth_of_node)));
  }
  low.finish();
  high.finish();
  const double size = head.radii.mean();
  RootEvidence evidence;
  // Half a radius apart there is no doubt. Where both ends lie on the skull the difference says more about the skull's
  // shape, which is only roughly known, than about the hair.
  const double away = std::clamp(std::max(high.distance, low.distance) / (0.5 * size), 0.0, 1.0);
  evidence.distance = limited(away * (high.distance - low.distance) / (0.5 * size));
  evidence.bones = limited(high.depth - low.depth);
  evidence.height = limited((low.height - high.height) / size);
  evidence.taper = limited((low.spread() - high.spread()) / std::max(low.spread() + high.spread(), 1.0e-9));
  return evidence;
}

}  // namespace coif
