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

/// Finds the page that view_page() fills in, which the build for the web made: `named` unless empty, else the one
/// beside the installed program, else the one of the other build tree that was configured here. kUnsupported where
/// there is none.
[[nodiscard]] tl::expected<std::filesystem::path, ToolError> find_view_page(const std::filesystem::path& named);

/// A self-contained page that shows this asset; `name` is the asset's name on the page. `page` is from
/// find_view_page(). `sheet`: galleries to show instead, from sheet_json(); empty: none. kBadInput for a file that is
/// no such page.
[[nodiscard]] tl::expected<std::string, ToolError> view_page(std::string_view page, std::span<const std::byte> asset,
                                                             std::string_view name, std::string_view sheet = {});

/// The page of coif view, not filled in yet or filled in already, which begins with this motion: a built-in one by its
/// name, or a clip called so by its keys. kBadInput for a page without a place for it.
[[nodiscard]] tl::expected<std::string, ToolError> with_motion(std::string_view page, std::string_view name,
                                                               std::span<const motion::ClipKey> keys = {});

/// The page of coif view, as for with_motion(), with this body beneath the hair: body_json(). kBadInput for a page
/// without a place for it.
[[nodiscard]] tl::expected<std::string, ToolError> with_body(std::string_view page, std::string_view body);

}  // namespace coif::view
