#include "base/geometry.h"
#include "base/parallel_for.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/drawn_recipe.h"
#include "lab/rig.h"
#include "visibility/fragment_view.h"
#include "visibility/hair_surface.h"

#include <coif/view_cells.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

using Eigen::Vector3f;

constexpr float kLines = 128;          ///< Lines of a view along the hair's longest side.
constexpr float kMargin = 1.0f / 256;  ///< Share of that side: hair this close above a card may be the card itself.
constexpr float kNoLight = 1.0e-7f;    ///< Far below the stored precision: further layers change nothing.

/// Largest number of line tests for the triangles of one view, so that time and memory are bounded where all triangles
/// are as large as the hair. Artists' hair is known to need at most a quarter of it.
constexpr double kMostTries = 2.0e6;
constexpr float kFewestLines = 8;

/// With normals of the volume: metres. What lies closer above a point is a part of how the volume reflects, as in
/// shading.glsl.
constexpr float kOwnDepth = 0.006f;

/// A point where light is gathered.
struct Receiver {
  Vector3f point;               ///< The vertex.
  Vector3f outside;             ///< The vertex, moved out of the head if it was inside.
  Vector3f normal;              ///< Normal of the triangles around it; 0 for a vertex without triangles.
  std::uint32_t patch = kNone;  ///< kNone: it is in no triangle.
};

/// Normals of vertices are often painted for soft shading; these are the surface's own.
void find_surface(const visibility::HairSurface& hair, std::span<const Vector3f> positions,
                  std::vector<Receiver>& receivers) {
  for (const visibility::HairSurface::Triangle& triangle : hair.triangles) {
    const Vector3f& a = positions[triangle.vertex[0]];
    const Vector3f normal = (positions[triangle.vertex[1]] - a).cross(positions[triangle.vertex[2]] - a);
    for (const std::uint32_t v : triangle.vertex) {
      Receiver& receiver = receivers[v];
      // Triangles of a card for both sides may be wound either way.
      const float side = hair.double_sided ? std::copysign(1.0f, receiver.normal.dot(normal)) : 1.0f;
      receiver.normal += side * normal;
      receiver.patch = triangle.patch;
    }
  }
  for (Receiver& receiver : receivers) receiver.normal.normalize();
}

Vector3f nearest_of_core(const ColliderRecord& solid, const Vector3f& point) {
  const Eigen::Map<const Vector3f> center(solid.center), axis(solid.axis);
  const float length = axis.squaredNorm();
  return length > 0 ? Vector3f(center + std::clamp((point - center).dot(axis) / length, 0.0f, 1.0f) * axis)
                    : Vector3f(center);
}

/// The head of the colliders is wider than the scalp that hair grows from; points inside would get no light.
Vector3f out_of(std::span<const ColliderRecord> solids, Vector3f point) {
  constexpr int kTries = 4;  // leaving one may enter another
  for (int i = 0; i < kTries; ++i) {
    for (std::size_t c = 0; c < solids.size(); ++c) {
      const Vector3f away = (point - nearest_of_core(solids[c], point)).normalized();
      // Coming from outside towards the core the surface lies behind a point that is inside.
      const float surface = visibility::solid_depth(solids.subspan(c, 1), point, -away);
      if (surface < 0) point -= surface * away;
    }
  }
  return point;
}

/// The light that each receiver gets from one direction.
class LitSide {
 public:
  LitSide(const visibility::HairSurface& hair, std::span<const Vector3f> positions, const visibility::ViewGrid& grid,
          float margin)
      : view_(hair, positions, grid),
        head_(hair.solids, -grid.towards_eye),
        towards_(grid.towards_eye),
        margin_(margin) {}

  [[nodiscard]] float reaching(const Receiver& receiver) const {
    if (head_.depth(receiver.outside) < -margin_) return 0;
    float light = 0;
    for (const auto& [line, share] : view_.lines_around(receiver.point)) light += share * along(line, receiver);
    return light;
  }

 private:
  [[nodiscard]] float along(std::size_t line, const Receiver& receiver) const {
    const float depth = -receiver.point.dot(towards_);
    const Vector3f origin = view_.place(line, 0);
    float passes = 1;
    for (const visibility::Fragment& fragment : view_.line(line)) {
      if (fragment.depth >= depth || passes < kNoLight) break;
      const Vector3f place = origin - fragment.depth * towards_;
      if (!is_own(fragment, place - receiver.point, receiver)) passes *= 1 - fragment.alpha;
    }
    return passes;
  }

  /// The line passes the vertex at some distance. Nearly along a card it meets the card itself before or behind the
  /// vertex.
  [[nodiscard]] bool is_own(const visibility::Fragment& fragment, const Vector3f& offset,
                            const Receiver& receiver) const {
    if (!(std::abs(offset.dot(receiver.normal)) < margin_)) return false;
    return fragment.patch == receiver.patch || offset.norm() < 2 * margin_;
  }

  visibility::FragmentView view_;
  visibility::SolidsAlong head_;
  Vector3f towards_;
  float margin_;
};

struct Direction {
  Vector3f towards_eye;
  float width;  ///< Solid angle of the cell, up to a factor that all share.
};

Direction direction_of(std::uint32_t cell) {
  float d[3];
  view_cell_direction(cell, d);
  const Vector3f towards(d[0], d[1], d[2]);
  // On a face of the cube around the eye's unit ball, at tangents a and b of equal angles.
  const float longest = towards.cwiseAbs().maxCoeff(), square = 1 / (longest * longest);
  float widths = 1;
  for (const float x : {d[0], d[1], d[2]}) widths *= 1 + (std::abs(x) < longest ? x * x * square : 0);
  return {towards, widths / (square * std::sqrt(square))};
}

