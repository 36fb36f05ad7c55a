#pragma once

#include "cook/alpha_coverage.h"

#include <coif/asset.h>

namespace coif {

/// The material's thresholds, which are of the product of texel and factor, as alphas of texels.
[[nodiscard]] AlphaThresholds thresholds_in_texture(const MaterialRecord& material);

/// What each mip of an asset's base colour covers of the finest level of detail, largest mip first; empty without that
/// texture or a material.
[[nodiscard]] std::vector<AlphaCoverage> mip_coverage(const Asset& asset);

}  // namespace coif
