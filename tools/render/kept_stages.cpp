#include "render/kept_stages.h"

#include <algorithm>
#include <utility>

namespace coif::render {
namespace {

constexpr std::size_t kMostStages = 4;  ///< A sheet that shows the hair in so many ways makes no stage twice.

}  // namespace

const StageRenderer* KeptStages::find(const std::vector<SolidMesh>& meshes, const BodyLook& look) const {
  const auto found = std::ranges::find_if(
      kept_, [&](const Kept& kept) { return !kept.has_shadow && kept.look == look && kept.meshes == meshes; });
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
