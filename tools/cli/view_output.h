#pragma once

#include "base/tool_error.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif::cli {

inline constexpr const char* kPageSuffix = ".html";  ///< Suffix of files that are opened in a browser.

/// --page VIEW.html: the page of `coif view` without an asset; empty where nobody names one.
CLI::Option* add_page(CLI::App& app, std::string& page);

/// Opens an asset that `coif view` can show, from bytes in memory. Errors: those of AssetFile::open() and
/// check_drawable().
[[nodiscard]] tl::expected<AssetFile, ToolError> open_drawable(const std::string& path, FileBytes bytes);

/// `page`, which was read at `place`, with this asset under its file's name, and view_page()'s `sheet`. Errors: those
/// of view_page().
[[nodiscard]] tl::expected<std::string, ToolError> filled_page(const std::filesystem::path& place,
                                                               std::string_view page, const AssetFile& file,
                                                               const std::string& path, std::string_view sheet = {});

/// The same with the page that --page chooses. Errors also: those of find_view_page() and FileBytes::read().
[[nodiscard]] tl::expected<std::string, ToolError> filled_page(const std::string& page, const AssetFile& file,
                                                               const std::string& path, std::string_view sheet = {});

/// Reads the page of `coif view` at `place` and lets it begin with this motion, if there is one. Errors: those of a
/// clip, of a file that cannot be read, and of a page without a place for motions.
[[nodiscard]] tl::expected<std::string, ToolError> moved_page(const std::filesystem::path& place,
                                                              const std::optional<HeadMotion>& motion,
                                                              const Messages& messages);

/// --body of `coif view`: a model under the hair.
struct PageBodyOptions {
  std::string file;  ///< Empty: none.
  std::string mesh;  ///< BodyOptions::mesh.
  std::vector<std::filesystem::path> roots;
  SourceLimits limits;
};

/// `page`, which was read at `place`, with that body; unchanged where there is none. `asset`: the hair's, whose head
/// bone the body turns with; null: not known yet, the body's own head is taken. Files that were read are added to
/// `files`. Errors: those of read_body(), and of a page without a place for bodies.
[[nodiscard]] tl::expected<std::string, ToolError> bodied_page(const std::filesystem::path& place, std::string page,
                                                               const PageBodyOptions& body, const Asset* asset,
                                                               const Messages& messages,
                                                               std::vector<std::filesystem::path>& files);

/// The command line of `coif view` of a source or a recipe.
struct LiveOptions {
  std::string file;  ///< A source, or a recipe with its source beside it.
  std::optional<std::string> recipe;
  std::vector<std::filesystem::path> roots;
  std::filesystem::path page;        ///< As find_view_page() found it.
  std::optional<HeadMotion> motion;  ///< The page begins with it.
  PageBodyOptions body;
  SourceLimits limits;
  bool draft = true;
  std::uint16_t port = 0;
  OutputFormat format = OutputFormat::kText;
};

/// Serves the page until the program is ended (SIGINT, SIGTERM, SIGHUP). Prints the address; the outcomes of cooks go
/// to `messages`.
tl::expected<Exit, ToolError> view_live(LiveOptions options, const Messages& messages);

}  // namespace coif::cli
