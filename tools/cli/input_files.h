#pragma once

#include "base/asset_refusal.h"
#include "base/files.h"
#include "base/tool_error.h"
#include "cli/messages.h"
#include "cook/cook.h"
#include "cook/recipe/recipe.h"
#include "import/import.h"
#include "import/source_model.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cli {

/// An open asset together with the memory it looks into. Moving it leaves the asset's spans valid.
class AssetFile {
 public:
  /// Errors: those of FileBytes::read(); kBadInput or kUnsupported (another format version) where the reader refuses
  /// the file, with its evidence.
  static tl::expected<AssetFile, ToolError> open(const std::filesystem::path& path);
  /// Bytes that are in hand already; the path is for messages.
  static tl::expected<AssetFile, ToolError> open(const std::filesystem::path& path, FileBytes bytes);

  [[nodiscard]] const Asset& asset() const { return asset_; }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_.span(); }

 private:
  explicit AssetFile(FileBytes bytes) : bytes_(std::move(bytes)) {}

  FileBytes bytes_;
  Asset asset_;
};

/// A file is taken for a source only by a suffix that the importer knows, or as a recipe by which hair grows;
/// everything else should be an asset.
[[nodiscard]] bool is_source(const std::filesystem::path& path, std::span<const std::byte> bytes);

struct RecipeChoice {
  cook::Recipe recipe;
  std::filesystem::path directory;  ///< The folder of its texture paths: the recipe's, else the source's.
  std::filesystem::path file;       ///< Empty: the defaults, no file.
  bool is_found = false;            ///< It lies beside the source and nobody named it, so it has the source's author.
};

/// Chooses a recipe: the source itself if it is one; the one named on the command line; else SOURCE-stem.recipe.json
/// beside the source, with a note; else the defaults. An empty `source` has no recipe beside it. Each starts from
/// `beginning`.
tl::expected<RecipeChoice, ToolError> choose_recipe(const std::filesystem::path& source,
                                                    const std::optional<std::string>& named, const Messages& messages,
                                                    const cook::RecipeBeginning& beginning = {});

/// For hosts that take sources from strangers (--require-sandbox): checks that the files named by a recipe beside its
/// source really lie in its folder or in one of the `roots`. A recipe from the command line is the caller's own and may
/// name any file. Error: kBadInput.
[[nodiscard]] tl::expected<void, ToolError> check_named_files(const RecipeChoice& choice,
                                                              std::span<const std::filesystem::path> roots);

/// choose_recipe(), and check_named_files() where that `is_asked` for.
tl::expected<RecipeChoice, ToolError> held_recipe(const std::filesystem::path& source,
                                                  const std::optional<std::string>& named, bool is_asked,
                                                  std::span<const std::filesystem::path> roots,
                                                  const Messages& messages,
                                                  const cook::RecipeBeginning& beginning = {});

/// The files that the choice's recipe names, and the recipe's own; no output may overwrite them.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const RecipeChoice& choice);
/// These files, and those that a cook with the recipe read or named.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const RecipeChoice& choice, const cook::CookInputs& inputs);
/// The files that a model was read from and that it names.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const importer::SourceModel& model);

/// Puts a body named on the command line in place of the recipe's; nothing where `body` is empty.
void choose_body(const std::filesystem::path& body, RecipeChoice& choice);

/// The recipe's settings for reading the source, and ImportSettings::roots.
[[nodiscard]] importer::ImportSettings import_settings(const cook::Recipe& recipe,
                                                       std::vector<std::filesystem::path> roots);

}  // namespace coif::cli
