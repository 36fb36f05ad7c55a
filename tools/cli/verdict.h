#pragma once

#include "cli/issue_pictures.h"
#include "validate/issue_policy.h"

#include <string>
#include <vector>

namespace coif {

/// What `coif validate` found out about one file.
struct Verdict {
  std::string path;
  bool readable = true;
  JudgedIssues issues;
  IssuePictures pictures;  ///< Where a page was asked for.
};

/// "valid", "invalid" or "unreadable".
[[nodiscard]] const char* verdict_word(const Verdict& verdict);

/// The result as JSON; its keys are stable, and tools/validate/verdicts.schema.json describes them.
[[nodiscard]] std::string verdicts_json(const std::vector<Verdict>& verdicts);

/// One line per file.
[[nodiscard]] std::string verdicts_text(const std::vector<Verdict>& verdicts);

}  // namespace coif
