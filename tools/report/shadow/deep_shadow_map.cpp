#include "report/shadow/deep_shadow_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::report {
namespace {

constexpr float kStep = 1e-6f;      // metres within which a fragment takes its light: no slope is infinite
constexpr float kReachTexels = 2;   // behind the last fragment, as the map that the device makes
constexpr float kSteepest = 8;      // metres of depth to one aside, as in shaders/hair_shadow.glsl
constexpr float kSolidBias = 0.5f;  // Texels, for hair; for the head, whose slope is not known, the steepest one.
constexpr float kFar = std::numeric_limits<float>::infinity();

/// Slopes within the bound of all vertices since the last one that was kept.
struct SlopeWindow {
  float least = -kFar, most = kFar;

  [[nodiscard]] SlopeWindow narrowed(const VisibilityVertex& from, const VisibilityVertex& to, float bound) const {
    const float run = std::max(to.depth - from.depth, kStep / 4);
    return {std::max(least, (to.light - bound - from.light) / run),
            std::min(most, (to.light + bound - from.light) / run)};
  }
  [[nodiscard]] bool is_empty() const { return least > most; }
  /// Light never grows on its way. Such a slope exists: the last vertex kept is at most `bound` too dark.
  [[nodiscard]] float middle() const { return std::min(0.5f * (least + most), 0.0f); }
};

}  // namespace

std::vector<VisibilityVertex> visibility_of(std::span<const visibility::Fragment> line, float solid, float reach) {
  std::vector<VisibilityVertex> vertices;
  float light = 1, last = -kFar;
  for (std::size_t i = 0; i < line.size() && line[i].depth <= solid; ++i) {
    const float depth = line[i].depth, next = i + 1 < line.size() ? line[i + 1].depth : kFar;
    const float at = std::max(depth + std::min(0.5f * (next - depth), reach), last + kStep);
    vertices.push_back({at, light});
    light *= 1 - line[i].alpha;
    vertices.push_back({at + kStep, light});
    last = at + kStep;
  }
  return vertices;
}

std::vector<VisibilityVertex> compress_visibility(std::span<const VisibilityVertex> exact, float bound) {
  if (exact.empty()) return {};
  std::vector<VisibilityVertex> kept{exact.front()};
  SlopeWindow window;
  for (std::size_t i = 1; i < exact.size(); ++i) {
    SlopeWindow narrower = window.narrowed(kept.back(), exact[i], bound);
    if (narrower.is_empty()) {
      const VisibilityVertex& end = exact[i - 1];
      kept.push_back({end.depth, kept.back().light + window.middle() * (end.depth - kept.back().depth)});
      narrower = SlopeWindow{}.narrowed(kept.back(), exact[i], bound);
    }
    window = narrower;
  }
  if (exact.size() > 1) {
    const float depth = exact.back().depth;
    kept.push_back({depth, kept.back().light + window.middle() * (depth - kept.back().depth)});
  }
  return kept;
}

float light_at(std::span<const VisibilityVertex> visibility, float depth) {
  const auto behind = std::ranges::upper_bound(visibility, depth, {}, &VisibilityVertex::depth);
  if (behind == visibility.begin()) return 1;
  const VisibilityVertex& before = *(behind - 1);
  if (behind == visibility.end()) return before.light;
  const float share = (depth - before.depth) / (behind->depth - before.depth);
  return before.light + share * (behind->light - before.light);
}

DeepShadowMap::DeepShadowMap(const visibility::FragmentView& seen, const Eigen::Vector3f& towards_light, float texel,
                             float bound)
    : seen_(seen), towards_light_(towards_light), texel_(texel) {
  for (std::size_t line = 0; line < seen.line_count(); ++line) {
    const auto exact = visibility_of(seen.line(line), seen.solid_depth(line), kReachTexels * texel);
    const auto kept = compress_visibility(exact, bound);
    vertices_.insert(vertices_.end(), kept.begin(), kept.end());
    begin_.push_back(std::uint32_t(vertices_.size()));
  }
}

float DeepShadowMap::light_at(const ShadowPoint& point) const {
  const float depth = -point.place.dot(towards_light_), facing = point.normal.dot(towards_light_);
  const float bias = (point.is_head ? kSteepest : kSolidBias) * texel_;
  float light = 0;
  for (const auto& [line, share] : seen_.lines_around(point.place)) {
    const Eigen::Vector3f aside = seen_.place(line, depth) - point.place;
    const float run = aside.norm();
    const float rise = facing != 0 ? point.normal.dot(aside) / facing : 0;
    const float there = depth + std::clamp(rise, -kSteepest * run, kSteepest * run);
    if (there - bias > seen_.solid_depth(line)) continue;
    light += share * coif::report::light_at(texel(line), there);
  }
  return light;
}

}  // namespace coif::report
