#include "platform/job.h"

#include "platform/spawn.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <new>
#include <thread>

namespace coif::platform {
namespace {

/// The last that was defined; each knows the one before.
constinit const Job* last_job = nullptr;
constinit bool has_answered = false;

constexpr rlim_t kDescriptorsOfReader = 32;  // model, side files, dynamic loader

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  setrlimit(resource, &value);
}

/// Bytes of address space of this process, reserved ones included.
rlim_t address_space_in_use() {
  unsigned long long pages = 0;
  if (std::FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%llu", &pages) != 1) pages = 0;
    std::fclose(statm);
  }
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit_memory(const JobHeader& header) {
  if (!kMemoryIsLimited || header.memory_bytes == ChildLimits::kUnlimited) return;
  const rlim_t in_use = address_space_in_use();
  const rlim_t most = in_use + std::min<rlim_t>(header.memory_bytes, RLIM_INFINITY - in_use);
  rlimit now{};
  getrlimit(RLIMIT_AS, &now);
  // A worker's own children have limits of their own, which may be higher.
  const bool is_reader = header.is_reader != 0;
  limit(RLIMIT_AS, is_reader ? most : std::min(most, now.rlim_max), is_reader ? most : now.rlim_max);
}

void apply_limits(const JobHeader& header) {
  limit_memory(header);
  if (header.is_reader == 0) return;
  // A crash must be reported as its signal, where a sanitizer would make it an exit status.
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) signal(number, SIG_DFL);
  if (header.reader_seconds != ChildLimits::kForever)
    limit(RLIMIT_CPU, header.reader_seconds, rlim_t{header.reader_seconds} + 1);
  limit(RLIMIT_FSIZE, 0, 0);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_NOFILE, kDescriptorsOfReader, kDescriptorsOfReader);
}

/// False where the line ends before.
bool read_all(int descriptor, void* data, std::size_t size) {
  auto* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t count = read(descriptor, at, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

void wait_until_closed(int descriptor) {
  char byte = 0;
  while (read(descriptor, &byte, 1) < 0 && errno == EINTR) {
  }
}

}  // namespace

/// The child's end of the line.
class JobCall::Line {
 public:
  /// Ends the process where nobody is at the other end.
  Line() {
    JobHeader header;
    if (!read_all(kLineDescriptor, &header, sizeof header)) _exit(kExitFailed);
    if (header.outlives == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // a killed build leaves nobody working
      if (getppid() != header.parent) _exit(kExitFailed);
    }
    apply_limits(header);
    request_.resize(header.request_bytes);
    if (!read_all(kLineDescriptor, request_.data(), request_.size())) _exit(kExitFailed);
  }

  [[nodiscard]] std::span<const std::uint8_t> request() const { return request_; }

  [[nodiscard]] bool send(JobFrame::Kind kind, std::span<const std::byte> bytes) {
    const std::lock_guard guard(sending_);
    const JobFrame frame{kind, bytes.size()};
    return !write_all(kLineDescriptor, std::as_bytes(std::span(&frame, 1))) && !write_all(kLineDescriptor, bytes);
  }

  [[nodiscard]] std::stop_token stop() {
    const std::lock_guard guard(watching_);
    if (!is_watched_) {
      is_watched_ = true;
      // Never joined: the process ends by _exit().
      std::thread([this] {
        wait_until_closed(kLineDescriptor);
        stop_.request_stop();
      }).detach();
    }
    return stop_.get_token();
  }

 private:
  Bytes request_;
  std::mutex sending_, watching_;
  std::stop_source stop_;
  bool is_watched_ = false;
};

std::span<const std::uint8_t> JobCall::request() const { return line_.request(); }

void JobCall::note(std::string_view text) const {
  (void)line_.send(JobFrame::Kind::kNote, std::as_bytes(std::span(text)));
}

std::stop_token JobCall::stop() const { return line_.stop(); }

void JobCall::wait_for_end() const { wait_until_closed(kLineDescriptor); }

bool answers_jobs() { return has_answered; }

Job::Job(const char* name, Function function) : name_(name), function_(function), next_(last_job) { last_job = this; }

void run_named_job(int argc, const char* const* argv) {
  has_answered = true;
  if (argc != 3 || std::strcmp(argv[1], kJobWord) != 0) return;
  const Job* job = last_job;
  while (job != nullptr && std::strcmp(job->name_, argv[2]) != 0) job = job->next_;
  if (job == nullptr) _exit(kExitFailed);
  signal(SIGPIPE, SIG_IGN);  // The asking process may be gone.
  // _exit: nothing is left to be flushed, and threads may still run.
  try {
    auto& line = *new JobCall::Line;  // a thread may look at it until the process ends
    const Bytes answer = job->function_(JobCall(line));
    std::fflush(nullptr);
    _exit(line.send(JobFrame::Kind::kAnswer, std::as_bytes(std::span(answer))) ? 0 : kExitFailed);
  } catch (const std::bad_alloc&) {
    _exit(kExitOutOfMemory);
  } catch (...) {
    _exit(kExitFailed);
  }
}

}  // namespace coif::platform
