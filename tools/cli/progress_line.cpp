#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>
#include <utility>

namespace coif {
namespace {

constexpr const char* kEraseLine = "\r\033[K";

bool is_watched(std::FILE* stream) {
  const char* const terminal = std::getenv("TERM");
  return isatty(fileno(stream)) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

ProgressLine::ProgressLine(std::string what, std::FILE* stream)
    : what_(std::move(what)), stream_(is_watched(stream) ? stream : nullptr) {}

ProgressLine::~ProgressLine() { erase(); }

void ProgressLine::show(const char* step) {
  if (stream_ == nullptr) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  fmt::print(stream_, "{}{}: {} ({:.1f} s)", kEraseLine, what_, step, elapsed.count());
  std::fflush(stream_);
}

void ProgressLine::erase() {
  if (stream_ == nullptr) return;
  std::fputs(kEraseLine, stream_);
  std::fflush(stream_);
}

}  // namespace coif
