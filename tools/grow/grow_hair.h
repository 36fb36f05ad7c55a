#pragma once

#include "base/tool_error.h"
#include "cook/recipe/hair_style.h"
#include "cook/recipe/recipe.h"
#include "groom/groom.h"
#include "import/import.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace coif::grow {

/// The body that hair grows on.
struct GrowGround {
  /// Any triangles in metres, Y up, with the head on top; those with hair names do not count.
  const importer::SourceModel& body;
  /// The skull's. None: it is found at the body's top.
  std::optional<std::array<double, 3>> head_center, head_radii;
};

/// The sample's bust, looking along +Z.
[[nodiscard]] importer::SourceModel sample_body();

/// Grows strands, root first, with widths and colours, on the head and clear of the skin. `name` is the file's in
/// messages. Repeats for equal input, with any `threads`. Errors (kBadInput): no head is found, or the hairline leaves
/// no room for a strand; kOverBudget: more points than a groom may have.
[[nodiscard]] tl::expected<groom::Groom, ToolError> grow_hair(const cook::HairStyle& style, const GrowGround& ground,
                                                              const std::string& name,
                                                              const platform::Threads& threads);

/// Reads a model with the head and body of the hair; the sample's bust where `path` is empty. Errors: those of
/// import_model().
[[nodiscard]] tl::expected<importer::SourceModel, ToolError> read_body(const std::filesystem::path& path,
                                                                       const importer::ImportSettings& settings);

/// Grows the hair of a recipe on a body, with the recipe's head. Errors: those of grow_hair().
[[nodiscard]] tl::expected<groom::Groom, ToolError> grow_from(const cook::Recipe& recipe,
                                                              const importer::SourceModel& body,
                                                              const std::string& name,
                                                              const platform::Threads& threads);

}  // namespace coif::grow
