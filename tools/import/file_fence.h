#pragma once

#include <filesystem>

namespace coif {

/// From now on this thread and what it starts may read files in this folder and below, and this one file wherever a link
/// leads for it; it may open, make, change, remove or run nothing else, nor reach the network. Descriptors that are open
/// already stay as they are. There is no way back. False where the kernel cannot do that (Linux before 5.13, or Landlock
/// is turned off); then nothing has changed.
bool fence_files(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace coif
