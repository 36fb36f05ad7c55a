#include "platform/program.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>

namespace coif::platform {

std::filesystem::path program_path() {
  std::error_code error;
  std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : path;
}

std::uint64_t process_number() { return static_cast<std::uint64_t>(::getpid()); }

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

void fill_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // open() takes the lowest number that is free.
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

void ignore_signals_of_writing() {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

struct EndSignals::Held {
  sigset_t ends{};
  sigset_t before{};
};

EndSignals::EndSignals() : held_(std::make_unique<Held>()) {
  sigemptyset(&held_->ends);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held_->ends, number);
  pthread_sigmask(SIG_BLOCK, &held_->ends, &held_->before);
  signal(SIGPIPE, SIG_IGN);
}

EndSignals::~EndSignals() { pthread_sigmask(SIG_SETMASK, &held_->before, nullptr); }

void EndSignals::wait() {
  int number = 0;
  while (sigwait(&held_->ends, &number) != 0) {
  }
}

void fill_with_random_bytes(std::span<unsigned char> bytes) {
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "getrandom");
}

/// The C++ library's own options for servers share a port.
void own_port_alone(std::uintptr_t socket) {
  const int yes = 1;
  setsockopt(static_cast<int>(socket), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace coif::platform
