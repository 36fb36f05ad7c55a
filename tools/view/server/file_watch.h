#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace coif::view {

/// Tells which of some files were written, appeared or went, by asking for their times. For one thread.
class FileWatch {
 public:
  using Time = std::filesystem::file_time_type;

  /// From now on these and no others. A file that was watched keeps what is known of it; a new one counts as changed
  /// where it was written after `since`, when somebody began to read it.
  void watch(std::span<const std::filesystem::path> files, Time since);

  /// Those that differ from what they were at the last call.
  [[nodiscard]] std::vector<std::filesystem::path> changed();

 private:
  struct Stamp {
    Time written;
    std::uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  /// None for a file that is not there.
  static std::optional<Stamp> stamp_of(const std::filesystem::path& file);

  struct Watched {
    std::optional<Stamp> stamp;
    bool is_new = false;  ///< Changed before it was watched.
  };
  std::map<std::filesystem::path, Watched> files_;
};

}  // namespace coif::view
