#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>

namespace coif::platform {

/// The file of the running program; empty where the system does not say.
[[nodiscard]] std::filesystem::path program_path();

/// The system's number of this process.
[[nodiscard]] std::uint64_t process_number();

/// Whether somebody reads the stream at a terminal.
[[nodiscard]] bool is_terminal(std::FILE* stream);

/// Opens missing standard streams, so that files that are opened later do not take their places: messages would be
/// written into them. Writing to such a stream fails as before.
void fill_standard_streams();

/// A failed write becomes an error at its place, and does not end the program with half a file left behind.
void ignore_signals_of_writing();

/// Holds back the signals that end the program (SIGINT, SIGTERM, SIGHUP), in this thread and those that it starts,
/// until somebody waits for them. The program ignores closed pipes from then on.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// Blocks until one arrives.
  void wait();

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

/// Fills it with bytes that nobody can guess. Throws std::system_error where the system has none.
void fill_with_random_bytes(std::span<unsigned char> bytes);

/// Keeps other programs from listening at the same port. `socket`: the system's handle of a socket that is not bound
/// yet.
void own_port_alone(std::uintptr_t socket);

}  // namespace coif::platform
