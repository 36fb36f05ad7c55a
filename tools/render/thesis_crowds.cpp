#include "render/thesis_crowds.h"

#include <algorithm>
#include <set>
#include <utility>

namespace coif {
namespace {

tl::expected<void, ToolError> check(const ThesisCrowdSettings& settings) {
  const auto crowd_ok = [](std::uint32_t heads) { return heads >= 1 && heads <= kMostDrawnHeads; };
  if (settings.heads.empty() || !std::ranges::all_of(settings.heads, crowd_ok) || !(settings.seconds > 0)) {
    return tl::unexpected(ToolError{ToolError::Kind::kUsage, "1 to 10000 heads can be drawn, and drawing takes time"});
  }
  return {};
}

void add_rows(std::uint32_t heads, std::uint32_t crowd, std::vector<ThesisCrowdRow>& rows,
              std::vector<DrawnFrame>& frames) {
  for (const bool simulation : {true, false}) {
    for (const bool transparency : {true, false}) {
      rows.push_back({.heads = heads, .transparency = transparency, .simulation = simulation, .time = {}});
      frames.push_back(
          {.crowd = crowd, .transparency = transparency ? &kBlendMode : &kOpaqueMode, .simulation = simulation});
    }
  }
}

}  // namespace

tl::expected<ThesisCrowds, ToolError> measure_thesis_crowds(const Asset& asset, const ThesisCrowdSettings& settings,
                                                            const MakeCrowd& make_crowd) {
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  auto stage = CrowdStage::create(asset, settings.width, settings.height);
  if (!stage) return tl::unexpected(stage.error());
  ThesisCrowds found{(*stage)->device(), {}, {}};
  std::vector<DrawnFrame> frames;
  AffordableCrowds crowds(**stage, make_crowd, settings.longest_frame);
  const Camera camera = (*stage)->filling_view(*std::ranges::max_element(settings.heads)).camera;
  for (const std::uint32_t heads : std::set(settings.heads.begin(), settings.heads.end())) {
    const auto crowd = crowds.add({camera, (*stage)->filling_view(heads).places});
    if (!crowd) return tl::unexpected(crowd.error());
    if (*crowd) add_rows(heads, **crowd, found.rows, frames);
  }
  found.left_out = crowds.left_out();
  const std::vector<FrameTime> times = time_frames(**stage, frames, settings.seconds);
  for (std::size_t i = 0; i < times.size(); ++i) found.rows[i].time = times[i];
  return found;
}

}  // namespace coif