/// Lines that all triangles are tried against.
double tries_per_view(const visibility::HairSurface& hair, std::span<const Vector3f> positions, float spacing) {
  double sum = 0;
  for (const visibility::HairSurface::Triangle& triangle : hair.triangles) {
    const auto& [a, b, c] = triangle.vertex;
    sum += samples_around(positions[a], positions[b], positions[c], double(spacing));
  }
  return sum;
}

/// Metres between lines: the hair's longest side in kLines, or in as many as may be tried.
float choose_spacing(const visibility::HairSurface& hair, std::span<const Vector3f> positions, float side) {
  const double most = std::max(kMostTries, 4.0 * double(hair.triangles.size()));
  float lines = kLines;
  while (lines > kFewestLines && tries_per_view(hair, positions, side / lines) > most) lines *= 0.8f;
  return std::max(side / lines, 1.0e-6f);
}

struct Gathered {
  std::vector<double> shares;  ///< Share of the light for each vertex, 0..1; -1 for a vertex without triangles.
  bool is_coarse = false;      ///< Fewer lines than wanted were used.
};

/// Where light is gathered for vertices at `places`.
std::vector<Vector3f> lit_places(const Asset& asset, std::vector<Vector3f> places) {
  const bool is_volume = asset.material() != nullptr && asset.material()->shading == ShadingModel::kVolume;
  for (std::size_t v = 0; is_volume && v < places.size(); ++v) {
    const std::int16_t* const n = asset.vertices()[v].normal;
    places[v] += kOwnDepth * Vector3f(n[0], n[1], n[2]).normalized();
  }
  return places;
}

Gathered gather(const visibility::HairSurface& hair, std::span<const Vector3f> positions,
                std::span<const Vector3f> places, const platform::Threads& threads) {
  std::vector<Receiver> receivers;
  Eigen::AlignedBox3f box;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    receivers.push_back({places[v], out_of(hair.solids, places[v]), Vector3f::Zero()});
    box.extend(positions[v]);
  }
  find_surface(hair, positions, receivers);
  const float side = box.sizes().maxCoeff(), spacing = choose_spacing(hair, positions, side);
  const float margin = kMargin * std::max(side, 1.0e-6f * kLines);
  std::vector<std::vector<float>> reaching(kViewCells);
  parallel_for(kViewCells, threads, [&](std::size_t cell) {
    const Vector3f towards = direction_of(std::uint32_t(cell)).towards_eye;
    const LitSide lit(hair, positions, {towards, spacing, spacing}, margin);
    for (const Receiver& receiver : receivers) {
      const bool outside_only = !hair.double_sided && receiver.normal.dot(towards) <= 0;
      reaching[cell].push_back(receiver.patch == kNone || outside_only ? -1 : lit.reaching(receiver));
    }
  });
  Gathered gathered;
  gathered.is_coarse = spacing > 1.01f * side / kLines && side > 0;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    double light = 0, all = 0;
    for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
      const double width = double(direction_of(cell).width);
      if (reaching[cell][i] < 0) continue;
      light += width * double(reaching[cell][i]);
      all += width;
    }
    gathered.shares.push_back(receivers[i].patch == kNone ? -1 : all > 0 ? light / all : 1);
  }
  return gathered;
}

/// Statistics of the values written so far.
struct Written {
  std::vector<bool> is_lit;  ///< Per vertex.
  double sum = 0, least = 1;
  std::size_t count = 0;
};

/// Vertices that a finer level has too keep the finer level's value.
void write_level(const Gathered& gathered, double strength, std::vector<VertexRecord>& vertices, Written& written) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (written.is_lit[i] || gathered.shares[i] < 0) continue;
    written.is_lit[i] = true;
    const double kept = 1 - strength * (1 - gathered.shares[i]);
    vertices[i].normal[3] = std::int16_t(std::lround(std::clamp(kept, 0.0, 1.0) * 32767));
    written.sum += kept;
    written.least = std::min(written.least, kept);
    ++written.count;
  }
}

}  // namespace

void bake_occlusion(const DrawnRecipe& recipe, const platform::Threads& threads, AssetContents& contents,
                    Findings& findings) {
  if (contents.vertices.empty() || recipe.occlusion_strength <= 0) return;
  const lab::OpenedAsset opened(contents);
  const Asset& asset = opened.asset();
  if (!asset.is_open()) return;
  const std::vector<Vector3f> positions = visibility::posed_positions(asset, {});
  const std::vector<Vector3f> places = lit_places(asset, positions);
  Written written{std::vector<bool>(positions.size(), false)};
  bool is_coarse = false;
  for (std::uint32_t lod = 0; lod < asset.lod_count(); ++lod) {
    if (std::ranges::all_of(asset.lod_indices(lod), [&](std::uint32_t v) { return bool(written.is_lit[v]); })) continue;
    const Gathered gathered = gather(visibility::HairSurface(asset, lod), positions, places, threads);
    is_coarse = is_coarse || gathered.is_coarse;
    write_level(gathered, recipe.occlusion_strength, contents.vertices, written);
  }
  if (written.count == 0) return;
  if (is_coarse)
    findings.note("occlusion: by fewer lines than usual, since the triangles are nearly as large as the hair");
  findings.note(
      fmt::format("occlusion: {:.0f} % of the light from everywhere reaches the hair, {:.0f} % its darkest vertex",
                  100 * written.sum / double(written.count), 100 * written.least));
}

}  // namespace coif::cook
