#pragma once

#include <string>
#include <string_view>

namespace coif {

/// What a command says to people, on the standard error: `coif cook: warning: braid.glb: ...`. Results go to the
/// standard output and never pass here.
class Messages {
 public:
  /// `verb`: the command's name; empty before one is known.
  explicit Messages(std::string_view verb);

  void error(std::string_view text) const;
  void warning(std::string_view text) const;
  void note(std::string_view text) const;

 private:
  void write(std::string_view severity, std::string_view text) const;

  std::string program_;
};

}  // namespace coif
