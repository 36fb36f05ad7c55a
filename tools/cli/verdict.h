#pragma once

#include "cli/issue.h"

#include <string>
#include <vector>

namespace coif {

/// What `coif validate` found out about one file.
struct Verdict {
  std::string path;
  bool readable = true;
  std::vector<Issue> issues;

  /// True without an issue of severity error.
  [[nodiscard]] bool valid() const;
};

/// The result as JSON; the keys are stable.
[[nodiscard]] std::string verdicts_json(const std::vector<Verdict>& verdicts);

/// One line per file.
[[nodiscard]] std::string verdicts_text(const std::vector<Verdict>& verdicts);

}  // namespace coif
