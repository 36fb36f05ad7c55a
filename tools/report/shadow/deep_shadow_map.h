#pragma once

#include "report/shadow/measure_shadows.h"
#include "visibility/fragment_view.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::report {

/// A corner of a visibility function, which is linear between two of them.
struct VisibilityVertex {
  float depth = 0;  ///< Metres along the line, away from the light.
  float light = 1;  ///< Share that comes so far, 0..1.
};

/// How much light comes how far along a line: 1 before the first vertex, which has 1, and the last one's behind it. The
/// surface transmittance of thesis section 4.2.1, which for cards is all of it. A fragment takes its light half way to
/// the next one behind it, at most `reach` metres behind itself, so that it does not shade itself. Up to `solid`,
/// behind which there is no hair to shade.
[[nodiscard]] std::vector<VisibilityVertex> visibility_of(std::span<const visibility::Fragment> line, float solid,
                                                          float reach);

/// Fewer vertices whose function is nowhere more than `bound` away, and falls as it did: in one walk along the line,
/// which keeps the slopes that stay within the bound of all vertices since the last one kept (Lokovic and Veach, "Deep
/// shadow maps", SIGGRAPH 2000, section 3.2).
[[nodiscard]] std::vector<VisibilityVertex> compress_visibility(std::span<const VisibilityVertex> exact, float bound);

[[nodiscard]] float light_at(std::span<const VisibilityVertex> visibility, float depth);

/// A deep shadow map of a light that is infinitely far away, on the processor.
class DeepShadowMap {
 public:
  /// Each line of `seen` is a texel, `texel` metres wide. Keeps `seen`, which must outlive this object.
  DeepShadowMap(const visibility::FragmentView& seen, const Eigen::Vector3f& towards_light, float texel, float bound);

  /// By the four texels around the point, each asked at the depth that the point's surface has there.
  [[nodiscard]] float light_at(const ShadowPoint& point) const;

  /// Of vertices and of where each texel's begin.
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
