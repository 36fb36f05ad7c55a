#pragma once

#include "base/tool_error.h"
#include "cli/messages.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <functional>
#include <span>
#include <string>

namespace coif::cli {

/// The program's exit codes. An interface: build scripts depend on the numbers.
enum class Exit : int {
  kOk = 0,
  kUsage = 1,        ///< The command line is wrong.
  kFileAccess = 2,   ///< A file cannot be opened, read or written.
  kBadInput = 3,     ///< A source, recipe or asset is not usable.
  kOverBudget = 4,   ///< The result exceeds a budget of the command line.
  kUnsupported = 5,  ///< A file format or version, or this machine, cannot do it.
  kInternal = 70,    ///< A bug in this program, or no memory left.
};

[[nodiscard]] Exit exit_code(ToolError::Kind kind);

/// "ok", "bad input": the outcome of one source of many.
[[nodiscard]] std::string status_word(Exit code);

struct ExitMeaning {
  Exit code;
  const char* name;     ///< A word or two.
  const char* meaning;  ///< A sentence.
};

/// Every exit code, ascending.
[[nodiscard]] std::span<const ExitMeaning> exit_meanings();

/// Codes and names, for --help.
[[nodiscard]] std::string exit_code_help();

// The commands of the program. Each add_<verb>() declares its options and the function to run.

struct Command {
  CLI::App* app = nullptr;  ///< Owned by the program.
  /// After parsing. An error is printed and becomes an exit code in main(); a command that has printed its errors
  /// itself returns the code.
  std::function<tl::expected<Exit, ToolError>(const Messages&)> run;
};

Command add_cook(CLI::App& program);
Command add_grow(CLI::App& program);
Command add_validate(CLI::App& program);
Command add_info(CLI::App& program);
Command add_simulate(CLI::App& program);
Command add_render(CLI::App& program);
Command add_look(CLI::App& program);
Command add_gallery(CLI::App& program);
Command add_view_page(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_report(CLI::App& program);
Command add_strip(CLI::App& program);
Command add_cache(CLI::App& program);

}  // namespace coif::cli
