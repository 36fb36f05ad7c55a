#include "render/kept_stages.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace coif::render {
namespace {

constexpr std::size_t kMostStages = 4;  ///< A sheet that shows the hair in so many ways makes no stage twice.

bool are_equal(const std::vector<SolidVertex>& a, const std::vector<SolidVertex>& b) {
  static_assert(sizeof(SolidVertex) == 8 * sizeof(float));  // Bytes between members could differ.
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(SolidVertex)) == 0);
}

bool are_equal(const SolidMesh& a, const SolidMesh& b) {
  return a.color == b.color && a.texture == b.texture && a.alpha_cutoff == b.alpha_cutoff &&
         a.roughness == b.roughness && a.is_ghost == b.is_ghost && a.triangles == b.triangles &&
         are_equal(a.vertices, b.vertices);
}

bool are_equal(const BodyLook& a, const BodyLook& b) {
  return a.ambient == b.ambient && a.wrap == b.wrap && a.bleed == b.bleed && a.gloss == b.gloss;
}

}  // namespace

const StageRenderer* KeptStages::find(const std::vector<SolidMesh>& meshes, const BodyLook& look) const {
  const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) {
    return !kept.has_shadow && are_equal(kept.look, look) &&
           std::ranges::equal(kept.meshes, meshes,
                              [](const SolidMesh& a, const SolidMesh& b) { return are_equal(a, b); });
  });
  return found != kept_.end() ? &found->stage : nullptr;
}

tl::expected<const StageRenderer*, ToolError> KeptStages::with(std::vector<SolidMesh> meshes, const HairShadow* shadow,
                                                               const BodyLook& look) {
  if (const StageRenderer* const known = shadow == nullptr ? find(meshes, look) : nullptr) return known;
  auto stage = StageRenderer::create(meshes, shadow, look);
  if (!stage) return tl::unexpected(stage.error());
  if (kept_.size() == kMostStages) {
    kept_.front().stage.destroy();
    kept_.pop_front();
  }
  kept_.push_back({std::move(meshes), look, shadow != nullptr, std::move(*stage)});
  return &kept_.back().stage;
}

tl::expected<const OffscreenTarget*, ToolError> KeptTargets::of_size(std::uint32_t width, std::uint32_t height,
                                                                     std::uint32_t samples) {
  const auto known = std::ranges::find_if(
      kept_, [&](const Kept& kept) { return kept.width == width && kept.height == height && kept.samples == samples; });
  if (known != kept_.end()) return &known->target;
  auto target = OffscreenTarget::create(width, height, samples, OffscreenTarget::Pixels::kRadiance);
  if (!target) return tl::unexpected(target.error());
  kept_.push_back({width, height, samples, *target});
  return &kept_.back().target;
}

}  // namespace coif::render
