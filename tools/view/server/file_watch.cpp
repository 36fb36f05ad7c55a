#include "view/server/live_cook.h"

#include <system_error>
#include <utility>

namespace coif::view {

namespace fs = std::filesystem;

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const fs::path& file) {
  std::error_code error;
  const Time written = fs::last_write_time(file, error);
  if (error) return std::nullopt;
  const std::uintmax_t bytes = fs::file_size(file, error);
  return Stamp{written, error ? 0 : bytes};
}

void FileWatch::watch(std::span<const fs::path> files, Time since) {
  std::map<fs::path, Watched> watched;
  for (const fs::path& file : files) {
    if (const auto known = files_.find(file); known != files_.end()) {
      watched.insert(*known);
      continue;
    }
    const auto stamp = stamp_of(file);
    watched[file] = {stamp, stamp && stamp->written > since};
  }
  files_ = std::move(watched);
}

std::vector<fs::path> FileWatch::changed() {
  std::vector<fs::path> found;
  for (auto& [file, known] : files_) {
    auto stamp = stamp_of(file);
    if (stamp != known.stamp || known.is_new) found.push_back(file);
    known = {std::move(stamp), false};
  }
  return found;
}

}  // namespace coif::view
