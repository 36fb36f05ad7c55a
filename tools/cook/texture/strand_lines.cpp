#include "cook/texture/strand_lines.h"

#include "base/geometry.h"
#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace coif::cook {
namespace {

using Eigen::Vector2f;

constexpr std::size_t kPlaces = 4096;  ///< Places looked at per patch, about.
constexpr std::size_t kMostPerTriangle = 256;
constexpr int kReach = 2;        ///< Texels to each side, and all between: painted strands are one to ten wide.
constexpr double kSteep = 6;     ///< In steps of 255, per channel: less is noise of the image's compression.
constexpr double kEnough = 0.3;  ///< Share of places that are steep; with fewer the answer counts for less.
constexpr float kEnd = 0.25f;    ///< Share of the patch's range at each end where alpha is looked at.
constexpr float kInside = 0.8f;  ///< Share of a triangle: beyond its edge is another part of the picture.

/// Votes of the places in one patch.
struct Votes {
  double along_v = 0, all = 0, asked = 0;

  [[nodiscard]] double answer() const { return all > 0 ? along_v / all * std::min(1.0, all / asked / kEnough) : 0; }
};

/// Mean colour and alpha at the ends of one patch, 0..1.
struct Ends {
  Eigen::AlignedBox2f range;
  std::array<std::array<Eigen::Vector4d, 2>, 2> sum;  ///< Along U and V, low and high end.
  std::array<std::array<double, 2>, 2> count{};

  Ends() {
    sum = {{{Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()}, {Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()}}};
  }

  void add(const Vector2f& uv, const Eigen::Vector4d& color) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto k = Eigen::Index(axis);
      const float at = (uv[k] - range.min()[k]) / std::max(range.sizes()[k], 1.0e-12f);
      if (at > kEnd && at < 1 - kEnd) continue;
      sum[axis][at > 0.5f ? 1 : 0] += color;
      count[axis][at > 0.5f ? 1 : 0] += 1;
    }
  }
  /// Low end less high end.
  [[nodiscard]] Eigen::Vector4d difference(std::size_t axis) const {
    if (!(count[axis][0] > 0 && count[axis][1] > 0)) return Eigen::Vector4d::Zero();
    return sum[axis][0] / count[axis][0] - sum[axis][1] / count[axis][1];
  }
};

int squared_step(const Image& image, std::size_t from, std::size_t to) {
  int sum = 0;
  for (std::uint32_t c = 0; c < image.channels; ++c) {
    const int step = int(image.texels[image.channels * from + c]) - int(image.texels[image.channels * to + c]);
    sum += step * step;
  }
  return sum;
}

void ask(const Image& image, const Vector2f& uv, Votes& votes) {
  const std::size_t column = repeated(uv.x(), image.width), row = repeated(uv.y(), image.height) * image.width;
  double along_u = 0, along_v = 0;
  for (int step = -kReach; step <= kReach; ++step) {
    const std::size_t other_column = repeated(uv.x() + float(step) / float(image.width), image.width);
    const std::size_t other_row = repeated(uv.y() + float(step) / float(image.height), image.height) * image.width;
    along_u += squared_step(image, row + column, row + other_column);
    along_v += squared_step(image, row + column, other_row + column);
  }
  votes.asked += 1;
  if (along_u + along_v < kSteep * kSteep) return;
  votes.all += 1;
  votes.along_v += (along_u - along_v) / (along_u + along_v);
}

double texels_of(const std::array<Vector2f, 3>& uv, const Image& image) {
  const Vector2f a = uv[1] - uv[0], b = uv[2] - uv[0];
  return 0.5 * std::abs(double(a.x()) * b.y() - double(b.x()) * a.y()) * double(image.texel_count());
}

std::array<Vector2f, 3> uvs_of(const HairMesh& mesh, std::size_t t) {
  return {mesh.uvs[mesh.triangles[t]], mesh.uvs[mesh.triangles[t + 1]], mesh.uvs[mesh.triangles[t + 2]]};
}

