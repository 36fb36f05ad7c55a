#include "cook/order/choose_order.h"
#include "lab/rig.h"
#include "visibility/hair_surface.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3f;

constexpr float kCellsAcross = 96;    ///< Cells along the hair's longest side.
constexpr float kLeastCell = 0.002f;  ///< Metres.
constexpr int kBlurs = 3;             ///< Box blurs one after the other: nearly a Gaussian.
constexpr int kReach = 2;             ///< Cells that each takes in on either side.

/// Share of its surface from which on hair is modelled as locks without gaps, whose own normals are right.
constexpr double kSolid = 0.97;

/// Lines that enter a solid ahead of the point, from either side, do not pass the point first.
bool is_inside(std::span<const ColliderRecord> solids, const Vector3f& point) {
  return std::ranges::any_of(solids, [&](const ColliderRecord& solid) {
    const std::span one(&solid, 1);
    return visibility::solid_depth(one, point, Vector3f::UnitY()) < 0 &&
           visibility::solid_depth(one, point, -Vector3f::UnitY()) < 0;
  });
}

/// How much of each cell hair or head fills, 0..1, blurred: the hair as one soft body.
class SoftBody {
 public:
  SoftBody(const visibility::HairSurface& hair, std::span<const Vector3f> positions) {
    Eigen::AlignedBox3f box;
    for (const auto& triangle : hair.triangles) {
      for (const std::uint32_t v : triangle.vertex) box.extend(positions[v]);
    }
    cell_ = std::max(box.sizes().maxCoeff() / kCellsAcross, kLeastCell);
    const float room = float(kBlurs * kReach + 2) * cell_;
    origin_ = box.min() - Vector3f::Constant(room);
    size_ = ((box.sizes() + Vector3f::Constant(2 * room)) / cell_).array().ceil().cast<int>() + 1;
    filled_.assign(std::size_t(size_.prod()), 0);
    add_hair(hair, positions);
    add_head(hair.solids);
    for (int i = 0; i < kBlurs; ++i) {
      for (int axis = 0; axis < 3; ++axis) blur(axis);
    }
  }

  /// Points out of the body; of any length, 0 where it is the same all around.
  [[nodiscard]] Vector3f outwards(const Vector3f& point) const {
    Vector3f gradient;
    for (int k = 0; k < 3; ++k) {
      const Vector3f step = cell_ * Vector3f::Unit(k);
      gradient[k] = at(point - step) - at(point + step);
    }
    return gradient;
  }

 private:
  [[nodiscard]] std::size_t index(const Eigen::Array3i& cell) const {
    return std::size_t((cell.z() * size_.y() + cell.y()) * size_.x() + cell.x());
  }

