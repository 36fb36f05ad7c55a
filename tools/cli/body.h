#pragma once

#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"
#include "cook/recipe/findings.h"
#include "import/source_model.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coif::cli {

/// Where the rest of a model is: what is not hair.
struct BodyOptions {
  std::string file;
  std::string mesh;  ///< Pattern of the meshes that are drawn; empty: all.
  std::optional<std::string> recipe;
  std::vector<std::filesystem::path> roots;
  SourceLimits limits;
};

struct Body {
  importer::SourceModel model;               ///< Without meshes if the file has only the hair's own.
  std::vector<std::filesystem::path> files;  ///< The file it was read from, and the files that this one names.
  cook::Findings findings;                   ///< What its size is, and warnings of it.
};

/// Reads what is drawn with an asset's hair, in the asset's size. Where the asset was cooked from this very file, its
/// hair is left out. Errors: those of the import; a pattern that matches nothing.
tl::expected<Body, ToolError> read_body(const BodyOptions& options, const Asset& asset, const Messages& messages);

/// The same of a model that was read before, with the recipe of its cook.
tl::expected<Body, ToolError> body_of(importer::SourceModel model, const BodyOptions& options,
                                      const RecipeChoice& choice, const Asset& asset);

}  // namespace coif::cli
