#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace coif::platform {

using Bytes = std::vector<std::uint8_t>;

/// What a job gets from the process that asked for it, and its way back.
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

/// Work that a child process does, by name. A process is started by running the program again with the name of a job,
/// so that it shares no memory, no lock and no thread with the process that asks. Define jobs at namespace scope, in
/// the file that asks for them: they enter the table of the program's jobs before main() begins.
class Job {
 public:
  /// Returns the answer. What it throws is told to the asking process as a failure; std::bad_alloc as what it is.
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

/// Does nothing unless this process was started for a job; then runs that and ends the process. Every program that
/// asks for jobs calls it first in main().
void run_named_job(int argc, const char* const* argv);

}  // namespace coif::platform
