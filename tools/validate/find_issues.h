#pragma once

#include "base/tool_error.h"
#include "cook/cook.h"
#include "cook/recipe/recipe.h"
#include "import/source_model.h"
#include "validate/issue_codes.h"

#include <coif/asset.h>

namespace coif::validate {

/// Visible problems of an asset that opens without error: no errors, but worth an artist's look.
[[nodiscard]] Diagnostics find_asset_issues(const Asset& asset);

/// The reason why an asset was refused; `status` is that of a failed open().
[[nodiscard]] Diagnostic refusal_issue(const LoadStatus& status);

/// Whether an asset was cooked from the inputs that `now` describes: source and recipe by their hashes, tool and
/// importer by their versions; versions only where both hashes agree. Hashes do not cover texture files beside source
/// and recipe.
[[nodiscard]] Diagnostics find_origin_issues(const Asset& asset, const ProvenanceRecord& now);

/// Whether a cook by this version gives the same chunks; the tools' entries in PROV do not count.
[[nodiscard]] Diagnostics find_recook_issues(const Asset& asset, const Asset& cooked_anew);

/// Why a source could not be imported.
[[nodiscard]] Diagnostic import_issue(const ToolError& error);

/// The warnings of a cook.
[[nodiscard]] Diagnostics cook_issues(const cook::Findings& findings);

/// The problems that would stop a cook of an imported source or cause warnings, as far as its first passes show: which
/// triangles are hair, whether they form strips, and whether the file's unit and up axis are the model's.
[[nodiscard]] Diagnostics find_source_issues(const importer::SourceModel& imported, const cook::Recipe& recipe);

/// All problems that stopped `cooked`, a cook of that source, or caused warnings, and notes about the source.
[[nodiscard]] Diagnostics find_source_issues(const importer::SourceModel& imported, const cook::Recipe& recipe,
                                             const tl::expected<cook::CookResult, ToolError>& cooked);

}  // namespace coif::validate
