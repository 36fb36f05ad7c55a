#include "platform/child_process.h"

#include "platform/descriptor.h"
#include "platform/work_limit.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <thread>
#include <utility>

namespace coif {

std::uint64_t address_space_in_use() {
  unsigned long long pages = 0;
  if (std::FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%llu", &pages) != 1) pages = 0;
    std::fclose(statm);
  }
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::uint64_t swap_memory_limit(std::uint64_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  const std::uint64_t before = limit.rlim_cur;
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
  return before;
}

namespace {

using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

constexpr int kMillisecondsOfLook = 50;  // how soon somebody who waits for a child notices that nobody wants its answer
constexpr int kPipeDescriptor = 3;       // in a limited child, after its other descriptors are closed
constexpr rlim_t kMaxDescriptors = 32;   // model, side files, dynamic loader
constexpr int kExitOutOfMemory = 112;    // outside the range of ordinary programs and of sanitizers
constexpr int kExitFailed = 113;
constexpr int kExitNoDescriptors = 114;

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  setrlimit(resource, &value);
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

/// Ends the process where it may have no more descriptors.
void keep_only(int pipe_end) {
  const int high = fcntl(pipe_end, F_DUPFD, kPipeDescriptor + 1);  // out of the way of 0 to 3
  if (high < 0) _exit(kExitNoDescriptors);
  close_range(kPipeDescriptor, unsigned(high) - 1, 0);
  close_range(unsigned(high) + 1, ~0u, 0);
  const int null = open("/dev/null", O_RDWR);
  if (null < 0) _exit(kExitNoDescriptors);
  for (const int standard : {0, 1, 2}) dup2(null, standard);
  dup2(high, kPipeDescriptor);
  close_range(kPipeDescriptor + 1, ~0u, 0);
}

/// `limits`: null for none.
[[noreturn]] void child_main(int pipe_end, const ChildLimits* limits, const std::function<Bytes()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a killed build leaves nobody working
  if (limits != nullptr) {
    reset_signals();
    keep_only(pipe_end);
    apply_limits(*limits);
    pipe_end = kPipeDescriptor;
  }
  // _exit: the parent's buffers and exit handlers are not the child's to flush and run.
  try {
    const Bytes answer = work();
    _exit(write_all(pipe_end, std::as_bytes(std::span(answer))) ? kExitFailed : 0);
  } catch (const std::bad_alloc&) {
    _exit(kExitOutOfMemory);
  } catch (...) {
    _exit(kExitFailed);
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
    if (result.code == kExitNoDescriptors) result = {ChildResult::End::kNotStarted, EMFILE, false, {}};
  }
}

/// A forked process that works and answers through a pipe. It is killed and waited for when this object goes early, by
/// a limit or by an exception.
class Child {
 public:
  /// `limits`: null for none; must outlive the object.
  Child(const ChildLimits* limits, const std::function<Bytes()>& work) : limits_(limits) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
      result_.code = errno;
      return;
    }
    if (limits != nullptr) deadline_ = Clock::now() + std::chrono::seconds(limits->seconds);
    process_ = fork();
    if (process_ == 0) child_main(ends[1], limits, work);
    if (process_ < 0) result_.code = errno;
    close(ends[1]);
    descriptor_ = ends[0];
    if (process_ > 0) result_.end = ChildResult::End::kFinished;
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (descriptor_ >= 0) close(descriptor_);
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  [[nodiscard]] bool is_running() const { return process_ > 0 && result_.end == ChildResult::End::kFinished; }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// At most, for poll(); -1: for ever.
  [[nodiscard]] int milliseconds_left() const {
    if (limits_ == nullptr) return -1;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1 << 30));
  }

  /// Moves what is in the pipe, which is drained while the child runs, so that neither waits for the other; at its end
  /// waits for the child.
  void read_some() {
    std::uint8_t block[1 << 16];
    const ssize_t n = read(descriptor_, block, sizeof block);
    if (n < 0 && errno == EINTR) return;
    if (n <= 0) return finish();
    const std::uint64_t most = limits_ != nullptr ? limits_->output_bytes : ~std::uint64_t{0};
    if (static_cast<std::uint64_t>(n) > most - result_.output.size()) {
      result_.end = ChildResult::End::kTooMuchOutput;
    } else {
      result_.output.insert(result_.output.end(), block, block + n);
    }
  }
  void give_up() { result_.end = ChildResult::End::kTooSlow; }

  [[nodiscard]] ChildResult take_result() {
    if (result_.end != ChildResult::End::kFinished) result_.output.clear();
    return std::move(result_);
  }

 private:
  /// The child has closed its pipe, but need not have ended. Where it cannot be waited for (the host ignores SIGCHLD),
  /// its answer is all there is to judge by.
  void finish() {
    int status = 0;
    for (;;) {
      const pid_t done = waitpid(process_, &status, limits_ != nullptr ? WNOHANG : 0);
      if (done == process_) break;
      if (done < 0 && errno == EINTR) continue;
      if (done < 0) return release();
      if (Clock::now() >= deadline_) return give_up();
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    judge_status(status, result_);
    release();
  }
  void release() { process_ = 0; }

  const ChildLimits* limits_;
  Clock::time_point deadline_{};
  pid_t process_ = -1;
  int descriptor_ = -1;
  ChildResult result_;
};

/// Until one of them is no longer running, or the time that this process may work (WorkLimit) is over, which is thrown.
void wait_for_one(std::span<const std::unique_ptr<Child>> children) {
  while (std::ranges::all_of(children, &Child::is_running, [](const auto& child) -> Child& { return *child; })) {
    std::vector<pollfd> waiting;
    for (const auto& child : children) waiting.push_back({child->descriptor(), POLLIN, 0});
    const int left = children.front()->milliseconds_left();
    const int ready = poll(waiting.data(), waiting.size(), std::min(left, kMillisecondsOfLook));
    WorkLimit::check();
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0 && children.front()->milliseconds_left() != 0) continue;
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (ready <= 0) children[i]->give_up();
      if (waiting[i].revents != 0) children[i]->read_some();
    }
  }
}

}  // namespace

ChildResult run_in_child(const ChildLimits& limits, const std::function<Bytes()>& work) {
  const std::unique_ptr<Child> child[] = {std::make_unique<Child>(&limits, work)};
  wait_for_one(child);
  return child[0]->take_result();
}

std::vector<std::optional<std::string>> run_in_processes(std::size_t count, unsigned jobs,
                                                         const std::function<std::string(std::size_t)>& work) {
  std::vector<std::optional<std::string>> answers(count);
  std::vector<std::unique_ptr<Child>> running;
  std::vector<std::size_t> index;  // of each that is running
  for (std::size_t next = 0; next < count || !running.empty();) {
    for (; next < count && running.size() < std::max(jobs, 1u); ++next) {
      std::fflush(nullptr);  // else the child prints again what waits in buffers
      running.push_back(std::make_unique<Child>(nullptr, [&work, next] {
        const std::string answer = work(next);
        return Bytes(answer.begin(), answer.end());
      }));
      index.push_back(next);
    }
    wait_for_one(running);
    for (std::size_t i = running.size(); i-- > 0;) {
      if (running[i]->is_running()) continue;
      const ChildResult result = running[i]->take_result();
      if (result.end == ChildResult::End::kFinished)
        answers[index[i]].emplace(result.output.begin(), result.output.end());
      running.erase(running.begin() + std::ptrdiff_t(i));
      index.erase(index.begin() + std::ptrdiff_t(i));
    }
  }
  return answers;
}

}  // namespace coif
