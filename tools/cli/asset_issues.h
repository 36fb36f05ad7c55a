#pragma once

#include "cli/issue.h"

#include <coif/asset.h>

#include <vector>

namespace coif {

/// What an asset that opens without error still does badly on screen: no error, but worth an artist's look.
[[nodiscard]] std::vector<Issue> find_asset_issues(const Asset& asset);

}  // namespace coif
