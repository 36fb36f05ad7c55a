#pragma once

#include "cli/messages.h"
#include "tool_error.h"
#include "validate/issue.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <optional>
#include <string>
#include <vector>

namespace coif {

/// What an asset should have been cooked from.
struct OriginOptions {
  std::string source;                 ///< Empty: nothing is compared.
  std::optional<std::string> recipe;  ///< None: the one beside the source, or the defaults.
  bool recook = false;                ///< Compare with the bytes of a new cook, too.
};

/// Whether the asset still is what a cook of the source would give. Errors: those of reading source and recipe; with
/// `recook` those of the cook.
tl::expected<std::vector<Issue>, ToolError> compare_with_origin(const Asset& asset, const OriginOptions& options,
                                                                const Messages& messages);

}  // namespace coif
