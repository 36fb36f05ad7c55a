#pragma once

#include "cli/cook_job.h"
#include "cli/source_limits.h"
#include "cook/cook.h"
#include "import/import.h"
#include "platform/job.h"
#include "validate/issue_codes.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace coif::cli {

/// The work of a child process on a source.
struct CookOrder {
  std::string source;
  cook::Recipe recipe;
  std::filesystem::path recipe_directory{};  ///< CookSettings::recipe_directory.
  importer::ImportSettings import{};
  std::uint64_t source_hash = 0;  ///< CookSettings::source_hash.
  unsigned threads = 1;
  bool draft = false;         ///< CookSettings::draft.
  bool list_patches = false;  ///< CookSettings::list_patches.
  bool cooks = true;          ///< false: the source is read, and that is all.
  bool keeps_model = false;   ///< The answer brings the model along.
  bool finds_issues = false;  ///< The answer includes the issues that `coif validate` has for the source and its cook.
  platform::Bytes model{};    ///< CookAnswer::model of an earlier answer about this source, which is not read then.
};

struct CookAnswer {
  cook::CookResult result;        ///< Passes include the import. Empty unless CookOrder::cooks.
  ProvenanceRecord provenance{};  ///< The provenance of an asset cooked from this source with this recipe.
  Diagnostics issues;             ///< Filled if CookOrder::finds_issues is set.
  platform::Bytes model;          ///< For decode_model(); filled if CookOrder::keeps_model is set.
};

/// Reads and cooks a source in a child process that keeps the limits of `call`. Errors: those of read_hair_source(),
/// cook() and run_within_limits(), with the issues of a failed cook. Throws Stopped, after the child has ended, where
/// the token of `call` is requested.
tl::expected<CookAnswer, FailedCook> cook_in_child(const CookOrder& order, const LimitedCall& call);

}  // namespace coif::cli
