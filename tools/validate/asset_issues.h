#pragma once

#include "validate/issue.h"

#include <coif/asset.h>

#include <vector>

namespace coif {

/// What an asset that opens without error still does badly on screen: no error, but worth an artist's look.
[[nodiscard]] std::vector<Issue> find_asset_issues(const Asset& asset);

/// Why an asset was refused; `status` is that of a failed open().
[[nodiscard]] Issue refusal_issue(const LoadStatus& status);

/// The reader's verdict as a sentence with its evidence.
[[nodiscard]] std::string describe_text(const LoadStatus& status);

}  // namespace coif
