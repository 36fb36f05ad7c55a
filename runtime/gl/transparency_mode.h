#pragma once

#include "gl/alpha_range.h"
#include "gl/passes.h"

#include <coif/asset_records.h>
#include <coif/transparency.h>

namespace coif {

struct TransparencyMode {
  const char* name;
  /// The passes that draw something of an asset whose texture's alpha lies in this range.
  PassList (*plan_passes)(const MaterialRecord& material, const AlphaRange& texture);
};

}  // namespace coif
