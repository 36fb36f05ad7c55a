#pragma once

#include "base/tool_error.h"
#include "motion/head_path.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace coif::view {

/// Where the page lies that view_page() fills in, which the build for the web made: `named` unless empty, else beside
/// the program as it is installed, else where this build tree was told that the other is. kUnsupported where there is
/// none.
[[nodiscard]] tl::expected<std::filesystem::path, ToolError> find_view_page(const std::filesystem::path& named);

/// One page that shows this asset, with all that it needs inside; `name` is what the page calls it. `page` as
/// find_view_page() found it. `sheet`: galleries to show instead, as sheet_json() has them; empty: none. kBadInput for
/// a file that is no such page.
[[nodiscard]] tl::expected<std::string, ToolError> view_page(std::string_view page, std::span<const std::byte> asset,
                                                             std::string_view name, std::string_view sheet = {});

/// The page of coif view, not filled in yet or filled in already, which begins with this motion: a built-in one by its
/// name, or a clip called so by its keys. kBadInput for a page without a place for it.
[[nodiscard]] tl::expected<std::string, ToolError> with_motion(std::string_view page, std::string_view name,
                                                               std::span<const motion::ClipKey> keys = {});

}  // namespace coif::view