/// Calls `visit` with texture coordinates spread over the patch, about kPlaces of them, as dense as it has texels.
template <typename Visit>
void for_each_place(const HairMesh& mesh, const PatchView& patch, const Image& image, const Visit& visit) {
  double total = 0;
  for (const std::size_t t : patch.triangles) total += texels_of(uvs_of(mesh, t), image);
  if (!(total > 0) || !std::isfinite(total)) return;
  std::size_t n = 0;
  for (const std::size_t t : patch.triangles) {
    const auto uv = uvs_of(mesh, t);
    const Vector2f middle = (uv[0] + uv[1] + uv[2]) / 3;
    const double share = texels_of(uv, image) / total;
    const auto count = std::min(kMostPerTriangle, std::size_t(std::ceil(share * double(kPlaces))));
    for (std::size_t i = 0; i < count; ++i) {
      const Vector2f at = spread_in_triangle(++n).cast<float>();
      const Vector2f place = uv[0] + at.x() * (uv[1] - uv[0]) + at.y() * (uv[2] - uv[0]);
      visit(Vector2f(middle + kInside * (place - middle)));
    }
  }
}

float lines_of(const HairMesh& mesh, const PatchView& patch, const BaseColor& color) {
  double sum = 0;
  for (const std::optional<Image>* image : {&color.image, &color.normals}) {
    if (!*image) continue;
    Votes votes;
    for_each_place(mesh, patch, **image, [&](const Vector2f& uv) { ask(**image, uv, votes); });
    sum += votes.answer();
  }
  return float(std::clamp(sum, -1.0, 1.0));
}

void compare_ends(const HairMesh& mesh, const PatchView& patch, const Image& image, bool has_alpha, SeenStrands& seen) {
  Ends ends;
  for (const std::uint32_t v : patch.vertices) ends.range.extend(mesh.uvs[v]);
  for_each_place(mesh, patch, image, [&](const Vector2f& uv) {
    const std::size_t texel = repeated(uv.y(), image.height) * image.width + repeated(uv.x(), image.width);
    const std::uint8_t* c = &image.texels[4 * texel];
    const double alpha = has_alpha ? c[3] / 255.0 : 1;
    ends.add(uv, {alpha * c[0] / 255.0, alpha * c[1] / 255.0, alpha * c[2] / 255.0, alpha});
  });
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Eigen::Vector4d difference = ends.difference(axis);
    seen.fade[axis] = float(difference.w());
    seen.differ[axis] = float(difference.cwiseAbs().maxCoeff());
  }
}

}  // namespace

std::vector<SeenStrands> find_strand_lines(const HairStrips& hair, const BaseColor& color,
                                           const platform::Threads& threads) {
  if (hair.mesh.uvs.empty() || !(color.image || color.normals)) return {};
  const std::vector<PatchView> views = hair.views();
  std::vector<SeenStrands> seen(views.size());
  parallel_for(views.size(), threads, [&](std::size_t p) {
    seen[p].lines = lines_of(hair.mesh, views[p], color);
    if (color.image)
      compare_ends(hair.mesh, views[p], *color.image, color.alpha_use != importer::AlphaUse::kOpaque, seen[p]);
  });
  return seen;
}

void read_root_to_tip(const HairStrips& hair, const Image& map, std::vector<std::string>& roots) {
  constexpr double kClearGrowth = 0.1;  // of the way, between the quarters at both ends
  if (hair.mesh.uvs.empty()) return;
  constexpr const char* kEnds[2][2] = {{"low_u", "high_u"}, {"low_v", "high_v"}};
  const std::vector<PatchView> views = hair.views();
  for (std::size_t p = 0; p < views.size(); ++p) {
    if (roots[p] != "auto") continue;
    Ends ends;
    for (const std::uint32_t v : views[p].vertices) ends.range.extend(hair.mesh.uvs[v]);
    for_each_place(hair.mesh, views[p], map, [&](const Vector2f& uv) {
      const std::uint8_t number = map.texels[repeated(uv.y(), map.height) * map.width + repeated(uv.x(), map.width)];
      ends.add(uv, Eigen::Vector4d::Constant(number / 255.0));
    });
    const double along[2] = {ends.difference(0).x(), ends.difference(1).x()};
    const int axis = std::abs(along[1]) >= std::abs(along[0]) ? 1 : 0;
    if (std::abs(along[axis]) >= kClearGrowth) roots[p] = kEnds[axis][along[axis] > 0 ? 1 : 0];
  }
}

}  // namespace coif::cook
