#include "cli/exit_code.h"

#include <fmt/format.h>

namespace coif {

namespace {

constexpr ExitMeaning kMeanings[] = {
    {Exit::kOk, "ok", "All is well."},
    {Exit::kUsage, "usage", "The command line is wrong."},
    {Exit::kFileAccess, "file access", "A file cannot be opened, read or written."},
    {Exit::kBadInput, "bad input or asset", "A source, a recipe or an asset is not usable."},
    {Exit::kOverBudget, "over budget", "The result exceeds a budget that was asked for."},
    {Exit::kUnsupported, "unsupported",
     "A file's format or version is none of those known, or this machine lacks something."},
    {Exit::kInternal, "internal error", "A bug in this program, or no memory left."},
};

}  // namespace

std::span<const ExitMeaning> exit_meanings() { return kMeanings; }

std::string exit_code_help() {
  constexpr std::size_t kWidth = 80;
  std::string lines, line = "Exit codes:";
  for (const ExitMeaning& exit : kMeanings) {
    const std::string entry =
        fmt::format(" {} {}{}", static_cast<int>(exit.code), exit.name, exit.code == Exit::kInternal ? "" : ",");
    if (line.size() + entry.size() > kWidth) {
      lines += line + "\n";
      line = std::string(sizeof "Exit codes:" - 1, ' ');
    }
    line += entry;
  }
  return lines + line;
}

Exit exit_code(ToolError::Kind kind) {
  switch (kind) {
    case ToolError::Kind::kUsage: return Exit::kUsage;
    case ToolError::Kind::kFileAccess: return Exit::kFileAccess;
    case ToolError::Kind::kBadInput: return Exit::kBadInput;
    case ToolError::Kind::kOverBudget: return Exit::kOverBudget;
    case ToolError::Kind::kUnsupported: return Exit::kUnsupported;
    case ToolError::Kind::kInternal: return Exit::kInternal;
  }
  return Exit::kInternal;
}

}  // namespace coif
