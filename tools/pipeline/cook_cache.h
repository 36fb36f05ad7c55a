#pragma once

#include "cook/cook.h"
#include "pipeline/dependency.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace coif {

/// Results of cooks in a folder, found by what they are made of. Two steps, as ccache's direct mode: a key from what is known
/// before the import leads to a folder of entries, and each entry lists the files that its cook read and what it looked for
/// in vain. Any number of processes, on any machines that share the folder, may use it at once: an entry is one file that
/// appears whole or not at all and is believed only where its hash fits. The folder may be deleted, whole or in part, at
/// any time; an entry's modification time is that of its last use.
class CookCache {
 public:
  explicit CookCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The result of the same cook, with the inputs where they lie here. Whatever is absent, damaged or out of date is nothing.
  [[nodiscard]] std::optional<CookResult> find(const std::string& key, const CookPlace& place) const;

  /// Keeps a result. `begin`: file_time_now() before the first input was read; inputs that changed since may not be those
  /// that were read, and the result is not kept. Errors say what keeps it from being kept; the cook itself is none the worse.
  tl::expected<void, ToolError> store(const std::string& key, const CookPlace& place, const CookResult& result,
                                      std::chrono::nanoseconds begin) const;

 private:
  [[nodiscard]] std::filesystem::path folder_of(const std::string& key) const;

  std::filesystem::path folder_;
};

}  // namespace coif
