#include "cook/drop_patches.h"

#include "cook/patch_view.h"

#include <algorithm>
#include <numeric>

namespace coif {
namespace {

constexpr double kBaredAtMost = 0.02;  ///< Of all pixels with hair: what the outline of hair may lose.
constexpr double kAloneAtMost = 0.2;   ///< Of one patch's pixels: a wisp that is seen against the background stays.

}  // namespace

PatchDropper::PatchDropper(const HairMesh& mesh, const PatchSet& patches, const AlphaTest& alpha, double reach,
                           unsigned threads)
    : mesh_(mesh),
      views_(mesh, patches, alpha, threads),
      grid_(mesh.positions, mesh.triangles, patches.patch_of, reach),
      reach_(reach) {
  for (const PatchView& view : view_patches(mesh, patches)) vertices_.push_back(view.vertices);
}

bool PatchDropper::may_go(std::uint32_t patch, std::vector<bool>& drawn) const {
  const std::size_t alone = views_.alone(patch);
  if (double(alone) > kAloneAtMost * double(views_.pixels(patch))) return false;
  if (double(bared_ + alone) > kBaredAtMost * double(views_.covered())) return false;
  drawn[patch] = false;
  const bool near = std::ranges::all_of(
      vertices_[patch], [&](std::uint32_t v) { return grid_.distance(mesh_.positions[v], drawn, reach_) < reach_; });
  drawn[patch] = true;
  return near;
}

std::size_t PatchDropper::drop(std::size_t excess, std::span<const std::size_t> triangles, std::vector<bool>& drawn) {
  const auto seen_per_triangle = [&](std::uint32_t p) {
    return double(views_.seen(p)) / double(std::max<std::size_t>(triangles[p], 1));
  };
  std::vector<std::uint32_t> order(drawn.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, seen_per_triangle);
  std::size_t gone = 0, left = std::size_t(std::ranges::count(drawn, true));
  for (std::uint32_t p : order) {
    if (gone >= excess || left == 1) break;
    if (!drawn[p] || !may_go(p, drawn)) continue;
    bared_ += views_.alone(p);
    views_.drop(p);
    drawn[p] = false;
    gone += triangles[p];
    --left;
  }
  return gone;
}

double PatchDropper::bared() const { return views_.covered() == 0 ? 0 : double(bared_) / double(views_.covered()); }

}  // namespace coif
