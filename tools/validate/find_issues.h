#pragma once

#include "base/tool_error.h"
#include "cook/cook.h"
#include "cook/recipe/recipe.h"
#include "import/source_model.h"
#include "validate/issue_codes.h"

#include <coif/asset.h>

namespace coif::validate {

/// What an asset that opens without error still does badly on screen: no error, but worth an artist's look.
[[nodiscard]] Diagnostics find_asset_issues(const Asset& asset);

/// Why an asset was refused; `status` is that of a failed open().
[[nodiscard]] Diagnostic refusal_issue(const LoadStatus& status);

/// Whether an asset was cooked from what `now` describes: source and recipe by their hashes, tool and importer by their
/// versions; versions only where both hashes agree. Hashes do not cover texture files beside source and recipe.
[[nodiscard]] Diagnostics find_origin_issues(const Asset& asset, const ProvenanceRecord& now);

/// Whether a cook of today gives the same chunks; what PROV says of the tools does not count.
[[nodiscard]] Diagnostics find_recook_issues(const Asset& asset, const Asset& cooked_anew);

/// Why a source could not be imported.
[[nodiscard]] Diagnostic import_issue(const ToolError& error);

/// What a cook warned of.
[[nodiscard]] Diagnostics cook_issues(const cook::Findings& findings);

/// What a cook of an imported source would stop at or warn of, as far as its first passes tell: which triangles are
/// hair, whether they fall into strips, and whether unit and up axis of the file are the model's.
[[nodiscard]] Diagnostics find_source_issues(const importer::SourceModel& imported, const cook::Recipe& recipe);

/// All that `cooked`, a cook of that source, stopped at or warned of, and what is worth knowing of the source.
[[nodiscard]] Diagnostics find_source_issues(const importer::SourceModel& imported, const cook::Recipe& recipe,
                                             const tl::expected<cook::CookResult, ToolError>& cooked);

}  // namespace coif::validate
