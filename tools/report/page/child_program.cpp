#include "report/page/child_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <span>
#include <thread>
#include <utility>

namespace coif {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr rlim_t kMaxMemory = rlim_t{2} << 30;
constexpr rlim_t kMaxDescriptors = 64;

/// A file descriptor that closes itself. Never 0, 1 or 2, which the child overwrites.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {
    if (number > STDERR_FILENO || number < 0) return;
    number_ = fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_ = -1;
};

struct Pipe {
  Descriptor read_end, write_end;

  [[nodiscard]] bool open() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return false;
    read_end = Descriptor(ends[0]);
    write_end = Descriptor(ends[1]);
    return read_end.is_open() && write_end.is_open();
  }
};

// The whole input lies in memory before the program starts: nobody waits for anybody, and a program that ends without
// reading it raises no SIGPIPE here.
Descriptor memory_file(const std::string& content) {
  Descriptor file(memfd_create("input", MFD_CLOEXEC));
  std::size_t written = 0;
  while (file.is_open() && written < content.size()) {
    const ssize_t n = write(file.number(), content.data() + written, content.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return {};
    written += static_cast<std::size_t>(n);
  }
  if (file.is_open() && lseek(file.number(), 0, SEEK_SET) != 0) return {};
  return file;
}

void limit(__rlimit_resource resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

struct ChildSetup {
  char* const* arguments;
  char* const* environment;
  int input, output, messages;
  int failure;  ///< Takes the errno of a failed start; closed by a good one.
  rlim_t seconds;
};

// Between fork and exec: no allocation, the host may have other threads.
[[noreturn]] void start_program(const ChildSetup& setup) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGPIPE, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(setup.input, STDIN_FILENO);
  dup2(setup.output, STDOUT_FILENO);
  dup2(setup.messages, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0u, CLOSE_RANGE_CLOEXEC);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_AS, kMaxMemory);
  limit(RLIMIT_NOFILE, kMaxDescriptors);
  limit(RLIMIT_CPU, setup.seconds);
  execvpe(setup.arguments[0], setup.arguments, setup.environment);
  const int why = errno;
  [[maybe_unused]] const ssize_t told = write(setup.failure, &why, sizeof why);
  _exit(127);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// The child and its own children; they die with this object unless they were waited for.
class ProcessGroup {
 public:
  explicit ProcessGroup(pid_t leader) : leader_(leader) {}
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ~ProcessGroup() {
    if (leader_ <= 0) return;
    kill(-leader_, SIGKILL);
    kill(leader_, SIGKILL);  // it may not have made its group yet
    while (waitpid(leader_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// False at the deadline.
  [[nodiscard]] bool wait(Clock::time_point deadline, int& status) {
    for (;;) {
      const pid_t done = waitpid(leader_, &status, WNOHANG);
      if (done == leader_ || (done < 0 && errno != EINTR)) {
        leader_ = 0;
        return done > 0;
      }
      if (Clock::now() >= deadline) return false;
      std::this_thread::sleep_for(milliseconds(1));
    }
  }

 private:
  pid_t leader_;
};

struct Stream {
  int descriptor;
  std::string* text;
};

/// Moves what there is. False at the stream's end.
bool drain(const Stream& stream) {
  char block[1 << 14];
  const ssize_t n = read(stream.descriptor, block, sizeof block);
  if (n < 0) return errno == EINTR || errno == EAGAIN;
  stream.text->append(block, static_cast<std::size_t>(n));
  return n > 0;
}

ProgramResult::End read_streams(std::vector<Stream> streams, Clock::time_point deadline, std::size_t max_bytes) {
  while (!streams.empty()) {
    std::vector<pollfd> waiting;
    for (const Stream& stream : streams) waiting.push_back({stream.descriptor, POLLIN, 0});
    const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now()).count();
    const int ready = poll(waiting.data(), waiting.size(), static_cast<int>(std::clamp<long long>(left, 0, 1 << 30)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return ProgramResult::End::kTooSlow;
    for (std::size_t i = streams.size(); i-- > 0;) {
      if (waiting[i].revents == 0) continue;
      const bool more = drain(streams[i]);
      if (streams[i].text->size() > max_bytes) return ProgramResult::End::kTooMuchOutput;
      if (!more) streams.erase(streams.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return ProgramResult::End::kFinished;
}

ProgramResult not_started(int code) {
  ProgramResult result;
  result.code = code;
  return result;
}

void judge(int status, ProgramResult& result) {
  const bool by_signal = WIFSIGNALED(status);
  result.end = by_signal ? ProgramResult::End::kKilled : ProgramResult::End::kFinished;
  result.code = by_signal ? WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input,
                          const ProgramLimits& limits) {
  const auto deadline = Clock::now() + limits.patience;
  const Descriptor input_file = memory_file(input);
  Pipe output, messages, failure;
  if (!input_file.is_open() || !output.open() || !messages.open() || !failure.open()) return not_started(errno);

  const char* const path = std::getenv("PATH");
  std::vector<std::string> words = arguments;
  std::vector<std::string> variables{std::string("PATH=") + (path ? path : ""), "LC_ALL=C.UTF-8", "HOME=/nonexistent"};
  const auto word_pointers = pointers(words), variable_pointers = pointers(variables);
  const auto seconds = static_cast<rlim_t>(std::chrono::ceil<std::chrono::seconds>(limits.patience).count() + 1);
  const pid_t child = fork();
  if (child == 0) {
    start_program({word_pointers.data(), variable_pointers.data(), input_file.number(), output.write_end.number(),
                   messages.write_end.number(), failure.write_end.number(), seconds});
  }
  if (child < 0) return not_started(errno);
  ProcessGroup group(child);
  for (Pipe* pipe : {&output, &messages, &failure}) pipe->write_end.close();

  ProgramResult result;
  if (int why = 0; read(failure.read_end.number(), &why, sizeof why) == sizeof why) return not_started(why);
  result.end =
      read_streams({{output.read_end.number(), &result.output}, {messages.read_end.number(), &result.messages}},
                   deadline, limits.output_bytes);
  if (result.end != ProgramResult::End::kFinished) return result;
  int status = 0;
  result.end = ProgramResult::End::kTooSlow;
  if (group.wait(deadline, status)) judge(status, result);
  return result;
}

}  // namespace coif