  /// A cell that hair passes once from side to side is filled.
  void add_hair(const visibility::HairSurface& hair, std::span<const Vector3f> positions) {
    for (const auto& triangle : hair.triangles) {
      const Vector3f a = positions[triangle.vertex[0]], u = positions[triangle.vertex[1]] - a,
                     v = positions[triangle.vertex[2]] - a;
      const float area = 0.5f * u.cross(v).norm();
      const int rows = std::clamp(int(std::ceil(2 * std::max(u.norm(), v.norm()) / cell_)), 1, 64);
      const float share = area / (cell_ * cell_) / float(rows * rows);
      for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < 2 * i + 1; ++j) {  // of the small triangles that rows of edges cut
          const float s = (float(i) + (j % 2 == 0 ? 2.0f : 1.0f) / 3) / float(rows);
          const float along = (float(j / 2) + (j % 2 == 0 ? 1.0f : 2.0f) / 3) / float(rows);
          const Vector3f point = a + (s - along) * u + along * v;
          const Eigen::Array3i cell = ((point - origin_) / cell_).array().floor().cast<int>();
          float& filled = filled_[index(cell.max(0).min(size_ - 1))];
          filled = std::min(filled + share, 1.0f);
        }
      }
    }
  }

  void add_head(std::span<const ColliderRecord> solids) {
    Eigen::Array3i cell;
    for (cell.z() = 0; cell.z() < size_.z(); ++cell.z()) {
      for (cell.y() = 0; cell.y() < size_.y(); ++cell.y()) {
        for (cell.x() = 0; cell.x() < size_.x(); ++cell.x()) {
          const Vector3f point = origin_ + cell_ * (cell.cast<float>() + 0.5f).matrix();
          if (is_inside(solids, point)) filled_[index(cell)] = 1;
        }
      }
    }
  }

  /// A box blur along one axis.
  void blur(int axis) {
    const std::size_t stride = axis == 0 ? 1 : std::size_t(axis == 1 ? size_.x() : size_.x() * size_.y());
    const int count = size_[axis];
    std::vector<float> line(static_cast<std::size_t>(count));
    Eigen::Array3i cell = Eigen::Array3i::Zero();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (cell[u] = 0; cell[u] < size_[u]; ++cell[u]) {
      for (cell[v] = 0; cell[v] < size_[v]; ++cell[v]) {
        cell[axis] = 0;
        float* const first = &filled_[index(cell)];
        for (int i = 0; i < count; ++i) line[std::size_t(i)] = first[stride * std::size_t(i)];
        for (int i = 0; i < count; ++i) {
          float sum = 0;
          for (int k = std::max(i - kReach, 0); k <= std::min(i + kReach, count - 1); ++k) sum += line[std::size_t(k)];
          first[stride * std::size_t(i)] = sum / (2 * kReach + 1);
        }
      }
    }
  }

  /// Linear between the cells' middles.
  [[nodiscard]] float at(const Vector3f& point) const {
    const Eigen::Array3f place = ((point - origin_) / cell_).array() - 0.5f;
    const Eigen::Array3i low = place.floor().cast<int>();
    const Eigen::Array3f share = place - low.cast<float>();
    float sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Array3i high(corner & 1, corner >> 1 & 1, corner >> 2);
      const float weight = (high > 0).select(share, 1 - share).prod();
      sum += weight * filled_[index((low + high).max(0).min(size_ - 1))];
    }
    return sum;
  }

  float cell_ = 0;
  Vector3f origin_;
  Eigen::Array3i size_;
  std::vector<float> filled_;
};

void set_normal(VertexRecord& vertex, Vector3f normal) {
  constexpr float kLeast = 0.1f;  ///< Less across the strand than that is no direction.
  const Vector3f tangent = Vector3f(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]).normalized();
  normal.normalize();
  normal -= tangent * tangent.dot(normal);
  if (!(normal.norm() > kLeast)) return;
  normal.normalize();
  for (int k = 0; k < 3; ++k) vertex.normal[k] = std::int16_t(std::lround(normal[k] * 32767));
}

}  // namespace

/// The share of its surface at which hair hides what is behind it. A few points of each triangle, with the textures'
/// finest texels.
double hidden_share(const visibility::HairSurface& hair, std::span<const Vector3f> positions) {
  constexpr float kPlaces[][2] = {{1.0f / 3, 1.0f / 3}, {0.6f, 0.2f}, {0.2f, 0.6f}, {0.2f, 0.2f}};
  double hidden = 0, all = 0;
  for (const auto& triangle : hair.triangles) {
    const auto& [a, b, c] = triangle.vertex;
    const double area = double((positions[b] - positions[a]).cross(positions[c] - positions[a]).norm());
    for (const auto& [s, t] : kPlaces) {
      const Eigen::Vector2f place = (1 - s - t) * hair.uvs[a] + s * hair.uvs[b] + t * hair.uvs[c];
      hidden += area * double(hair.alpha.at(place, {}));
      all += area;
    }
  }
  return all > 0 ? hidden / all : 1;
}

void bake_normals(AssetContents& contents, Findings& findings) {
  if (contents.vertices.empty() || contents.material.empty()) return;
  if (contents.material.front().shading != ShadingModel::kVolume) return;
  const lab::OpenedAsset opened(contents);
  const Asset& asset = opened.asset();
  if (!asset.is_open()) return;
  const std::vector<Vector3f> positions = visibility::posed_positions(asset, {});
  const visibility::HairSurface hair(asset, 0);
  if (hidden_share(hair, positions) > kSolid) return;
  const SoftBody body(hair, positions);
  std::size_t count = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vector3f outwards = body.outwards(positions[v]);
    if (!(outwards.norm() > 1e-4f)) continue;
    set_normal(contents.vertices[v], outwards);
    ++count;
  }
  contents.material.front().flags |= kMaterialVolumeNormals;
  findings.note(
      fmt::format("normals: {} of {} vertices have those of the hair as one soft body", count, positions.size()));
}

}  // namespace coif::cook
