#include "cli/asset_summary.h"

#include "cli/command.h"

#include <coif/version.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

namespace coif::cli {
namespace {

constexpr const char* kDescription = R"(.SH DESCRIPTION
.B coif
turns a model of a head with polygon hair, as an artist has made it, into an asset that a game loads as it is: patches in
drawing order, bone chains with their dynamics, colliders, levels of detail, textures and material. What the model does not
say, a recipe does:
.B "coif cook \-\-print\-recipe"
prints all its keys with their defaults. The other commands check, measure, simulate and draw what was cooked.
.PP
Results go to standard output, as text or as JSON; messages go to standard error and say what is wrong, where, and what to
do about it. A file is written whole or not at all. The same source, recipe and version give the same bytes.
)";

constexpr const char* kBackground = R"(.SH ENVIRONMENT
.TP
.B TERM
Progress is shown on a terminal, unless it is
.BR dumb .
.SH FILES
.TP
.I NAME.recipe.json
Beside the source
.IR NAME.glb ,
.I NAME.fbx
and so on: the recipe that
.B cook
takes when none is named. JSON, with comments.
.TP
.I NAME.coif
A cooked asset.
.SH EXAMPLES
.TP
.B coif cook bob.glb \-o bob.coif
Cooks a model.
.TP
.B coif cook \-\-list bob.glb
Names the meshes, materials and nodes that a recipe can speak of.
.TP
.B coif cook hair/*.fbx \-o cooked/ \-\-cache cache/
Cooks many at once, and again only what has changed.
.TP
.B coif validate bob.coif \-\-source bob.glb
Checks an asset, and that it is still the source's.
.TP
.B coif render bob.coif \-o bob.png \-\-view 30,5
Draws it.
.TP
.B coif report bob.coif cost \-o cost.html
Measures what it costs on this machine.
)";

/// Escapes everything that roff would read as commands, special characters or breakable hyphens.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\e"; break;
      case '-': result += "\\-"; break;
      case '\'': result += "\\(aq"; break;
      case '`': result += "\\(ga"; break;
      case '^': result += "\\(ha"; break;
      case '~': result += "\\(ti"; break;
      default: result += c;
    }
  }
  return result.starts_with('.') ? "\\&" + result : result;
}

/// A definition: a bold term on a line of its own, with its meaning beneath.
std::string term(std::string_view name, std::string_view meaning) {
  return fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(name), escaped(meaning));
}

/// Text of the help: its lines are sentences; indented lines are a table of words with their meanings.
std::string prose(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  bool in_table = false;
  const char* end = "";  // of the sentence before
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) {
      end = result.empty() ? "" : ".sp\n";
      continue;
    }
    if ((begin > 0) != in_table) result += in_table ? ".RE\n.IP\n" : ".RS\n";
    in_table = begin > 0;
    if (!in_table) {
      result += end + escaped(line) + "\n";
      end = ".br\n";
      continue;
    }
    const std::size_t name_end = std::min(line.find(' ', begin), line.size());
    const std::size_t meaning = std::min(line.find_first_not_of(' ', name_end), line.size());
    result += term(line.substr(begin, name_end - begin), line.substr(meaning));
  }
  return in_table ? result + ".RE\n" : result;
}

std::string options(const CLI::App& app, bool positional) {
  const CLI::Formatter help;
  std::string result;
  const auto shown = [positional](const CLI::Option* option) {
    return !option->get_group().empty() && option->get_positional() == positional;
  };
  for (const CLI::Option* option : app.get_options(shown)) {
    result += fmt::format(".TP\n\\fB{}\\fR{}\n{}", escaped(help.make_option_name(option, positional)),
                          escaped(help.make_option_opts(option)), prose(help.make_option_desc(option)));
  }
  return result;
}

/// The command's purpose and the footer of its help, without the exit codes, which have a section of their own.
std::string text_of(const CLI::App& command) {
  const std::string footer = command.get_footer(), codes = exit_code_help();
  if (footer == codes || !footer.ends_with(codes)) return command.get_description();
  return command.get_description() + "\n\n" + footer.substr(0, footer.size() - codes.size());
}

/// "coif cook [OPTIONS] [SOURCE...]"
std::string usage_line(const CLI::App& command) {
  constexpr std::string_view kLabel = "Usage: ";
  const std::string line = CLI::Formatter().make_usage(&command, "coif " + command.get_name());
  return line.substr(kLabel.size(), line.find('\n') - kLabel.size());
}

}  // namespace

std::string manual_page(const CLI::App& program) {
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  std::string page = fmt::format(".TH COIF 1 \"\" \"coif {}\" \"User Commands\"\n.SH NAME\ncoif \\- {}\n.SH SYNOPSIS\n",
                                 COIF_VERSION, escaped(program.get_description()));
  for (const CLI::App* command : commands) page += fmt::format("\\fB{}\\fR\n.br\n", escaped(usage_line(*command)));
  page += kDescription;
  page += ".SH OPTIONS\n" + options(program, false);
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : commands) {
    page += fmt::format(".SS {}\n{}", escaped(usage_line(*command)), prose(text_of(*command)));
    page += options(*command, true) + options(*command, false);
  }
  page += ".SH EXIT STATUS\n";
  for (const ExitMeaning& exit : exit_meanings()) {
    page += term(std::to_string(static_cast<int>(exit.code)), exit.meaning);
  }
  return page + kBackground;
}

}  // namespace coif::cli
