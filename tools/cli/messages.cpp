#include "cli/messages.h"

#include "base/text.h"
#include "cli/command.h"
#include "platform/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace coif::cli {

Messages::Messages(std::string_view verb) : program_(verb.empty() ? "coif" : fmt::format("coif {}", verb)) {}

void Messages::error(std::string_view text) const { write("error", text); }
void Messages::warning(std::string_view text) const { write("warning", text); }
void Messages::note(std::string_view text) const {
  if (tells_notes_) write("note", text);
}

void Messages::tell(Severity severity, std::string_view text) const {
  switch (severity) {
    case Severity::kError: return error(text);
    case Severity::kWarning: return warning(text);
    case Severity::kInfo: return note(text);
  }
}

void Messages::tell(const Diagnostics& diagnostics, const std::string& file) const {
  for (const Diagnostic& diagnostic : diagnostics) tell(diagnostic.severity, diagnostic.text(file));
}

Messages Messages::without_notes() const {
  Messages copy = *this;
  copy.tells_notes_ = false;
  return copy;
}

void Messages::write(std::string_view severity, std::string_view text) const {
  // Names from files may contain control characters that a terminal obeys. Replacing them does not change printable
  // text.
  const std::string line =
      fmt::format("{}: {}: {}\n", program_, severity, printable_text(text, std::string_view::npos));
  (void)std::fwrite(line.data(), 1, line.size(), stderr);
}

namespace {

constexpr const char* kEraseLine = "\r\033[K";

bool is_watched(std::FILE* stream) {
  const char* const terminal = std::getenv("TERM");
  return platform::is_terminal(stream) && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

ProgressLine::ProgressLine(std::string what, std::FILE* stream)
    : what_(printable_text(what)), stream_(is_watched(stream) ? stream : nullptr) {}

ProgressLine::~ProgressLine() { erase(); }

void ProgressLine::show(const char* step) {
  if (stream_ == nullptr) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  const std::string line = fmt::format("{}{}: {} ({:.1f} s)", kEraseLine, what_, step, elapsed.count());
  (void)std::fwrite(line.data(), 1, line.size(), stream_);
  std::fflush(stream_);
}

void ProgressLine::erase() {
  if (stream_ == nullptr) return;
  std::fputs(kEraseLine, stream_);
  std::fflush(stream_);
}

void print_result(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

namespace {

/// Behind the first in the order of ToolError::Kind.
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

Exit exit_code(ToolError::Kind kind) { return kMeanings[1 + std::size_t(kind)].code; }

std::string status_word(Exit code) {
  const std::string name = std::ranges::find(kMeanings, code, &ExitMeaning::code)->name;
  return name.substr(0, name.find(" or "));
}

}  // namespace coif::cli
