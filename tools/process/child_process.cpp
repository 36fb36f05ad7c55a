#include "process/child_process.h"

#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <map>
#include <new>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace coif {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPipeDescriptor = 3;      // in the child, after its other descriptors are closed
constexpr rlim_t kMaxDescriptors = 32;  // model, side files, dynamic loader
constexpr int kExitOutOfMemory = 112;   // outside the range of ordinary programs and of sanitizers
constexpr int kExitFailed = 113;
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kMemoryIsLimited = false;
#else
constexpr bool kMemoryIsLimited = true;
#endif

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  setrlimit(resource, &value);
}

std::uint64_t address_space_in_use() {
  unsigned long long pages = 0;
  if (std::FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%llu", &pages) != 1) pages = 0;
    std::fclose(statm);
  }
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void apply_limits(const ChildLimits& limits) {
  if (kMemoryIsLimited) {
    const rlim_t inherited = address_space_in_use();
    const rlim_t memory = inherited + std::min<rlim_t>(limits.memory_bytes, RLIM_INFINITY - inherited);
    limit(RLIMIT_AS, memory, memory);
  }
  limit(RLIMIT_CPU, limits.seconds, rlim_t{limits.seconds} + 1);
  limit(RLIMIT_FSIZE, 0, 0);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_NOFILE, kMaxDescriptors, kMaxDescriptors);
}

// The host's handlers would run in a process that is not the host.
void reset_signals() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGXFSZ, SIGTERM, SIGPIPE}) {
    signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void keep_only(int pipe_end) {
  const int high = fcntl(pipe_end, F_DUPFD, 10);  // out of the way of 0 to 3
  const int null = open("/dev/null", O_RDWR);
  for (const int standard : {0, 1, 2}) dup2(null, standard);
  dup2(high, kPipeDescriptor);
  close_range(kPipeDescriptor + 1, ~0u, 0);
}

[[noreturn]] void child_main(int pipe_end, const ChildLimits& limits,
                             const std::function<std::vector<std::uint8_t>()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  reset_signals();
  keep_only(pipe_end);
  apply_limits(limits);
  // _exit: the parent's buffers and exit handlers are not the child's to flush and run.
  try {
    const std::vector<std::uint8_t> answer = work();
    _exit(write_all(kPipeDescriptor, std::as_bytes(std::span(answer))) ? kExitFailed : 0);
  } catch (const std::bad_alloc&) {
    _exit(kExitOutOfMemory);
  } catch (...) {
    _exit(kExitFailed);
  }
}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1 << 30));
}

