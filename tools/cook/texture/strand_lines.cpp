#include "cook/texture/strand_lines.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
namespace {

using Eigen::Vector2f;

constexpr std::size_t kPlaces = 4096;     ///< Places looked at per patch, about.
constexpr std::size_t kMostPerTriangle = 256;
constexpr int kReach = 2;                  ///< Texels to each side, and all between: painted strands are one to ten wide.
constexpr double kSteep = 6;               ///< Of 255, per channel: less is noise of the image's compression.
constexpr double kEnough = 0.3;            ///< Share of places that are steep; with fewer the answer counts for less.
constexpr float kInside = 0.8f;            ///< Of a triangle: what lies beyond its edge is another part of the picture.

/// Votes of the places in one patch.
struct Votes {
  double along_v = 0, all = 0, asked = 0;

  [[nodiscard]] double answer() const {
    return all > 0 ? along_v / all * std::min(1.0, all / asked / kEnough) : 0;
  }
};

double squared_step(const Image& image, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::uint32_t c = 0; c < image.channels; ++c) {
    const double step = double(image.texels[image.channels * from + c]) - image.texels[image.channels * to + c];
    sum += step * step;
  }
  return sum;
}

void ask(const Image& image, const Vector2f& uv, Votes& votes) {
  const auto at = [&](int dx, int dy) {
    const std::size_t x = repeated(uv.x() + float(dx) / float(image.width), image.width);
    const std::size_t y = repeated(uv.y() + float(dy) / float(image.height), image.height);
    return y * image.width + x;
  };
  double along_u = 0, along_v = 0;
  for (int step = -kReach; step <= kReach; ++step) {
    along_u += squared_step(image, at(0, 0), at(step, 0));
    along_v += squared_step(image, at(0, 0), at(0, step));
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

Votes votes_of(const HairMesh& mesh, const PatchView& patch, const Image& image) {
  double total = 0;
  for (const std::size_t t : patch.triangles) total += texels_of(uvs_of(mesh, t), image);
  Votes votes;
  if (!(total > 0) || !std::isfinite(total)) return votes;
  std::size_t n = 0;
  for (const std::size_t t : patch.triangles) {
    const auto uv = uvs_of(mesh, t);
    const Vector2f middle = (uv[0] + uv[1] + uv[2]) / 3;
    const double share = texels_of(uv, image) / total;
    const auto count = std::min(kMostPerTriangle, std::size_t(std::ceil(share * double(kPlaces))));
    for (std::size_t i = 0; i < count; ++i) {
      // Roberts 2018, as in head_room.cpp.
      ++n;
      float u = float(std::fmod(double(n) * 0.7548776662466927, 1.0)), v = float(std::fmod(double(n) * 0.5698402909980532, 1.0));
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vector2f place = uv[0] + u * (uv[1] - uv[0]) + v * (uv[2] - uv[0]);
      ask(image, middle + kInside * (place - middle), votes);
    }
  }
  return votes;
}

}  // namespace

std::vector<float> find_strand_lines(const HairStrips& hair, const BaseColor& color, unsigned threads) {
  const std::vector<PatchView> views = hair.views();
  std::vector<float> lines(views.size(), 0.0f);
  if (hair.mesh.uvs.empty()) return lines;
  parallel_for(views.size(), threads, [&](std::size_t p) {
    double sum = 0;
    for (const std::optional<Image>* image : {&color.image, &color.normals}) {
      if (*image) sum += votes_of(hair.mesh, views[p], **image).answer();
    }
    lines[p] = float(std::clamp(sum, -1.0, 1.0));
  });
  return lines;
}

}  // namespace coif
