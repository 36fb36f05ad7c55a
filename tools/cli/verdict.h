#pragma once

#include "base/tool_error.h"
#include "cli/messages.h"
#include "validate/issue_codes.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cli {

struct IssuePicture {
  std::uint32_t patch = 0;
  std::vector<std::uint8_t> png;
};

struct IssuePictures {
  std::vector<IssuePicture> pictures;  ///< One picture for each patch with an issue; the first dozen.
  std::string why_none;                ///< Set where nothing can be drawn here.
};

/// Draws every patch that `issues` name, red among grey ones, seen from its own side.
[[nodiscard]] IssuePictures picture_issues(const Asset& asset, std::span<const Diagnostic> issues);

/// The findings of `coif validate` about one file.
struct Verdict {
  std::string path;
  bool readable = true;
  validate::JudgedIssues issues;
  IssuePictures pictures;  ///< Filled where a page was requested.
};

/// The result as JSON; its keys are stable, and tools/validate/verdicts.schema.json describes them.
[[nodiscard]] std::string verdicts_json(const std::vector<Verdict>& verdicts);

/// One line per file.
[[nodiscard]] std::string verdicts_text(const std::vector<Verdict>& verdicts);

/// All verdicts as one HTML document: a table of each file's issues with their meanings and cures, and its pictures.
[[nodiscard]] std::string verdict_page(std::span<const Verdict> verdicts);

}  // namespace coif::cli
