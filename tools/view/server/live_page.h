#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace coif::view {

/// The page of view_page() as the server sends it: it asks for its asset, and a browser runs no script in it but those
/// that carry `nonce`. kBadInput for a file that is no such page.
[[nodiscard]] tl::expected<std::string, ToolError> live_page(std::string_view page, std::string_view nonce);

/// Content-Security-Policy of that page: nothing from elsewhere, and nothing that was put into it later.
[[nodiscard]] std::string live_policy(std::string_view nonce);

}  // namespace coif::view
