#pragma once

// Private to this folder: shared by both ends of a job's line.

#include "platform/child_process.h"
#include "platform/descriptor.h"
#include "platform/job.h"

#include <sys/types.h>

#include <cstdint>

namespace coif::platform {

inline constexpr int kLineDescriptor = 3;  ///< The child's, behind its standard streams.
inline constexpr const char* kJobWord = "--run-job";

// Exit statuses of a child whose job has no answer, outside the range of ordinary programs and of sanitizers.
inline constexpr int kExitOutOfMemory = 112;
inline constexpr int kExitFailed = 113;

/// The first message of the asking process; the bytes of the request follow.
struct JobHeader {
  std::uint64_t request_bytes = 0;
  std::uint64_t memory_bytes = ChildLimits::kUnlimited;
  std::uint32_t reader_seconds = ChildLimits::kForever;
  std::uint32_t is_reader = 0;
  std::int32_t parent = 0;     ///< The child ends with it;
  std::uint32_t outlives = 0;  ///< ... unless this is 1.
};

/// Precedes everything that a child sends.
struct JobFrame {
  enum class Kind : std::uint64_t { kNote = 1, kAnswer = 2 };
  Kind kind = Kind::kNote;
  std::uint64_t bytes = 0;
};

struct Spawned {
  Descriptor line;
  pid_t process = -1;
  int error = 0;  ///< errno of the failed system call; 0: the process runs.
};

/// Whether this program has called run_named_job(). One that had not would begin anew in its child, which would ask for
/// the job in turn, without end.
[[nodiscard]] bool answers_jobs();

/// Runs the program again for that job, with its standard streams closed (a reader) or inherited. ENOTSUP unless
/// answers_jobs().
[[nodiscard]] Spawned spawn(const Job& job, bool is_silent);

}  // namespace coif::platform
