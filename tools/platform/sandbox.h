#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace coif::platform {

/// From now on this thread and what it starts may read files in these folders and below, and this one file (empty:
/// none) wherever a link leads for it; it may open, make, change, remove or run nothing else, nor reach the network by
/// TCP; where the kernel can (Linux 6.12), nor abstract sockets, nor signal other processes. Descriptors that are open
/// already stay as they are. There is no way back. False where the kernel cannot do that (Linux before 5.13, or
/// Landlock is turned off); then nothing has changed.
bool fence_files(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file);

/// From now on this process can make no socket and no process, run no program, signal, trace or change no other
/// process, and ask for nothing of the kernel's rarer parts: such a call fails (EPERM). Threads and all else go on.
/// There is no way back. False where the kernel cannot do that, or for a processor other than x86-64 and aarch64; then
/// nothing has changed.
bool filter_calls();

/// Both, fence_files() and filter_calls(), as far as the kernel can. False where it cannot do all.
bool lock_up(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file);

/// What this machine lacks for lock_up(), as the end of a sentence: "this kernel has no Landlock". Empty: nothing.
[[nodiscard]] std::string missing_sandbox();

}  // namespace coif::platform
