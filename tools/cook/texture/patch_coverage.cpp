#include "cook/texture/patch_coverage.h"

#include "base/geometry.h"
#include "base/parallel_for.h"
#include "cook/recipe/drawn_recipe.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::cook {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kPixels = 192;  ///< Pixels of the longer side: about two millimetres of a head of hair each.
constexpr int kFewestPixels = 16;
/// Largest number of pixel tests for the triangles of one view: bounds time and memory where all triangles are as large
/// as the hair. Artists' hair is known to need at most a quarter of it.
constexpr double kMostTries = 4.0e6;

/// Pixels of the longer side.
int choose_pixels(const HairMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const std::uint32_t v : mesh.triangles) box.extend(mesh.positions[v]);
  const double side = box.isEmpty() ? 0.0 : double(box.sizes().maxCoeff());
  const double most = std::max(kMostTries, 4.0 * double(mesh.triangle_count()));
  const auto tries = [&](int pixels) {
    return samples_around(mesh.positions, mesh.triangles, std::max(side / pixels, 1.0e-6));
  };
  int pixels = kPixels;
  while (pixels > kFewestPixels && tries(pixels) > most) pixels = pixels * 4 / 5;
  return pixels;
}

/// The axes and the diagonals of a cube; the opposite side of each sees the same pixels from behind.
const Vector3f kDirection[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

/// Turns the view's direction to Z and fits the hair into the picture. Z stays in metres.
struct Projection {
  Eigen::Matrix3f turn;
  Vector2f low{0, 0};
  float pixels_per_metre = 1;

  Projection(const HairMesh& mesh, const Vector3f& direction, int pixels) {
    turn = turn_between(direction, Vector3f::UnitZ()).toRotationMatrix();
    Eigen::AlignedBox2f box;
    for (std::uint32_t v : mesh.triangles) box.extend(Vector3f(turn * mesh.positions[v]).head<2>());
    low = box.min();
    pixels_per_metre = (float(pixels) - 1) / std::max(box.sizes().maxCoeff(), 1.0e-6f);
  }

  [[nodiscard]] Vector3f operator()(const Vector3f& point) const {
    const Vector3f turned = turn * point;
    const Vector2f pixel = (turned.head<2>() - low) * pixels_per_metre;
    return {pixel.x(), pixel.y(), turned.z()};
  }
};

float cross(const Vector2f& a, const Vector2f& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Calls visit(pixel, weights) for the middle of the triangle and each pixel whose middle it covers; the weights of its
/// corners add up to one. With the triangle's own middle no triangle is too small to be found.
template <typename Visit>
void for_each_pixel(const std::array<Vector3f, 3>& corners, int pixels, const Visit& visit) {
  const Vector2f a = corners[0].head<2>(), b = corners[1].head<2>(), c = corners[2].head<2>();
  const auto index = [pixels](int x, int y) { return std::uint32_t(y * pixels + x); };
  const Vector2f middle = (a + b + c) / 3;
  visit(index(int(middle.x()), int(middle.y())), Vector3f(1.0f / 3, 1.0f / 3, 1.0f / 3));
  const float area = cross(b - a, c - a);
  if (area == 0) return;
  const Vector2f low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  for (int y = int(low.y()); y <= int(high.y()); ++y) {
    for (int x = int(low.x()); x <= int(high.x()); ++x) {
      const Vector2f p(float(x) + 0.5f, float(y) + 0.5f);
      const Vector3f weights(cross(b - p, c - p) / area, cross(c - p, a - p) / area, cross(a - p, b - p) / area);
      if (weights.minCoeff() >= 0) visit(index(x, y), weights);
    }
  }
}

struct Layer {
  float depth = 0;
  std::uint32_t patch = importer::kNoIndex;
};

}  // namespace

AlphaTest alpha_test(const BaseColor& color, const Transparency& transparency, const DrawnRecipe& recipe) {
  AlphaTest test;
  if (color.image && !transparency.ignores_alpha) test.image = &*color.image;
  test.factor = recipe.base_color[3] * double(color.factor[3]);
  test.threshold = std::min(test.threshold, transparency.opaque_threshold);
  return test;
}

bool AlphaTest::passes(const Vector2f& uv) const {
  if (image == nullptr) return true;
  const std::size_t at = repeated(uv.y(), image->height) * image->width + repeated(uv.x(), image->width);
  return image->texels[4 * at + 3] * factor >= threshold * 255;
}

PatchCoverage::View PatchCoverage::draw(const HairStrips& hair, const AlphaTest& alpha, std::size_t direction,
                                        int pixels) {
  const HairMesh& mesh = hair.mesh;
  const Projection project(mesh, kDirection[direction].normalized(), pixels);
  View view;
  const std::size_t all = std::size_t(pixels) * std::size_t(pixels);
  view.layers.assign(all, 0);
  view.cover.resize(hair.patches.count);
  view.seen.assign(hair.patches.count, 0);
  constexpr float kFar = std::numeric_limits<float>::infinity();
  std::vector<Layer> front(all, {-kFar, importer::kNoIndex}), back(all, {kFar, importer::kNoIndex});
  const std::vector<PatchView> patches = hair.views();
  for (std::uint32_t patch = 0; patch < patches.size(); ++patch) {
    std::vector<std::uint32_t>& cover = view.cover[patch];
    for (const std::size_t t : patches[patch].triangles) {
      const std::uint32_t* v = &mesh.triangles[t];
      const std::array corners = {project(mesh.positions[v[0]]), project(mesh.positions[v[1]]),
                                  project(mesh.positions[v[2]])};
      for_each_pixel(corners, pixels, [&](std::uint32_t pixel, const Vector3f& w) {
        const auto uv = [&]() -> Vector2f {
          return w.x() * mesh.uvs[v[0]] + w.y() * mesh.uvs[v[1]] + w.z() * mesh.uvs[v[2]];
        };
        if (!mesh.uvs.empty() && !alpha.passes(uv())) return;
        const float depth = w.x() * corners[0].z() + w.y() * corners[1].z() + w.z() * corners[2].z();
        if (depth > front[pixel].depth) front[pixel] = {depth, patch};
        if (depth < back[pixel].depth) back[pixel] = {depth, patch};
        cover.push_back(pixel);
      });
    }
    std::ranges::sort(cover);
    cover.erase(std::ranges::unique(cover).begin(), cover.end());
    for (std::uint32_t pixel : cover) ++view.layers[pixel];
  }
  for (const std::vector<Layer>& side : {front, back}) {
    for (const Layer& layer : side) {
      if (layer.patch != importer::kNoIndex) ++view.seen[layer.patch];
    }
  }
  return view;
}

PatchCoverage::PatchCoverage(const HairStrips& hair, const AlphaTest& alpha, const platform::Threads& threads)
    : seen_(hair.patches.count, 0) {
  const int pixels = choose_pixels(hair.mesh);
  parallel_for(kDirections, threads, [&](std::size_t d) { views_[d] = draw(hair, alpha, d, pixels); });
  for (const View& view : views_) {
    for (std::uint32_t p = 0; p < seen_.size(); ++p) seen_[p] += view.seen[p];
    covered_ += std::size_t(std::ranges::count_if(view.layers, [](std::uint32_t layers) { return layers > 0; }));
  }
}

std::size_t PatchCoverage::pixels(std::uint32_t patch) const {
  std::size_t count = 0;
  for (const View& view : views_) count += view.cover[patch].size();
  return count;
}

std::size_t PatchCoverage::alone(std::uint32_t patch) const {
  std::size_t count = 0;
  for (const View& view : views_) {
    for (std::uint32_t pixel : view.cover[patch]) count += view.layers[pixel] == 1 ? 1 : 0;
  }
  return count;
}

void PatchCoverage::drop(std::uint32_t patch) {
  for (View& view : views_) {
    for (std::uint32_t pixel : view.cover[patch]) --view.layers[pixel];
    view.cover[patch].clear();
  }
}

}  // namespace coif::cook
