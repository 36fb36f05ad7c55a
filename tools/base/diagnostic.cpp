#include "base/diagnostic.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

void from_json(const nlohmann::json& in, Diagnostic& diagnostic) {
  in.at("code").get_to(diagnostic.code);
  in.at("message").get_to(diagnostic.message);
  in.at("where").get_to(diagnostic.place);
  const auto& word = in.at("severity").get_ref<const std::string&>();
  diagnostic.severity = word == name(Severity::kError)     ? Severity::kError
                        : word == name(Severity::kWarning) ? Severity::kWarning
                                                           : Severity::kInfo;
  if (in.contains("patch")) diagnostic.patch = in.at("patch").get<std::uint32_t>();
}

}  // namespace coif
