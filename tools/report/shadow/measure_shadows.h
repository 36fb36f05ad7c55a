#pragma once

#include "base/tool_error.h"
#include "report/shadow/shadow_report.h"
#include "visibility/fragment_view.h"

#include <coif/asset.h>
#include <coif/shadow.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::report {

/// A point and how much of a light reaches it, exactly.
struct ShadowPoint {
  Eigen::Vector3f place;   ///< Head space, metres.
  Eigen::Vector3f normal;  ///< Normal of the surface, any length; 0: as if it faced the light.
  float transmittance = 1;
  float weight = 1;  ///< For hair: its alpha, which is how visible it is.
  bool is_head = false;
};

/// The points where lines from the light meet hair, up to the head, and where they meet the head. The occlusion of a
/// point on its own line is known exactly, so no point needs a margin to its own card. `seen`: from the light, `hair`
/// with its vertices at `positions`.
[[nodiscard]] std::vector<ShadowPoint> shadow_points(const visibility::FragmentView& seen,
                                                     const visibility::HairSurface& hair,
                                                     std::span<const Eigen::Vector3f> positions);

/// How far the exact reference agrees with itself: the light at a point against that on the same surface a little
/// aside. No map with wider texels can be nearer to the reference than these two are to each other.
class TruthAgreement {
 public:
  /// `aside`: as `seen`, its lines moved (ViewGrid::aside).
  void add(const visibility::FragmentView& seen, const visibility::FragmentView& aside,
           const visibility::HairSurface& hair, std::span<const Eigen::Vector3f> positions);

  [[nodiscard]] double rmse() const { return met_ > 0 ? std::sqrt(squares_ / met_) : 0; }
  /// Share of the hair whose surface extends so far aside, 0..1; the rest is not compared.
  [[nodiscard]] double compared() const { return points_ > 0 ? met_ / points_ : 0; }

 private:
  double points_ = 0, met_ = 0, squares_ = 0;
};

/// Asks a shadow how much light reaches points, like a host's own shader: by HairShadow::code(). The context must be
/// current in every call; it frees the objects.
class ShadowProbe {
 public:
  /// Error (kUnsupported): the driver refuses the shader. `shadow` must be created and outlive this object.
  static tl::expected<ShadowProbe, ToolError> create(const HairShadow& shadow);

  /// One value per point, in steps of 1/65535, for a shadow that is drawn. Points are in the world's axes, from its
  /// origin.
  [[nodiscard]] std::vector<float> light_at(std::span<const ShadowPoint> points) const;

 private:
  explicit ShadowProbe(const HairShadow& shadow) : shadow_(&shadow) {}

  const HairShadow* shadow_;
  unsigned program_ = 0;
};

/// `light`: one value per point, from a technique. Over the points of the head, or of the hair.
[[nodiscard]] ShadowError shadow_error(std::span<const ShadowPoint> points, std::span<const float> light, bool of_head);

/// Each technique over its rows, with equal weights: the root of the mean squared error, the mean bias. Bytes are 0.
[[nodiscard]] std::vector<ShadowTotal> shadow_totals(std::span<const ShadowRow> rows);

struct ShadowSettings {
  std::vector<std::uint32_t> sizes{256, 512, 1024};  ///< Sizes of the maps, 16..4096, not empty.
  double spacing = 0.002;                            ///< Metres between lines of the reference, 0.0005..0.02.
};

/// Draws the map of each technique under some lights and in some poses, evaluates it at points of hair and head, and
/// compares with the exact light. Errors: kUsage for settings out of range, kBadInput for an asset without a mesh,
/// kUnsupported where nothing can be drawn.
tl::expected<ShadowReport, ToolError> measure_shadows(const Asset& asset, const ShadowSettings& settings,
                                                      const ReportProgress& progress);

}  // namespace coif::report
