#include "cli/messages.h"

#include <fmt/format.h>

#include <cstdio>

namespace coif {

Messages::Messages(std::string_view verb) : program_(verb.empty() ? "coif" : fmt::format("coif {}", verb)) {}

void Messages::error(std::string_view text) const { write("error", text); }
void Messages::warning(std::string_view text) const { write("warning", text); }
void Messages::note(std::string_view text) const { write("note", text); }

void Messages::write(std::string_view severity, std::string_view text) const {
  fmt::print(stderr, "{}: {}: {}\n", program_, severity, text);
}

}  // namespace coif
