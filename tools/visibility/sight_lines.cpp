#include "visibility/sight_lines.h"

namespace coif {
namespace {

constexpr float kUnseen = 1.0f / 1024;
constexpr float kSolid = 0.999f;

}  // namespace

SightLines::SightLines(const FragmentView& view, float solid_alpha) {
  for (std::size_t i = 0; i < view.line_count(); ++i) {
    const float end = view.solid_depth(i);
    const auto fragments = view.line(i);
    if (fragments.empty() || fragments.front().depth > end) continue;
    ++covered;
    if (fragments.front().alpha >= kSolid) continue;
    float passes = 1;
    for (const Fragment& fragment : fragments) {
      if (fragment.depth > end || passes < kUnseen) break;
      layers.push_back({fragment.alpha, fragment.triangle & 0x7FFFFFFFu, fragment.is_front ? 1u : 0u});
      if (fragment.alpha >= solid_alpha) break;
      passes *= 1 - fragment.alpha;
    }
    begin.push_back(std::uint32_t(layers.size()));
  }
}

}  // namespace coif
