#pragma once

#include "report/cost_report.h"

#include <coif/asset.h>

namespace coif {

/// What each chunk of an open asset costs, in the order of the file.
[[nodiscard]] AssetBytes asset_bytes(const Asset& asset);

}  // namespace coif
