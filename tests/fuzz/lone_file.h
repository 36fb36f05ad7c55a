#pragma once

#include "fuzz/targets.h"

#include <filesystem>

namespace coif::fuzz {

/// A file alone in a folder of its own, for readers that want a path. The folder goes with the object.
class LoneFile {
 public:
  explicit LoneFile(const char* name);
  ~LoneFile();
  LoneFile(const LoneFile&) = delete;
  LoneFile& operator=(const LoneFile&) = delete;

  /// The file with these bytes, instead of those before.
  const std::filesystem::path& with(Input bytes) const;

 private:
  std::filesystem::path folder_, path_;
};

}  // namespace coif::fuzz
