#pragma once

#include <string>
#include <vector>

namespace coif {

enum class Severity { kInfo, kWarning, kError };

/// One finding of `coif validate`. Codes are stable: a build may let some pass by number.
///   F1xx files            F101 cannot be opened or read
///   A1xx unsafe assets    A100 + the number of the reader's LoadCode
///   A2xx doubtful assets  see asset_issues.cpp
///   S1xx sources          S101 cannot be imported, S102 format or variant not supported, S201 warning of the import
struct Issue {
  std::string code;
  Severity severity = Severity::kError;
  std::string message;
  std::string where;  ///< Chunk, record or bone; empty: the whole file.
};

[[nodiscard]] const char* name(Severity severity);

}  // namespace coif
