#pragma once

#include "base/tool_error.h"
#include "cook/recipe/recipe.h"
#include "groom/groom.h"
#include "import/import.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace coif::cards {

/// Everything besides the source's own bytes that decides with which model a cook begins.
struct HairSourceSettings {
  importer::ImportSettings import;         ///< Unit and axis are those of the source.
  std::filesystem::path recipe_directory;  ///< CookSettings::recipe_directory.
  platform::Threads threads = 1;           ///< The model does not depend on it.
  /// Called before each part of the work with its name, "import" or "cards". May be empty, and may throw.
  std::function<void(const char* part)> progress{};
};

/// The model that a cook begins with. An artist's strips: as import_model() reads them. Strands become cards: those of
/// a .hair or .tfx, and of an .obj or glTF whose hair is lines (it has no triangles, or some dozens of lines and no
/// mesh called hair; its meshes are then the body). A recipe as source (is_recipe_file()): cards of hair that is grown
/// by it. With strands comes the body that the recipe names. Errors: those of import_model(), read_groom(), grow_from()
/// and model_of_cards(). Blocks; costs a fork or two, so call it before starting threads if possible.
[[nodiscard]] tl::expected<importer::SourceModel, ToolError> read_hair_source(const std::filesystem::path& path,
                                                                              const cook::Recipe& recipe,
                                                                              const HairSourceSettings& settings);

/// The recipe's values that read_hair_source() uses: with other values it gives another model.
[[nodiscard]] std::string source_values(const cook::Recipe& recipe);

/// The file's strands as guides, each followed by `count` others beside it, with its width and colours. They begin
/// within `radius` metres of its root, across its first segment, and keep that offset, which doubles towards the tip.
/// Source: AMD, TressFX, TressFXAsset::GenerateFollowHairs(), with a tip separation of 1. `radius` 0: the distance
/// between guides' roots. Changes nothing if `count` is 0. kOverBudget: more strands than a groom may have.
[[nodiscard]] tl::expected<groom::Groom, ToolError> with_follow_hairs(groom::Groom guides, std::uint32_t count,
                                                                      float radius);

// The head and body that strands belong to, which come in a file of their own.

/// Strands and body are in metres with Y up as their files say, and one of the files may say nothing, or what its
/// exporter always says. Where roots do not lie on the body, but would if the strands' file were of another usual unit
/// or up axis, the strands are turned and scaled so, with a warning; where none fits, the warning says how far off they
/// are. What the recipe gives stays as it is.
void place_on_body(const importer::SourceModel& body, groom::Groom& groom);

/// Adds the body's nodes and meshes to a model of cards, without its hair, springs and textures. The cards hang from
/// its head: the node with that name, else a new one at the skull, which everything above the chin follows. Warns if
/// neither is found.
void add_body(importer::SourceModel body, importer::SourceModel& cards);

}  // namespace coif::cards
