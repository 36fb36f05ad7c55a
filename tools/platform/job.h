#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coif::platform {

using Bytes = std::vector<std::uint8_t>;

/// A job's input from the process that started it, and its line back.
class JobCall {
 public:
  class Line;
  explicit JobCall(Line& line) : line_(line) {}

  /// Bytes that the asking process sent. They live as long as the job.
  [[nodiscard]] std::span<const std::uint8_t> request() const;

  /// Sends a note while the job works. Any thread. Does nothing where nobody listens any more.
  void note(std::string_view text) const;

  /// Requested once the asking process wants no answer any more, or has ended. Starts a thread on the first call.
  [[nodiscard]] std::stop_token stop() const;

  /// Returns once the asking process has ended the call, or has itself ended.
  void wait_for_end() const;

 private:
  Line& line_;
};

/// Work that a child process does, by name. The program is run again with the name of a job, so that the child shares
/// no memory, no lock and no thread with the process that asks. Define jobs at namespace scope, in the file that uses
/// them: they enter the table of the program's jobs before main() begins.
class Job {
 public:
  /// Returns the answer. The asking process gets an exception as a failure; std::bad_alloc as such.
  using Function = Bytes (*)(const JobCall& call);

  Job(const char* name, Function function);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  [[nodiscard]] const char* name() const { return name_; }

 private:
  friend void run_named_job(int argc, const char* const* argv);

  const char* name_;
  Function function_;
  const Job* next_;
};

/// Does nothing unless this process was started for a job; then it runs that and ends the process. Every program that
/// uses jobs calls it first in main(); in a program that does not, no job runs.
void run_named_job(int argc, const char* const* argv);

// The sandbox of a job that reads bytes from strangers: a fence around files (Landlock) and a filter of system calls
// (seccomp).

/// From now on this thread and threads and processes that it starts may read files in and below these folders, and this
/// one file (empty: none), wherever its links lead. They may open, make, change, remove or run nothing else, nor reach
/// the network by TCP; where the kernel supports it (Linux 6.12), nor abstract sockets, nor signal other processes.
/// Open descriptors stay usable. This cannot be undone. False where the kernel does not support it (Linux before 5.13,
/// or Landlock is turned off); then nothing has changed.
bool fence_files(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file);

/// From now on this process can make no socket and no process, run no program, signal, trace or change no other
/// process, and use none of the kernel's rarer parts: such a call fails (EPERM). Threads and everything else still
/// work. This cannot be undone. False where the kernel does not support it, or on a processor other than x86-64 and
/// aarch64; then nothing has changed.
bool filter_calls();

/// Both fence_files() and filter_calls(), as far as the kernel supports them. False where one is missing.
bool lock_up(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file);

/// The features that this machine lacks for lock_up(), as the end of a sentence: "this kernel has no Landlock". Empty:
/// none.
[[nodiscard]] std::string missing_sandbox();

}  // namespace coif::platform
