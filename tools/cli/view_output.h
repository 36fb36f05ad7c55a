#pragma once

#include "base/tool_error.h"
#include "cli/input_files.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace coif {

inline constexpr const char* kPageSuffix = ".html";  ///< Of files that are opened in a browser.

/// --page VIEW.html: the page of `coif view` without an asset; empty where nobody names one.
CLI::Option* add_page(CLI::App& app, std::string& page);

/// An asset that `coif view` can show, of bytes that are in hand already. Errors: those of AssetFile::open() and check_drawable().
[[nodiscard]] tl::expected<AssetFile, ToolError> open_drawable(const std::string& path, FileBytes bytes);

/// The page of `coif view`, found as --page says, with this asset, by its file's name, and view_page()'s `sheet`. Errors: those of
/// find_view_page(), FileBytes::read() and view_page().
[[nodiscard]] tl::expected<std::string, ToolError> filled_page(const std::string& page, const AssetFile& file,
                                                               const std::string& path, std::string_view sheet = {});

}  // namespace coif
