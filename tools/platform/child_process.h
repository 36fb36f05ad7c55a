#pragma once

#include "platform/job.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace coif::platform {

/// The kind of a child process, which decides what it may do.
enum class ChildKind : std::uint32_t {
  kReader,  ///< Reads bytes from strangers: it writes no file, prints nothing, and time is processor time as well.
  kWorker,  ///< Works for this process: it prints where this one prints, writes files and starts jobs of its own.
};

struct ChildLimits {
  static constexpr std::uint64_t kUnlimited = ~std::uint64_t{0};
  static constexpr std::uint32_t kForever = ~std::uint32_t{0};

  std::uint64_t memory_bytes = kUnlimited;  ///< Address space that the child may add to a program's initial one.
  std::uint32_t seconds = kForever;         ///< For the whole call.
  std::uint64_t output_bytes = kUnlimited;  ///< Limit of the child's answer, notes included.
  std::uint32_t part_seconds = kForever;    ///< From one note to the next.
};

struct ChildResult {
  enum class End {
    kFinished,     ///< `output` is complete if the child is honest; check it all the same.
    kCrashed,      ///< `code`: the signal, or the exit status where `by_signal` is false.
    kTooSlow,      ///< Ran past `seconds`, or past `part_seconds` where `is_part`.
    kOutOfMemory,  ///< An allocation failed in the child.
    kTooMuchOutput,
    kNotStarted,  ///< `code`: errno of the failed system call.
  };
  End end = End::kNotStarted;
  int code = 0;
  bool by_signal = false;
  bool is_part = false;
  Bytes output{};  ///< Empty unless kFinished.
};

struct ChildSettings {
  ChildKind kind = ChildKind::kReader;
  ChildLimits limits{};
  std::stop_token stop{};                                ///< Requested: nobody wants the answer any more.
  std::function<void(std::string_view note)> on_note{};  ///< Called while run_in_child() waits. May be empty.
};

/// Runs a job in a child process under limits and returns its answer. The child has no descriptor of this process but
/// the line back, and dies with the thread that started it. Blocks until the child is gone; leaves no zombie. A worker
/// that exceeds its time, or is no longer wanted, learns that by JobCall::stop() and is killed 0.2 s later; a reader is
/// killed at once. Memory limits are off under AddressSanitizer. Throws Stopped, after the child has ended, where
/// settings.stop is requested.
[[nodiscard]] ChildResult run_in_child(const Job& job, std::span<const std::uint8_t> request,
                                       const ChildSettings& settings);

/// Runs the job once for each request, each in a worker of its own, up to `jobs` at once, and returns the answers in
/// the order of the requests; none for a process that crashed, was killed or could not be started.
[[nodiscard]] std::vector<std::optional<Bytes>> run_in_processes(const Job& job, const std::vector<Bytes>& requests,
                                                                 unsigned jobs);

/// False under AddressSanitizer, whose shadow needs terabytes of address space.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kMemoryIsLimited = false;
#else
inline constexpr bool kMemoryIsLimited = true;
#endif

}  // namespace coif::platform
