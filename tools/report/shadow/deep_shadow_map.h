#pragma once

#include "report/shadow/measure_shadows.h"
#include "visibility/fragment_view.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::report {

/// A corner of a visibility function, which is linear between corners.
struct VisibilityVertex {
  float depth = 0;  ///< Metres along the line, away from the light.
  float light = 1;  ///< Share of the light that reaches this depth, 0..1.
};

/// How much light gets how far along a line: 1 before the first vertex, which has 1, and the last one's behind it. It
/// is the surface transmittance of thesis section 4.2.1, which for cards is the only one. A fragment takes its light
/// half way to the next one behind it, at most `reach` metres behind itself, so that it does not shade itself. Ends at
/// `solid`, behind which there is no hair to shade.
[[nodiscard]] std::vector<VisibilityVertex> visibility_of(std::span<const visibility::Fragment> line, float solid,
                                                          float reach);

/// Fewer vertices, whose function differs by at most `bound` and never rises: one walk along the line keeps the slopes
/// within the bound of all vertices since the last one kept (Lokovic and Veach, "Deep shadow maps", SIGGRAPH 2000,
/// section 3.2).
[[nodiscard]] std::vector<VisibilityVertex> compress_visibility(std::span<const VisibilityVertex> exact, float bound);

[[nodiscard]] float light_at(std::span<const VisibilityVertex> visibility, float depth);

/// A deep shadow map of a light that is infinitely far away, on the processor.
class DeepShadowMap {
 public:
  /// Each line of `seen` is a texel, `texel` metres wide. Keeps a reference to `seen`, which must outlive this object.
  DeepShadowMap(const visibility::FragmentView& seen, const Eigen::Vector3f& towards_light, float texel, float bound);

  /// From the four texels around the point, each evaluated at the depth of the point's surface there.
  [[nodiscard]] float light_at(const ShadowPoint& point) const;

  /// Bytes of the vertices and of each texel's beginning.
  [[nodiscard]] std::uint64_t bytes() const {
    return vertices_.size() * sizeof(VisibilityVertex) + begin_.size() * sizeof(std::uint32_t);
  }

 private:
  [[nodiscard]] std::span<const VisibilityVertex> texel(std::size_t line) const {
    return std::span(vertices_).subspan(begin_[line], begin_[line + 1] - begin_[line]);
  }

  const visibility::FragmentView& seen_;
  Eigen::Vector3f towards_light_;
  float texel_;
  std::vector<std::uint32_t> begin_ = {0};
  std::vector<VisibilityVertex> vertices_;
};

}  // namespace coif::report
