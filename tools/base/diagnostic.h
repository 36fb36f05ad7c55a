#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif {

enum class Severity : std::uint8_t { kInfo, kWarning, kError };

[[nodiscard]] const char* name(Severity severity);

/// One finding about a file. Import, cook, validation and view all tell what they found in this form. The table of
/// codes (tools/validate) says what a code means and how to cure it; codes are stable, so that a recipe can acknowledge
/// one kind of warning.
struct Diagnostic {
  Diagnostic() = default;
  Diagnostic(std::string of_code, std::string text, Severity how = Severity::kWarning, std::string at = {});

  std::string code;     ///< "C144"
  std::string message;  ///< A sentence, without a trailing period or newline.
  Severity severity = Severity::kWarning;
  std::string place;                     ///< Chunk, record, bone, mesh or patch; empty: the whole file.
  std::optional<std::uint32_t> patch{};  ///< Number among all patches of the asset, where the finding is about one.

  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;

  /// "FILE: place: message [C144]", without file and place where they are empty or the message begins with them.
  [[nodiscard]] std::string text(const std::string& file) const;
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] std::vector<std::string> messages_of(const Diagnostics& diagnostics);

// A diagnostic is {"code", "severity", "message", "where"}, and "patch" where it is about one.

template <class Json>
void to_json(Json& out, const Diagnostic& diagnostic) {
  out = {{"code", diagnostic.code},
         {"severity", name(diagnostic.severity)},
         {"message", diagnostic.message},
         {"where", diagnostic.place}};
  if (diagnostic.patch) out["patch"] = *diagnostic.patch;
}

/// Throws nlohmann::json::exception where `in` is no diagnostic.
void from_json(const nlohmann::json& in, Diagnostic& diagnostic);

}  // namespace coif
