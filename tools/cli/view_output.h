#pragma once

#include "base/tool_error.h"
#include "cli/input_files.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace coif::cli {

inline constexpr const char* kPageSuffix = ".html";  ///< Of files that are opened in a browser.

/// --page VIEW.html: the page of `coif view` without an asset; empty where nobody names one.
CLI::Option* add_page(CLI::App& app, std::string& page);

/// An asset that `coif view` can show, of bytes that are in hand already. Errors: those of AssetFile::open() and
/// check_drawable().
[[nodiscard]] tl::expected<AssetFile, ToolError> open_drawable(const std::string& path, FileBytes bytes);

/// `page`, which was read at `place`, with this asset, by its file's name, and view_page()'s `sheet`. Errors: those of
/// view_page().
[[nodiscard]] tl::expected<std::string, ToolError> filled_page(const std::filesystem::path& place,
                                                               std::string_view page, const AssetFile& file,
                                                               const std::string& path, std::string_view sheet = {});

/// The same of the page that is found as --page says. Errors: those of find_view_page() and FileBytes::read() too.
[[nodiscard]] tl::expected<std::string, ToolError> filled_page(const std::string& page, const AssetFile& file,
                                                               const std::string& path, std::string_view sheet = {});

}  // namespace coif::cli
