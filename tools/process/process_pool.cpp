#include "process/process_pool.h"

#include "write_all.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace coif {
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
