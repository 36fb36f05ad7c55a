// coif: cooks, checks, simulates and draws hair for games.

#include "cli/asset_summary.h"
#include "cli/command.h"
#include "cli/messages.h"
#include "platform/job.h"
#include "platform/program.h"

#include <coif/version.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

namespace coif::cli {
namespace {

/// A result that did not reach its reader (a full disk behind a redirection) is a failure, too. A reader that closed
/// the pipe wants no more, and gets no message.
Exit flush_results(Exit code, const Messages& messages) {
  const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written) return code;
  if (errno != EPIPE) messages.error("standard output: cannot write");
  return code == Exit::kOk ? Exit::kFileAccess : code;
}

/// `error` of --help and --version is no error.
Exit report_usage(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    std::ostringstream text, none;
    (void)program.exit(error, text, none);
    print_result(text.str());
    return flush_results(Exit::kOk, Messages(""));
  }
  const auto verbs = program.get_subcommands();
  const std::string verb = verbs.empty() ? "" : verbs.front()->get_name();
  Messages(verb).error(fmt::format("{}; see 'coif {}{}--help'", error.what(), verb, verb.empty() ? "" : " "));
  return Exit::kUsage;
}

/// The files on the command line that have no option's name: the ones that a command is about.
std::string named_files(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) names.insert(names.end(), option->results().begin(), option->results().end());
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

constexpr const char* kNoStream =
    "-: neither reads the standard input nor writes files to the standard output; name a file, or ./- for one of that "
    "name";

/// Patterns of names may be anything.
bool is_standard_stream_named(const CLI::App& app) {
  return std::ranges::any_of(app.get_options(), [](const CLI::Option* option) {
    return option->get_type_name() != "PATTERN" && std::ranges::find(option->results(), "-") != option->results().end();
  });
}

tl::expected<Exit, ToolError> run_in_memory(const Command& command, const Messages& messages) try {
  return command.run(messages);
} catch (const std::bad_alloc&) {
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, named_files(*command.app) + ": not enough memory for this"});
}

Exit run(const Command& command) {
  const Messages messages(command.app->get_name());
  const auto result = is_standard_stream_named(*command.app) ? tl::expected<Exit, ToolError>(usage(kNoStream))
                                                             : run_in_memory(command, messages);
  if (!result) {
    messages.error(result.error().message);
    return flush_results(exit_code(result.error().kind), messages);
  }
  return flush_results(*result, messages);
}

Exit run_program(int argc, char** argv) {
  platform::fill_standard_streams();
  platform::ignore_signals_of_writing();
  CLI::App program("Hair for games: cooks polygon hair into an asset, checks, simulates and draws it.", "coif");
  program.set_version_flag("--version", "coif " COIF_VERSION);
  program.require_subcommand(0, 1);
  bool wants_manual = false;
  program.add_flag("--man", wants_manual, "Print the manual page: coif --man | man -l -");
  bool wants_licenses = false;
  program.add_flag("--licenses", wants_licenses, "Print whose works are in the program, and their licences");
  std::vector<Command> commands;
  for (const auto add : {add_cook, add_grow, add_look, add_validate, add_info, add_simulate, add_render, add_gallery,
                         add_view_page, add_compare, add_report, add_strip, add_cache}) {
    commands.push_back(add(program));
    CLI::App& app = *commands.back().app;
    app.footer(app.get_footer().empty() ? exit_code_help() : app.get_footer() + "\n" + exit_code_help());
  }
  program.footer(exit_code_help());  // Set now, since commands start with a copy of the program's settings.
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage(program, error);
  }
  if (wants_manual) {
    print_result(manual_page(program));
    return flush_results(Exit::kOk, Messages(""));
  }
  if (wants_licenses) {
    print_result(kThirdPartyNotices);
    return flush_results(Exit::kOk, Messages(""));
  }
  for (const Command& command : commands) {
    if (command.app->parsed()) return run(command);
  }
  std::string verbs = commands.front().app->get_name();
  for (std::size_t i = 1; i < commands.size(); ++i) {
    verbs += (i + 1 < commands.size() ? ", " : " or ") + commands[i].app->get_name();
  }
  Messages("").error(fmt::format("needs a verb: {}; see 'coif --help'", verbs));
  return Exit::kUsage;
}

}  // namespace
}  // namespace coif::cli

int main(int argc, char** argv) try {
  coif::platform::run_named_job(argc, argv);
  return static_cast<int>(coif::cli::run_program(argc, argv));
} catch (const std::exception& error) {
  std::fprintf(stderr, "coif: internal error: %s\n", error.what());
  return static_cast<int>(coif::cli::Exit::kInternal);
}
