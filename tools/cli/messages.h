#pragma once

#include "base/diagnostic.h"

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace coif::cli {

/// A command's messages for people, on standard error: `coif cook: warning: braid.glb: ...`. Results go to standard
/// output instead.
class Messages {
 public:
  /// `verb`: the command's name; empty before one is known.
  explicit Messages(std::string_view verb);

  void error(std::string_view text) const;
  void warning(std::string_view text) const;
  void note(std::string_view text) const;

  /// Each as an error, a warning or a note by its severity: "FILE: place: message [CODE]".
  void tell(const Diagnostics& diagnostics, const std::string& file) const;
  /// One line of that severity.
  void tell(Severity severity, std::string_view text) const;

  /// The same without notes.
  [[nodiscard]] Messages without_notes() const;

 private:
  void write(std::string_view severity, std::string_view text) const;

  std::string program_;
  bool tells_notes_ = true;
};

/// The program's present work, on one line of a terminal that is overwritten and erased at the end. Writes nothing
/// where the stream is not a terminal, so logs and pipes get messages only.
class ProgressLine {
 public:
  /// `what`: the subject of the work, for example the file. The stream must outlive this object.
  explicit ProgressLine(std::string what, std::FILE* stream = stderr);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Replaces the line by `what`, `step` and the seconds so far.
  void show(const char* step);

  /// Erases the line, before something else is written.
  void erase();

 private:
  std::string what_;
  std::FILE* stream_;  ///< Null where nobody watches.
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Writing to standard output.

void print_result(std::string_view text);

/// The third-party works in the program, and their licences. Made by third_party.cmake.
extern const char* const kThirdPartyNotices;

}  // namespace coif::cli
