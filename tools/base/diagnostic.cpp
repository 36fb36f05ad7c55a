#include "base/diagnostic.h"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace coif {

const char* name(Severity severity) {
  constexpr const char* kNames[] = {"info", "warning", "error"};
  return kNames[std::size_t(severity)];
}

Diagnostic::Diagnostic(std::string of_code, std::string text, Severity how, std::string at)
    : code(std::move(of_code)), message(std::move(text)), severity(how), place(std::move(at)) {}

std::string Diagnostic::text(const std::string& file) const {
  const bool has_file = file.empty() || message.starts_with(file + ":");
  const bool has_place = place.empty() || message.starts_with(place);
  return fmt::format("{}{}{} [{}]", has_file ? "" : file + ": ", has_place ? "" : place + ": ", message, code);
}

std::vector<std::string> messages_of(const Diagnostics& diagnostics) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics) messages.push_back(diagnostic.message);
  return messages;
}

}  // namespace coif
