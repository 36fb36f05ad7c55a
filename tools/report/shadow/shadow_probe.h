#pragma once

#include "report/shadow/shadow_points.h"
#include "tool_error.h"

#include <coif/shadow.h>

#include <tl/expected.hpp>

#include <span>
#include <vector>

namespace coif {

/// Asks a shadow how much light reaches points, as a host's own shader would: by HairShadow::code(). The context must be
/// current in every call; its objects are freed with it.
class ShadowProbe {
 public:
  /// Error (kUnsupported): the driver refuses the shader. `shadow` must be created and outlive this object.
  static tl::expected<ShadowProbe, ToolError> create(const HairShadow& shadow);

  /// One per point, in steps of 1/65535, of a shadow that is drawn. Points are in the world's axes, from its origin.
  [[nodiscard]] std::vector<float> light_at(std::span<const ShadowPoint> points) const;

 private:
  explicit ShadowProbe(const HairShadow& shadow) : shadow_(&shadow) {}

  const HairShadow* shadow_;
  unsigned program_ = 0;
};

}  // namespace coif
