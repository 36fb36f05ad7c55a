#pragma once
// The verbs of the program. Each add_<verb>() declares its options on the program and says what to run.

#include "cli/exit_code.h"
#include "cli/messages.h"
#include "tool_error.h"

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <functional>

namespace coif {

struct Command {
  CLI::App* app = nullptr;  ///< Owned by the program.
  /// After parsing. An error is printed and becomes an exit code in main(); a command that has printed its errors
  /// itself returns the code.
  std::function<tl::expected<Exit, ToolError>(const Messages&)> run;
};

Command add_cook(CLI::App& program);
Command add_validate(CLI::App& program);
Command add_info(CLI::App& program);
Command add_simulate(CLI::App& program);
Command add_render(CLI::App& program);
Command add_gallery(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_report(CLI::App& program);
Command add_strip(CLI::App& program);

}  // namespace coif