// Reads until the child closes its end. The pipe is drained while the child runs, so neither waits for the other.
ChildResult::End read_output(int descriptor, Clock::time_point deadline, std::uint64_t max_bytes,
                             std::vector<std::uint8_t>& output) {
  std::vector<std::uint8_t> block(1 << 16);
  for (;;) {
    pollfd waiting{descriptor, POLLIN, 0};
    const int ready = poll(&waiting, 1, milliseconds_until(deadline));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return ChildResult::End::kTooSlow;
    const ssize_t n = read(descriptor, block.data(), block.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return ChildResult::End::kFinished;
    if (static_cast<std::uint64_t>(n) > max_bytes - output.size()) return ChildResult::End::kTooMuchOutput;
    output.insert(output.end(), block.begin(), block.begin() + n);
  }
}

// Waits until the deadline, then kills. False when the child cannot be waited for (the host ignores SIGCHLD).
bool reap(pid_t child, Clock::time_point deadline, int& status, bool& timed_out) {
  for (;;) {
    const pid_t done = waitpid(child, &status, timed_out ? 0 : WNOHANG);
    if (done == child) return true;
    if (done < 0 && errno != EINTR) return false;
    if (!timed_out && Clock::now() >= deadline) {
      timed_out = true;
      kill(child, SIGKILL);
    } else {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  }
}

void judge_status(int status, ChildResult& result) {
  if (WIFSIGNALED(status)) {
    result.end = WTERMSIG(status) == SIGXCPU ? ChildResult::End::kTooSlow : ChildResult::End::kCrashed;
    result.code = WTERMSIG(status);
    result.by_signal = true;
  } else if (WEXITSTATUS(status) != 0) {
    result.code = WEXITSTATUS(status);
    result.end = result.code == kExitOutOfMemory ? ChildResult::End::kOutOfMemory : ChildResult::End::kCrashed;
  }
}

// Kills the child when the reader leaves early, by a limit or by an exception.
class ChildGuard {
 public:
  ChildGuard(pid_t child, int descriptor) : child_(child), descriptor_(descriptor) {}
  ChildGuard(const ChildGuard&) = delete;
  ChildGuard& operator=(const ChildGuard&) = delete;
  ~ChildGuard() {
    close(descriptor_);
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  void release() { child_ = 0; }

 private:
  pid_t child_;
  int descriptor_;
};

}  // namespace

ChildResult run_in_child(const ChildLimits& limits, const std::function<std::vector<std::uint8_t>()>& work) {
  ChildResult result;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    result.code = errno;
    return result;
  }
  const auto deadline = Clock::now() + std::chrono::seconds(limits.seconds);
  const pid_t child = fork();
  if (child == 0) child_main(ends[1], limits, work);
  const int fork_error = errno;
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    result.code = fork_error;
    return result;
  }
  ChildGuard guard(child, ends[0]);
  result.end = read_output(ends[0], deadline, limits.output_bytes, result.output);
  if (result.end == ChildResult::End::kFinished) {
    int status = 0;
    bool timed_out = false;
    const bool known = reap(child, deadline, status, timed_out);
    guard.release();
    if (timed_out)
      result.end = ChildResult::End::kTooSlow;
    else if (known)
      judge_status(status, result);
  }
  if (result.end != ChildResult::End::kFinished) result.output.clear();
  return result;
}

namespace {

struct Running {
  std::size_t index = 0;
  int answer = -1;  ///< A file in memory that both processes hold.
};

std::string read_all(int file) {
  struct stat status {};
  if (::fstat(file, &status) != 0) return {};
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  const ssize_t n = ::pread(file, text.data(), text.size(), 0);
  return n == status.st_size ? text : std::string{};
}

[[noreturn]] void child_main(int answer, std::size_t index, const std::function<std::string(std::size_t)>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a killed build leaves nobody working
  // _exit: what the parent has registered for its end is not the child's to run.
  try {
    const std::string text = work(index);
    ::_exit(write_all(answer, std::as_bytes(std::span(text))) ? EXIT_FAILURE : EXIT_SUCCESS);
  } catch (...) {
    ::_exit(EXIT_FAILURE);
  }
}

void start(std::size_t index, const std::function<std::string(std::size_t)>& work, std::map<pid_t, Running>& running) {
  const int answer = ::memfd_create("coif answer", MFD_CLOEXEC);
  if (answer < 0) return;
  std::fflush(nullptr);  // else the child prints again what waits in buffers
  const pid_t child = ::fork();
  if (child == 0) child_main(answer, index, work);
  if (child > 0) {
    running[child] = {index, answer};
  } else {
    ::close(answer);
  }
}

}  // namespace

std::vector<std::optional<std::string>> run_in_processes(std::size_t count, unsigned jobs,
                                                         const std::function<std::string(std::size_t)>& work) {
  std::vector<std::optional<std::string>> answers(count);
  std::map<pid_t, Running> running;
  for (std::size_t next = 0; next < count || !running.empty();) {
    while (next < count && running.size() < std::max(jobs, 1u)) start(next++, work, running);
    int status = 0;
    const pid_t done = ::waitpid(-1, &status, 0);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) break;  // the host ignores SIGCHLD: nobody is left to wait for
    const auto found = running.find(done);
    if (found == running.end()) continue;
    const auto [index, answer] = found->second;
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) answers[index] = read_all(answer);
    ::close(answer);
    running.erase(found);
  }
  return answers;
}

}  // namespace coif
