#include "platform/spawn.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/auxv.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cerrno>
#include <string>

extern char** environ;

namespace coif::platform {
namespace {

/// The actions of a new process before its program begins.
class Actions {
 public:
  Actions(int line, bool is_silent) {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    if (is_silent) {
      for (const int standard : {0, 1, 2})
        add(posix_spawn_file_actions_addopen(&files_, standard, "/dev/null", O_RDWR, 0));
      silence_signals();
    }
    // Last, since opening would replace it. A descriptor that is already in place stays open.
    add(posix_spawn_file_actions_adddup2(&files_, line, kLineDescriptor));
    add(posix_spawn_file_actions_addclosefrom_np(&files_, kLineDescriptor + 1));
  }
  ~Actions() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;

  [[nodiscard]] int run(const char* program, char* const* words, pid_t& process) const {
    return error_ != 0 ? error_ : posix_spawn(&process, program, &files_, &attributes_, words, environ);
  }

 private:
  void add(int error) {
    if (error_ == 0) error_ = error;
  }

  /// Signals that this process ignores or blocks would be ignored or blocked in a process that reads strangers' bytes,
  /// too.
  void silence_signals() {
    sigset_t usual, none;
    sigemptyset(&usual);
    sigemptyset(&none);
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGXFSZ, SIGTERM, SIGPIPE})
      sigaddset(&usual, number);
    add(posix_spawnattr_setsigdefault(&attributes_, &usual));
    add(posix_spawnattr_setsigmask(&attributes_, &none));
    add(posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK));
  }

  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
  int error_ = 0;
};

}  // namespace

Spawned spawn(const Job& job, bool is_silent) {
  if (!answers_jobs()) return {{}, -1, ENOTSUP};
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return {{}, -1, errno};
  Spawned child{Descriptor(ends[0]), -1, 0};
  const Descriptor theirs(ends[1]);
  std::string words[] = {"coif", kJobWord, job.name()};
  char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const Actions actions(theirs.get(), is_silent);
  child.error = actions.run("/proc/self/exe", arguments, child.process);
  if (child.error == ENOENT) {  // There is no /proc.
    const auto* const started_as = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    if (started_as != nullptr) child.error = actions.run(started_as, arguments, child.process);
  }
  return child;
}

}  // namespace coif::platform
